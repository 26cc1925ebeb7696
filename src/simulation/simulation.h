#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace place_recognition {

/// The light in which a run is recorded (thesis, section 3.4).
enum class Condition { kCloudy, kNight, kSunny };

/// How the camera moves: on a tripod between markers (thesis, section 3.2) or on a driving robot.
enum class Protocol { kIndecs, kDrive };

/// "cloudy", "night", "sunny"; throws Error on anything else.
Condition conditionFromName(const std::string& name);
const char* name(Condition condition);

/// "indecs", "drive"; throws Error on anything else.
Protocol protocolFromName(const std::string& name);
const char* name(Protocol protocol);

struct SimulationOptions {
  Condition condition = Condition::kCloudy;
  Protocol protocol = Protocol::kIndecs;
  /// Determines the building: its colours, materials, posters and books. Together with the
  /// condition it determines what has been moved. The same options and build give the same pixels,
  /// whatever the number of threads.
  std::uint64_t seed = 1;
  /// 1..1000. Determines what has been moved, who walks about and, except for the first visit, how
  /// the robot deviates from its path.
  unsigned visit = 1;
  /// 1..1000. If there are several, floor N (from 1) is the building of seed `seed` + N - 1, and
  /// its rooms and frames are named floorN_kitchen and so on. The robot takes a lift to the next
  /// floor.
  unsigned floors = 1;
  cv::Size size{512, 384};  ///< pixels, each side 16..4096
  unsigned threads = 0;     ///< 0: one per core
  double rate = 5.0;        ///< frames per second (0.1..100); indecs: one image every 1/rate s
  /// Cameras of the robot, all at one point: front, left, rear, right, by viewing direction, each
  /// at most once. Each takes an image at every stamp. Empty: one unnamed camera that looks ahead.
  std::vector<std::string> cameras;
  /// The camera looks up into a mirror and thus in all directions (OmniRenderer).
  bool omnidirectional = false;

  /// Throws Error naming the field that is out of range.
  void check() const;
};

/// One labelled image of a run.
struct SimulatedFrame {
  cv::Mat image;       ///< CV_8UC3, BGR
  std::string camera;  ///< as in SimulationOptions::cameras; empty: the only one
  std::string room;    ///< the room the camera stands in
  std::string name;    ///< file stem: kitchen_07_120 (room, marker, degrees) or drive_000123
  double stamp = 0.0;  ///< s since the start of the run
  double x = 0.0;      ///< m, along the corridor
  double y = 0.0;      ///< m, to the left of x
  double yaw = 0.0;    ///< rad, anticlockwise from x; the robot's viewing direction
};

/// Receives frame `index` of `count`, an estimate if there are several floors; returns false to
/// stop the run.
using FrameSink =
    std::function<bool(const SimulatedFrame& frame, std::size_t index, std::size_t count)>;

/// Renders a run of five rooms (office_a, office_b, kitchen, corridor, printer_area) and passes
/// each frame to `sink` in order of time, then of cameras, from the calling thread. Throws Error
/// for invalid options, and whatever the sink throws.
void simulate(const SimulationOptions& options, const FrameSink& sink);

}  // namespace place_recognition
