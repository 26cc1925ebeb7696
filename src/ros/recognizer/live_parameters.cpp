#include "ros/recognizer/live_parameters.h"

#include <cmath>

namespace place_recognition {
namespace {

struct LiveParameter {
  const char* name;
  double PlaceRecognizerConfig::*value;
};

constexpr LiveParameter kLiveParameters[] = {
    {"unknown_threshold", &PlaceRecognizerConfig::unknown_threshold},
    {"smoothing", &PlaceRecognizerConfig::smoothing},
    {"maximum_rate", &PlaceRecognizerConfig::maximum_rate},
    {"embedding_rate", &PlaceRecognizerConfig::embedding_rate},
    {"deadline", &PlaceRecognizerConfig::deadline}};

}  // namespace

void checkLiveParameters(Parameters& parameters, const ros::NodeHandle& private_node) {
  for (const auto& [name, value] : kLiveParameters) {
    const double least = PlaceRecognizerConfig::__getMin__().*value;
    const double most = PlaceRecognizerConfig::__getMax__().*value;
    const double initial = PlaceRecognizerConfig::__getDefault__().*value;
    private_node.setParam(name, parameters.real(name, initial, least, most));
  }
}

void keepNumbers(PlaceRecognizerConfig& config, const PlaceRecognizerConfig& before) {
  for (const auto& [name, value] : kLiveParameters) {
    if (!std::isnan(config.*value)) continue;
    ROS_WARN("~%s is not a number; it stays at %g.", name, before.*value);
    config.*value = before.*value;
  }
}

}  // namespace place_recognition
