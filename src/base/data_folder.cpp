#include "base/data_folder.h"

#include <algorithm>
#include <cstdlib>

#include "place_recognition/error.h"

namespace place_recognition {
namespace {

constexpr std::size_t kMaxPlainNameBytes = 64;

std::string environment(const char* variable) {
  const char* value = std::getenv(variable);
  return value == nullptr ? "" : value;
}

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
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
  return !name.empty() && name.size() <= kMaxPlainNameBytes &&
         std::all_of(name.begin(), name.end(), allowed);
}

bool isFileName(const std::string& name, const std::string& extension) {
  return name.find('\0') == std::string::npos &&
         (name.find('/') != std::string::npos || endsWith(name, extension));
}

std::string quoted(const std::string& name) {
  std::string text = name.substr(0, 80);
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  return "'" + text + (name.size() > 80 ? "...'" : "'");
}

}  // namespace place_recognition
