// The services of place_recognizer.
#include <boost/make_shared.hpp>
#include <exception>

#include "place_recognition/error.h"
#include "ros/nodes/node_names.h"
#include "ros/recognizer/place_recognizer.h"

namespace place_recognition {
namespace {

ImageMessage imageOf(const Recognize::Request& request) {
  if (request.image.data.empty() == request.compressed.data.empty()) {
    throw Error("Give one image, either as image or as compressed.");
  }
  if (request.image.data.empty()) {
    return ImageMessage(boost::make_shared<const sensor_msgs::CompressedImage>(request.compressed));
  }
  return ImageMessage(boost::make_shared<const sensor_msgs::Image>(request.image));
}

}  // namespace

void PlaceRecognizer::advertiseServices() {
  services_ = {
      private_node_.advertiseService(names::kLoadModel, &PlaceRecognizer::onLoadModel, this),
      private_node_.advertiseService(names::kReloadModel, &PlaceRecognizer::onReloadModel, this),
      private_node_.advertiseService(names::kSetEnabled, &PlaceRecognizer::onSetEnabled, this),
      private_node_.advertiseService(names::kReset, &PlaceRecognizer::onReset, this),
      private_node_.advertiseService(names::kRecognize, &PlaceRecognizer::onRecognize, this)};
}

template <typename Change, typename Response>
void PlaceRecognizer::changeModels(const Change& change, Response& response) {
  try {
    change();
    response.success = true;
    response.message = "Recognizing with " + models_.text() + ".";
  } catch (const Error& e) {
    response.success = false;
    response.message = e.what();
    ROS_WARN("The model is unchanged: %s", e.what());
  }
}

bool PlaceRecognizer::onLoadModel(LoadModel::Request& request, LoadModel::Response& response) {
  changeModels([&] { models_.load(request.name); }, response);
  return true;
}

bool PlaceRecognizer::onReloadModel(std_srvs::Trigger::Request&,
                                    std_srvs::Trigger::Response& response) {
  changeModels([&] { models_.reload(); }, response);
  return true;
}

bool PlaceRecognizer::onSetEnabled(std_srvs::SetBool::Request& request,
                                   std_srvs::SetBool::Response& response) {
  const bool enable = request.data;
  bool was_enabled;
  {
    const std::lock_guard<std::mutex> lock(control_mutex_);
    was_enabled = std::exchange(enabled_, enable);
  }
  if (enable != was_enabled) {
    updateSubscription();
    forgetAnswers();
  }
  response.success = true;
  response.message = request.data ? "Recognizing." : "Not recognizing until enabled again.";
  return true;
}

bool PlaceRecognizer::onReset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  reset();
  response.success = true;
  response.message = "Everything seen before is discarded.";
  return true;
}

bool PlaceRecognizer::onRecognize(Recognize::Request& request, Recognize::Response& response) {
  try {
    response.recognition = queue_.ask(imageOf(request)).get();
    response.success = true;
  } catch (const std::exception& e) {
    response.message = e.what();
  }
  return true;
}

}  // namespace place_recognition
