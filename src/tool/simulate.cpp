#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <opencv2/imgcodecs.hpp>
#include <set>
#include <vector>

#include "base/atomic_file.h"
#include "base/text.h"
#include "ros/bags/bag_file.h"
#include "ros/bags/labelled_bag_writer.h"
#include "simulation/simulation.h"
#include "tool/output.h"
#include "tool/staged_folder.h"
#include "tool/verbs.h"

namespace place_recognition::tool {
namespace {

namespace fs = std::filesystem;

struct SimulateOptions {
  std::string out;
  std::vector<std::string> conditions = {"cloudy", "night", "sunny"};
  std::string protocol = "indecs";
  std::string format = "bag";
  std::string size = "512x384";
  std::string camera = "perspective";
  SimulationOptions simulation;
  OutputOptions output;
};

cv::Size parseSize(const std::string& text) {
  cv::Size size;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%dx%d%c", &size.width, &size.height, &rest) != 2) {
    throw UsageError("--size: '" + text + "' is not of the form 512x384");
  }
  return size;
}

/// Number of images of each room.
using Counts = std::map<std::string, int>;

Counts renderBag(const SimulationOptions& options, const std::string& path,
                 const Progress& progress) {
  Counts counts;
  LabelledBagWriter bag(path);
  simulate(options, [&](const SimulatedFrame& frame, std::size_t index, std::size_t count) {
    report(progress, "Rendering " + path, static_cast<double>(index) / count);
    bag.write(frame.image, frame.room, frame.stamp, frame.camera);
    ++counts[frame.room];
    return true;
  });
  bag.close();
  return counts;
}

Counts renderFolder(const SimulationOptions& options, const std::string& path,
                    const Progress& progress) {
  Counts counts;
  StagedFolder folder(path);
  simulate(options, [&](const SimulatedFrame& frame, std::size_t index, std::size_t count) {
    report(progress, "Rendering " + path, static_cast<double>(index) / count);
    const fs::path room = folder.path() / frame.room;
    fs::create_directories(room);
    std::vector<unsigned char> png;
    cv::imencode(".png", frame.image, png);
    const std::string camera = frame.camera.empty() ? "" : "_" + frame.camera;
    writeFileAtomically(room / (frame.name + camera + ".png"),
                        {reinterpret_cast<const char*>(png.data()), png.size()});
    ++counts[frame.room];
    return true;
  });
  folder.commit();
  return counts;
}

void simulateRuns(SimulateOptions options) {
  const bool as_bag = options.format == "bag";
  options.simulation.protocol = protocolFromName(options.protocol);
  options.simulation.size = parseSize(options.size);
  options.simulation.omnidirectional = options.camera == "omni";
  options.simulation.check();
  const std::set<std::string> conditions(options.conditions.begin(), options.conditions.end());
  if (conditions.size() < options.conditions.size()) {
    throw UsageError("--conditions: a light is given twice");
  }
  const auto runPath = [&](const std::string& condition) {
    return options.out + "/" + condition + (as_bag ? ".bag" : "");
  };
  for (const std::string& condition : conditions) {
    if (as_bag) requireNoLabelsBeside(runPath(condition));
  }
  ProgressDisplay display(options.output.progress);
  Json recordings = Json::array();
  const NewFolder folder(options.out);
  for (const std::string& condition : conditions) {
    options.simulation.condition = conditionFromName(condition);
    const std::string path = runPath(condition);
    const bool replaces = fs::exists(path);
    const auto render = as_bag ? renderBag : renderFolder;
    const Counts counts = render(options.simulation, path, display.callback());
    std::uint64_t images = 0;
    for (const auto& [room, count] : counts) images += static_cast<std::uint64_t>(count);
    display.clear();
    if (replaces) std::cerr << "note: " << path << " existed and was replaced.\n";
    options.output.text() << path << ": " << counted(images, "image") << " of "
                          << counted(counts.size(), "room") << std::endl;
    recordings.push_back(
        {{"path", path}, {"condition", condition}, {"images", images}, {"rooms", counts}});
  }
  options.output.writeJson({{"runs", recordings}});
}

}  // namespace

void addSimulate(CommandLine& tool) {
  Verb& verb = tool.verb("simulate", "Renders labelled runs of five rooms, one for each light");
  const auto options = std::make_shared<SimulateOptions>();
  verb.option("--out", "DIR", options->out, "Folder for the runs").required();
  verb.option("--conditions", "LIST", options->conditions,
              "Lights, one run each: cloudy, night, sunny (default all)")
      .commaSeparated()
      .oneOf({"cloudy", "night", "sunny"});
  verb.option("--protocol", "NAME", options->protocol,
              "indecs: markers with twelve angles each; drive: a path through the rooms")
      .oneOf({"indecs", "drive"});
  verb.option("--seed", "N", options->simulation.seed,
              "Selects the building; the same seed gives the same pixels");
  verb.option("--visit", "N", options->simulation.visit,
              "Day of the visit, from 1 (default): on each day other things are moved");
  verb.option("--floors", "N", options->simulation.floors,
              "Floors of the building, each with five rooms of its own, as floor2_kitchen");
  verb.option("--format", "NAME", options->format,
              "bag: DIR/cloudy.bag; images: DIR/cloudy/ROOM/NAME.png")
      .oneOf({"bag", "images"});
  verb.option("--rate", "HZ", options->simulation.rate, "Frames per second");
  verb.option("--size", "WxH", options->size, "Pixels (default 512x384)");
  verb.option("--camera", "NAME", options->camera,
              "perspective; omni: the camera looks up into a mirror and sees all around")
      .oneOf({"perspective", "omni"});
  verb.option("--cameras", "LIST", options->simulation.cameras,
              "Cameras of the robot, front,left,rear,right, each on its own topic "
              "/CAMERA/image_raw (default: one camera that looks ahead, on /camera/image_raw)")
      .commaSeparated()
      .oneOf({"front", "left", "rear", "right"});
  options->output.addTo(verb);
  verb.footer(
      "Example:\n"
      "  place_tool simulate --out runs --conditions cloudy,night\n"
      "  place_tool simulate --out drives --protocol drive --cameras front,rear");
  verb.run([options] { simulateRuns(*options); });
}

}  // namespace place_recognition::tool
