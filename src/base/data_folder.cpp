#include "base/data_folder.h"

#include <algorithm>
#include <cstdlib>

#include "base/text.h"
#include "place_recognition/error.h"

namespace place_recognition {
namespace {

constexpr std::size_t kMaxPlainNameBytes = 64;

std::string environment(const char* variable) {
  const char* value = std::getenv(variable);
  return value == nullptr ? "" : value;
}

}  // namespace

std::string dataFolder(const std::string& kind) {
  const std::string ros_home = environment("ROS_HOME");
  if (!ros_home.empty()) return ros_home + "/place_recognition/" + kind;
  const std::string home = environment("HOME");
  if (home.empty()) {
    throw Error("There is no folder for " + kind +
                " because HOME is not set; set ROS_HOME or HOME.");
  }
  return home + "/.ros/place_recognition/" + kind;
}

bool isPlainName(const std::string& name) {
  const auto allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  };
  return !name.empty() && name.front() != '-' && name.size() <= kMaxPlainNameBytes &&
         std::all_of(name.begin(), name.end(), allowed);
}

bool isFileName(const std::string& name, const std::string& extension) {
  return name.find('\0') == std::string::npos &&
         (name.find('/') != std::string::npos || endsWith(name, extension));
}

}  // namespace place_recognition
