#include "tool/inputs.h"

#include <algorithm>
#include <filesystem>

#include "place_recognition/error.h"
#include "recognition/image_file.h"

namespace place_recognition::tool {
namespace {

namespace fs = std::filesystem;

std::string extension(const std::string& path) {
  std::string text = fs::path(path).extension().string();
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::vector<std::string> children(const std::string& folder) {
  std::vector<std::string> paths;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    paths.push_back(entry.path().string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

bool holdsPicture(const std::string& folder) {
  const fs::directory_iterator entries(folder);
  return std::any_of(begin(entries), end(entries),
                     [](const auto& entry) { return isPicture(entry.path().string()); });
}

/// A folder of `room/picture`, or of pictures without labels.
bool isFolderRun(const std::string& path) {
  if (!fs::is_directory(path)) return false;
  if (holdsPicture(path)) return true;
  const fs::directory_iterator entries(path);
  return std::any_of(begin(entries), end(entries), [](const auto& entry) {
    return entry.is_directory() && holdsPicture(entry.path().string());
  });
}

bool isRun(const std::string& path) { return isBag(path) || isFolderRun(path); }

void findRunsOf(const std::string& input, std::vector<std::string>& runs) {
  if (!fs::exists(input)) throw Error(input + " does not exist; check the path.");
  if (isRun(input)) {
    runs.push_back(input);
    return;
  }
  if (!fs::is_directory(input)) {
    throw Error(input +
                " is neither a bag nor a folder; give a file that ends in .bag or a "
                "folder of room/picture files.");
  }
  const std::size_t before = runs.size();
  for (const std::string& child : children(input)) {
    if (isRun(child)) runs.push_back(child);
  }
  if (runs.size() == before) {
    throw Error("The folder " + input +
                " holds neither bags nor room/picture files (png, jpg); "
                "put the pictures of each room into a folder with the room's name.");
  }
}

}  // namespace

const char* const kInputHelp =
    "Labelled runs: bags, folders of room/picture files (png, jpg), or folders of these";

void InputOptions::addTo(Verb& verb) {
  const char* const kGroup = "Options on bags";
  verb.option("--image-topic", "TOPIC", bag.image_topic,
              "Topic of the images; needed if there are several")
      .group(kGroup);
  verb.option("--label-topic", "TOPIC", bag.label_topic,
              "Topic of the labels, std_msgs/String (default " + bag.label_topic + ")")
      .group(kGroup);
  verb.option("--labels", "FILE", bag.labels_file,
              "File of labels; RUN.labels.yaml or labels.dat beside RUN.bag is found by itself")
      .group(kGroup);
  verb.option("--label", "PLACE", bag.label, "The whole of every bag shows this place")
      .group(kGroup);
}

std::vector<RunOpener> InputOptions::openers(const std::vector<std::string>& inputs) const {
  const std::vector<std::string> runs = findRuns(inputs);
  if (!bag.labels_file.empty() && std::count_if(runs.begin(), runs.end(), isBag) > 1) {
    throw Error("--labels " + bag.labels_file +
                " is for one bag; put a file RUN.labels.yaml beside each of several.");
  }
  std::vector<RunOpener> openers;
  for (const std::string& run : runs) {
    openers.push_back([this, run] { return open(run); });
  }
  return openers;
}

std::unique_ptr<Run> InputOptions::open(const std::string& run) const {
  return isBag(run) ? openBagRun(run, bag) : openFolderRun(run);
}

std::vector<std::string> findRuns(const std::vector<std::string>& inputs) {
  std::vector<std::string> runs;
  for (const std::string& input : inputs) findRunsOf(input, runs);
  return runs;
}

cv::Mat readPicture(const std::string& path) {
  Frame frame;
  frame.name = path;
  if (!fs::exists(path)) throw Error("There is no picture " + path + "; check the path.");
  DecodedImage decoded = readImageFile(path);
  frame.image = std::move(decoded.image);
  frame.problem = std::move(decoded.problem);
  requireImage(frame);
  return frame.image;
}

void requireImage(const Frame& frame) {
  if (!frame.image.empty()) return;
  throw Error("The picture " + frame.name + " is of no use: " + frame.problem +
              "; remove it or put a good one in its place.");
}

bool isBag(const std::string& path) { return extension(path) == ".bag"; }

bool isPicture(const std::string& path) {
  const std::string ending = extension(path);
  return ending == ".png" || ending == ".jpg" || ending == ".jpeg";
}

}  // namespace place_recognition::tool
