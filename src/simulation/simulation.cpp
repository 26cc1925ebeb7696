#include "simulation/simulation.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "place_recognition/error.h"
#include "simulation/building.h"
#include "simulation/camera.h"
#include "simulation/furnishing.h"
#include "simulation/lighting.h"
#include "simulation/omni_renderer.h"
#include "simulation/path.h"
#include "simulation/renderer.h"

namespace place_recognition {
namespace {

using namespace simulation;

/// Number of frames rendered at a time, whatever the number of threads.
constexpr std::size_t kBatch = 8;

/// Deviation of the robot from its path on a later visit, m.
constexpr float kStray = 0.1f;

constexpr unsigned kMaxVisits = 1000;
constexpr unsigned kMaxFloors = 1000;

/// From the last frame of a floor to the first of the next, s.
constexpr double kLiftTime = 10.0;

/// Cameras by name, and the angle by which each is turned to the left, rad.
constexpr std::pair<const char*, float> kMounts[] = {
    {"front", 0.0f}, {"left", 1.5707963f}, {"rear", 3.1415927f}, {"right", -1.5707963f}};

enum Stream : std::uint64_t {
  kFurnitureStream = 1000,
  kChangesStream = 2000,
  kPathStream = 3000,
  kNoiseStream = 4000
};

/// The generator for what differs between conditions and visits.
Random randomOf(const SimulationOptions& options, std::uint64_t stream) {
  const auto condition = static_cast<std::uint64_t>(options.condition);
  return Random(options.seed, stream + condition + 10000 * (options.visit - 1));
}

/// Builds and furnishes the scene; returns the poses of the camera.
std::vector<Pose> prepare(const SimulationOptions& options, Scene& scene) {
  const Palette palette = makePalette(scene, options.seed, options.condition);
  addShell(scene, palette);
  Furniture furniture(scene, palette, Random(options.seed, kFurnitureStream));
  furnish(furniture);

  const std::vector<Marker> crosses = markers(furniture.footprints);
  std::vector<cv::Point2f> keep_clear = driveWay();
  for (const Marker& marker : crosses) keep_clear.push_back(marker.at);
  furniture.random() = randomOf(options, kChangesStream);
  addChanges(furniture, options.condition, keep_clear);

  const Random jitter = randomOf(options, kPathStream);
  const float stray = options.visit > 1 ? kStray : 0.0f;
  return options.protocol == Protocol::kIndecs ? tripodRun(crosses, options.rate, jitter)
                                               : driveRun(options.rate, stray, jitter);
}

/// The index of a camera in kMounts; throws Error if there is none with this name.
std::size_t mountOf(const std::string& camera) {
  const auto found = std::find_if(std::begin(kMounts), std::end(kMounts),
                                  [&camera](const auto& mount) { return camera == mount.first; });
  if (found != std::end(kMounts)) return static_cast<std::size_t>(found - std::begin(kMounts));
  throw Error("Unknown camera '" + camera + "'; choose front, left, rear or right.");
}

using Render = std::function<cv::Mat(const View& view)>;

/// The renderer for the camera in the options; it keeps references to its arguments.
Render renderOf(const SimulationOptions& options, const Scene& scene, const RayTracer& tracer,
                const Lighting& lighting) {
  if (options.omnidirectional) {
    return [camera = std::make_shared<const OmniRenderer>(scene, tracer, lighting, options.size)](
               const View& view) { return camera->render(view); };
  }
  const float focal = focalLength(options.size.width);
  return [camera = std::make_shared<const Renderer>(scene, tracer, lighting, options.size, focal)](
             const View& view) { return camera->render(view); };
}

SimulatedFrame frameOf(const Pose& pose, const std::string& camera) {
  SimulatedFrame frame;
  frame.camera = camera;
  frame.room = pose.room;
  frame.name = pose.name;
  frame.stamp = pose.stamp;
  frame.x = pose.view.eye[0];
  frame.y = pose.view.eye[1];
  frame.yaw = pose.view.yaw;
  return frame;
}

void simulateFloor(const SimulationOptions& options, const FrameSink& sink) {
  Scene scene;
  const std::vector<Pose> poses = prepare(options, scene);
  const RayTracer tracer(scene);
  // A light grid finer than the image's resolution would be wasted.
  const float spacing = 0.12f * std::max(1.0f, 512.0f / static_cast<float>(options.size.width));
  const Lighting lighting(scene, tracer, daylight(options.condition), spacing, options.threads);
  const Render render = renderOf(options, scene, tracer, lighting);

  const std::uint64_t noise_seed = randomOf(options, kNoiseStream).next();
  const std::vector<std::string> cameras =
      options.cameras.empty() ? std::vector<std::string>{""} : options.cameras;
  const std::size_t frames = poses.size() * cameras.size();
  std::vector<SimulatedFrame> batch(kBatch);
  for (std::size_t start = 0; start < frames; start += kBatch) {
    const std::size_t count = std::min(kBatch, frames - start);
    parallelFor(count, options.threads, [&](std::size_t i, unsigned) {
      const std::size_t number = (start + i) / cameras.size();
      const std::string& camera = cameras[(start + i) % cameras.size()];
      const std::size_t mount = camera.empty() ? 0 : mountOf(camera);
      const View view = turned(poses[number].view, kMounts[mount].second);
      batch[i] = frameOf(poses[number], camera);
      batch[i].image = develop(render(view), Random(noise_seed + mount, number));
    });
    for (std::size_t i = 0; i < count; ++i) {
      if (!sink(batch[i], start + i, frames)) return;
    }
  }
}

}  // namespace

const char* name(Condition condition) {
  switch (condition) {
    case Condition::kNight:
      return "night";
    case Condition::kSunny:
      return "sunny";
    case Condition::kCloudy:
      break;
  }
  return "cloudy";
}

Condition conditionFromName(const std::string& text) {
  for (const Condition condition : {Condition::kCloudy, Condition::kNight, Condition::kSunny}) {
    if (text == name(condition)) return condition;
  }
  throw Error("Unknown condition '" + text + "'; choose cloudy, night or sunny.");
}

const char* name(Protocol protocol) { return protocol == Protocol::kDrive ? "drive" : "indecs"; }

Protocol protocolFromName(const std::string& text) {
  for (const Protocol protocol : {Protocol::kIndecs, Protocol::kDrive}) {
    if (text == name(protocol)) return protocol;
  }
  throw Error("Unknown protocol '" + text + "'; choose indecs or drive.");
}

void SimulationOptions::check() const {
  if (std::min(size.width, size.height) < 16 || std::max(size.width, size.height) > 4096) {
    throw Error("Simulation size " + std::to_string(size.width) + "x" +
                std::to_string(size.height) + " is out of range; give sides of 16 to 4096 pixels.");
  }
  if (visit < 1 || visit > kMaxVisits) {
    throw Error("Simulation visit " + std::to_string(visit) + " is out of range; give 1 to 1000.");
  }
  if (floors < 1 || floors > kMaxFloors) {
    throw Error("Simulation floors " + std::to_string(floors) +
                " is out of range; give 1 to 1000.");
  }
  if (!(rate >= 0.1 && rate <= 100.0)) {
    throw Error("Simulation rate " + std::to_string(rate) +
                " is out of range; give 0.1 to 100 frames per second.");
  }
  for (auto camera = cameras.begin(); camera != cameras.end(); ++camera) {
    mountOf(*camera);
    if (std::find(cameras.begin(), camera, *camera) == camera) continue;
    throw Error("Camera '" + *camera + "' is named twice; name each only once.");
  }
}

void simulate(const SimulationOptions& options, const FrameSink& sink) {
  options.check();
  if (options.floors == 1) {
    simulateFloor(options, sink);
    return;
  }
  SimulationOptions floor = options;
  double start = 0.0;
  bool goes_on = true;
  for (unsigned below = 0; below < options.floors && goes_on; ++below, ++floor.seed) {
    const std::string prefix = "floor" + std::to_string(below + 1) + "_";
    double last = start;
    simulateFloor(floor, [&](SimulatedFrame frame, std::size_t index, std::size_t count) {
      frame.room = prefix + frame.room;
      frame.name = prefix + frame.name;
      frame.stamp = last = start + frame.stamp;
      goes_on = sink(frame, below * count + index, options.floors * count);
      return goes_on;
    });
    start = last + kLiftTime;
  }
}

}  // namespace place_recognition
