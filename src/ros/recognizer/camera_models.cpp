#include "ros/recognizer/camera_models.h"

#include <place_recognition/ModelInfo.h>

#include <utility>

#include "place_recognition/error.h"
#include "ros/messages/conversions.h"
#include "ros/nodes/node_names.h"

namespace place_recognition {
namespace {

std::string textOf(const Model& model) {
  return model.name + " (version " + model.version + "): " + std::to_string(model.places.size()) +
         " places, " + std::to_string(model.supportVectorCount()) + " support vectors";
}

}  // namespace

CameraModels::CameraModels(const ros::NodeHandle& private_node,
                           const std::vector<CameraName>& cameras, const std::string& common)
    : private_node_(private_node) {
  for (const CameraName& camera : cameras) {
    if (!camera.model.empty()) first_names_.push_back(camera.model);
  }
  if (first_names_.empty()) first_names_.push_back(common);
  while (slots_.size() < first_names_.size()) slots_.emplace_back();
}

void CameraModels::advertise() {
  info_publisher_ = private_node_.advertise<ModelInfo>(names::kModelInfo, 1, true);
}

void CameraModels::loadFirst() {
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    try {
      if (first_names_[i].empty()) throw Error("The parameter ~model is not set.");
      slots_[i].load(first_names_[i]);
    } catch (const Error& e) {
      ROS_ERROR(
          "There is no model to recognize with: %s Learn one with `rosrun place_recognition "
          "place_tool train RUN.bag --model NAME` or with the node trainer, then call %s.",
          e.what(), private_node_.resolveName(names::kLoadModel).c_str());
    }
  }
  publishInfo();
}

void CameraModels::load(const std::string& name) {
  const std::lock_guard<std::mutex> one_at_a_time(changing_);
  const ModelSlot::Loaded loaded = slots_.front().read(name);
  for (ModelSlot& slot : slots_) slot.use(loaded);
  publishInfo();
}

void CameraModels::reload() {
  const std::lock_guard<std::mutex> one_at_a_time(changing_);
  std::vector<ModelSlot::Loaded> loaded;
  for (ModelSlot& slot : slots_) loaded.push_back(slot.readAgain());
  for (std::size_t i = 0; i < slots_.size(); ++i) slots_[i].use(std::move(loaded[i]));
  publishInfo();
}

const ModelSlot& CameraModels::slotOf(std::size_t camera) const {
  return slots_.size() == 1 ? slots_.front() : slots_.at(camera);
}

std::string CameraModels::text() const {
  std::string text;
  for (const ModelSlot& slot : slots_) {
    if (const auto model = slot.model()) text += (text.empty() ? "" : ", ") + textOf(*model);
  }
  return text;
}

void CameraModels::publishInfo() {
  const std::shared_ptr<const Model> model = slots_.front().model();
  if (model) info_publisher_.publish(toModelInfo(*model));
  const std::string in_use = text();
  if (!in_use.empty()) ROS_INFO("Recognizing with %s.", in_use.c_str());
}

}  // namespace place_recognition
