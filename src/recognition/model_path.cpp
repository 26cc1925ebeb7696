#include <cstdlib>
#include <filesystem>

#include "place_recognition/error.h"
#include "place_recognition/model_file.h"
#include "recognition/names.h"

namespace place_recognition {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExtension = ".places";

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// A name from anywhere, fit to stand in a message.
std::string quoted(const std::string& name) {
  std::string text = name.substr(0, 80);
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  return "'" + text + (name.size() > 80 ? "...'" : "'");
}

std::string environment(const char* variable) {
  const char* value = std::getenv(variable);
  return value == nullptr ? "" : value;
}

}  // namespace

std::string modelFolder() {
  const std::string ros_home = environment("ROS_HOME");
  if (!ros_home.empty()) return ros_home + "/place_recognition/models";
  const std::string home = environment("HOME");
  if (home.empty()) {
    throw Error("There is no folder for models because HOME is not set; set ROS_HOME or HOME.");
  }
  return home + "/.ros/place_recognition/models";
}

std::string modelPath(const std::string& name) {
  if (name.find('\0') == std::string::npos &&
      (name.find('/') != std::string::npos || endsWith(name, kExtension))) {
    return name;
  }
  return namedModelPath(name);
}

std::string namedModelPath(const std::string& name) {
  if (!isPlainName(name)) {
    throw Error(quoted(name) + " cannot name a model; use 1 to 64 letters, digits, '_' or '-'.");
  }
  const std::string path = modelFolder() + "/" + name + kExtension;
  if (fs::is_symlink(fs::symlink_status(path))) {
    throw Error("The model '" + name + "' is a link to elsewhere; put the file itself into " +
                modelFolder() + ".");
  }
  return path;
}

}  // namespace place_recognition
