#include "ros/bags/bag_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "base/bag_name.h"
#include "base/file_kind.h"
#include "base/text.h"
#include "place_recognition/error.h"
#include "ros/messages/image_types.h"

namespace place_recognition {
namespace {

namespace fs = std::filesystem;

constexpr const char* kStart = "#ROSBAG V2.0";
constexpr const char* kRos2Remedy = "convert it to a ROS 1 bag, for instance with rosbags-convert";

/// Whether the path is taken, if only by a broken link.
bool isTaken(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(path, ignored));
}

bool startsAsBag(const std::string& path) { return startsWith(startOfFile(path), kStart); }

}  // namespace

bool isBag(const std::string& path) {
  std::error_code ignored;
  if (isRos2Bag(path)) return false;
  return hasBagName(path) || startsAsBag(path);
}

std::string writtenLabelsFile(const std::string& path) {
  fs::path labels = path;
  if (isActiveBag(path)) labels.replace_extension();
  return labels.replace_extension(".labels.yaml").string();
}

std::string ownLabelsFile(const std::string& path) {
  fs::path labels = writtenLabelsFile(path);
  for (const char* extension : {".yaml", ".yml"}) {
    if (isTaken(labels.replace_extension(extension))) return labels.string();
  }
  return "";
}

std::string labelsFileBeside(const std::string& path) {
  const std::string own = ownLabelsFile(path);
  if (!own.empty()) return own;
  const fs::path lines = fs::path(path).replace_filename("labels.dat");
  return isTaken(lines) ? lines.string() : "";
}

void requireNoLabelsBeside(const std::string& path) {
  const std::string labels = labelsFileBeside(path);
  if (labels.empty()) return;
  throw Error("The labels of " + path + " would be replaced by those in " + labels +
              ", which lies beside it; rename or remove that file, or write the bag elsewhere.");
}

std::string bareName(const std::string& topic) {
  const std::size_t start = topic.find_first_not_of('/');
  return start == std::string::npos ? ""
                                    : topic.substr(start, topic.find_last_not_of('/') + 1 - start);
}

std::string whyNoImages(const std::vector<std::string>& topics) {
  const bool has_depth = std::any_of(topics.begin(), topics.end(), isCompressedDepth);
  return has_depth ? "it has only compressedDepth images, which cannot be used"
                   : "it has no images";
}

bool isRos2Bag(const std::string& folder) {
  std::error_code failure;
  bool metadata = false, data = false;
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure)) {
    const std::string name = entry->path().filename().string();
    metadata |= name == "metadata.yaml";
    data |= name.find(".db3") != std::string::npos || name.find(".mcap") != std::string::npos;
  }
  return metadata && data;
}

std::string whyNoRecording(const std::string& path) {
  std::error_code ignored;
  if (isRos2Bag(path)) return std::string("a ROS 2 bag; ") + kRos2Remedy;
  if (fs::is_directory(path, ignored)) return "";
  const std::string start = startOfFile(path);
  if (start.empty() && fs::is_regular_file(path, ignored) && fs::file_size(path, ignored) == 0) {
    return "empty; copy or record it again";
  }
  const FileKind* kind = foreignFile(start);
  if (!kind) return "";
  return std::string(kind->name) + "; " + std::string(kind->remedy);
}

void requireBag(const std::string& path) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) {
    if (fs::is_symlink(path, ignored)) {
      throw Error(path + " is a broken link; check " + fs::read_symlink(path, ignored).string() +
                  ".");
    }
    const std::string meant = bagBeside(path);
    throw Error("There is no bag " + path + "; " + (meant.empty() ? "check the path" : meant) +
                ".");
  }
  const std::string why_not = whyNoRecording(path);
  if (!why_not.empty()) throw Error(path + " is " + why_not + ".");
  if (!fs::is_regular_file(path, ignored)) {
    throw Error(path + " is a folder or a device, not a bag; give a bag file.");
  }
  errno = 0;
  if (!std::ifstream(path, std::ios::binary)) {
    throw Error("Cannot read " + path + ": " + std::strerror(errno) +
                "; make it readable, for example with chmod.");
  }
  if (startsAsBag(path)) return;
  throw Error("Cannot read " + path +
              ": it is damaged or not a ROS 1 bag, because it does not start with '" + kStart +
              "'; copy or record it again.");
}

}  // namespace place_recognition
