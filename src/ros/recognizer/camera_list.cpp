#include "ros/recognizer/camera_list.h"

#include <ros/names.h>

#include "base/text.h"
#include "place_recognition/camera_correlation.h"
#include "place_recognition/error.h"
#include "ros/nodes/node_names.h"

namespace place_recognition {
namespace {

CameraName cameraOf(const std::string& text, const Parameters& parameters) {
  std::string problem;
  if (text.empty() || text[0] == '~' || !ros::names::validate(text, problem)) {
    const bool is_list = text.find(',') != std::string::npos;
    parameters.refuse(
        "cameras",
        "The parameter ~cameras has '" + text + "', which is not the name of a topic; " +
            (is_list ? "write [" + text + "]." : "give image topics, or names before /image_raw."));
  }
  const bool is_topic = text.find('/') != std::string::npos;
  const std::string name = text[0] == '/' ? text.substr(1) : text;
  return {name, is_topic ? text : text + names::kImageRawSuffix, ""};
}

void requireModelsFor(const std::vector<CameraName>& cameras,
                      const std::vector<std::string>& models, const std::string& model,
                      const Parameters& parameters) {
  if (models.empty()) return;
  if (models.size() != cameras.size()) {
    parameters.refuse("models", "The parameter ~models has " + counted(models.size(), "name") +
                                    " for " + counted(cameras.size(), "camera") +
                                    "; give one for each of ~cameras.");
  }
  if (!model.empty()) {
    parameters.refuse("models", "Both ~model and ~models are set; give one of them.");
  }
}

}  // namespace

std::vector<CameraName> readCameras(Parameters& parameters) {
  std::vector<CameraName> cameras;
  for (const std::string& text : parameters.texts("cameras")) {
    cameras.push_back(cameraOf(text, parameters));
    for (std::size_t i = 0; i + 1 < cameras.size(); ++i) {
      if (cameras[i].name != cameras.back().name) continue;
      parameters.refuse("cameras",
                        "The parameter ~cameras has '" + text + "' twice; name each camera once.");
    }
  }
  if (cameras.size() > kMaxCameras) {
    parameters.refuse("cameras", "The parameter ~cameras has " + counted(cameras.size(), "camera") +
                                     "; give at most " + std::to_string(kMaxCameras) + ".");
  }
  if (cameras.size() == 1) cameras[0].name.clear();
  if (cameras.empty()) cameras.push_back({"", names::kImage, ""});
  const std::vector<std::string> models = parameters.texts("models");
  requireModelsFor(cameras, models, parameters.text("model"), parameters);
  for (std::size_t i = 0; i < models.size(); ++i) cameras[i].model = models[i];
  return cameras;
}

void requireDifferentTopics(const std::vector<CameraName>& cameras,
                            const std::vector<std::string>& topics) {
  for (std::size_t i = 0; i < topics.size(); ++i) {
    for (std::size_t other = 0; other < i; ++other) {
      if (topics[other] != topics[i]) continue;
      throw Error("The cameras '" + cameras[other].name + "' and '" + cameras[i].name +
                  "' of ~cameras are the same topic, " + topics[i] + "; name each camera once.");
    }
  }
}

Eigen::MatrixXd readCameraCorrelation(Parameters& parameters, std::size_t cameras) {
  const std::vector<double> given = parameters.reals("camera_correlation", 0, 1);
  if (given.empty()) return {};
  const std::size_t pairs = cameras * (cameras - 1) / 2;
  if (pairs == 0) {
    parameters.refuse(
        "camera_correlation",
        "The parameter ~camera_correlation is for several cameras; set ~cameras, too.");
  }
  if (given.size() != 1 && given.size() != pairs) {
    parameters.refuse(
        "camera_correlation",
        "The parameter ~camera_correlation has " + counted(given.size(), "number") +
            "; give one for all, or " + std::to_string(pairs) +
            " for the pairs of cameras: first and second, first and third, and so on.");
  }
  const auto count = static_cast<Eigen::Index>(cameras);
  Eigen::MatrixXd correlation = Eigen::MatrixXd::Identity(count, count);
  std::size_t next = 0;
  for (Eigen::Index a = 0; a < count; ++a) {
    for (Eigen::Index b = a + 1; b < count; ++b) {
      correlation(a, b) = correlation(b, a) = given.size() == 1 ? given[0] : given[next++];
    }
  }
  return correlation;
}

}  // namespace place_recognition
