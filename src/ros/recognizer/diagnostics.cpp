#include "ros/recognizer/diagnostics.h"

namespace place_recognition {
namespace {

using diagnostic_msgs::DiagnosticStatus;
using Status = diagnostic_updater::DiagnosticStatusWrapper;

void report(const ModelSlot& model_slot, Status& status) {
  const std::shared_ptr<const Model> model = model_slot.model();
  const std::string problem = model_slot.problem();
  if (!model) {
    status.summary(DiagnosticStatus::ERROR, "no model" + (problem.empty() ? "" : ": " + problem));
    return;
  }
  if (problem.empty()) {
    status.summary(DiagnosticStatus::OK, model->name);
  } else {
    status.summary(DiagnosticStatus::WARN, "still " + model->name + ": " + problem);
  }
  status.add("name", model->name);
  status.add("version", model->version);
  status.add("places", model->places.size());
  status.add("support vectors", model->supportVectorCount());
}

}  // namespace

Diagnostics::Diagnostics(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                         const std::string& node_name)
    : node_(node), updater_(node, private_node, node_name) {
  updater_.setHardwareID("none");
}

void Diagnostics::start() {
  // Wall time, because a paused simulation must not silence the node.
  timer_ = node_.createWallTimer(ros::WallDuration(1), [this](const ros::WallTimerEvent&) {
    updater_.force_update();
    for (ImageStatus* images : images_) images->warnOfSilence();
  });
}

void Diagnostics::add(const std::string& name, const ModelSlot& model_slot) {
  updater_.add(name, [&model_slot](Status& status) { report(model_slot, status); });
}

void Diagnostics::add(const std::string& name, ImageStatus& images) {
  images_.push_back(&images);
  updater_.add(name, [&images](Status& status) { images.report(status); });
}

}  // namespace place_recognition
