#include "ros/recognizer/diagnostics.h"

#include <algorithm>

#include "ros/nodes/image_topics.h"
#include "ros/nodes/node_names.h"

namespace place_recognition {
namespace {

using diagnostic_msgs::DiagnosticStatus;

double secondsBetween(Diagnostics::Clock::time_point from, Diagnostics::Clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

}  // namespace

Diagnostics::Diagnostics(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                         Parameters& parameters, const std::string& node_name,
                         const ModelSlot& model_slot, const ImageInput& input)
    : model_slot_(model_slot),
      input_(input),
      timeout_(parameters.real("image_timeout", names::kImageTimeout, 0)),
      max_image_age_(parameters.real("max_image_age", 0, 0)),
      updater_(node, private_node, node_name) {
  updater_.setHardwareID("none");
  updater_.add("Model", [this](Status& status) { reportModel(status); });
  updater_.add("Images", [this](Status& status) { reportImages(status); });
  // Wall time: a paused simulation must not silence the node.
  timer_ = ros::NodeHandle(node).createWallTimer(ros::WallDuration(1),
                                                 [this](const ros::WallTimerEvent&) {
                                                   updater_.force_update();
                                                   warnOfSilence();
                                                 });
}

void Diagnostics::listening(bool subscribed) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (subscribed && !listening_) last_arrival_ = Clock::now();
  listening_ = subscribed;
}

void Diagnostics::arrived() {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++recent_.images;
  last_arrival_ = Clock::now();
  warned_of_silence_ = false;
}

void Diagnostics::skipped() {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++skipped_;
}

void Diagnostics::leftOut() {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++left_out_;
}

void Diagnostics::unusable(const std::string& problem) {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++unusable_;
  ++recent_.unusable;
  last_problem_ = problem;
}

void Diagnostics::judged(const std::string& problem) {
  const std::lock_guard<std::mutex> lock(mutex_);
  image_problem_ = problem;
}

void Diagnostics::answered(const ros::Time& stamp, Clock::time_point arrival) {
  const double latency = secondsBetween(arrival, Clock::now());
  const double age = (ros::Time::now() - stamp).toSec();
  const std::lock_guard<std::mutex> lock(mutex_);
  ++answers_;
  ++recent_.answers;
  recent_.latency_sum += latency;
  recent_.latency_max = std::max(recent_.latency_max, latency);
  last_age_ = age;
}

void Diagnostics::reportModel(Status& status) const {
  const std::shared_ptr<const Model> model = model_slot_.model();
  const std::string problem = model_slot_.problem();
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

void Diagnostics::reportImages(Status& status) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const Clock::time_point now = Clock::now();
  const double seconds = std::max(1e-3, secondsBetween(last_report_, now));
  last_report_ = now;
  summarize(recent_, secondsBetween(last_arrival_, now), status);
  status.add("images/s", recent_.images / seconds);
  status.add("answers/s", recent_.answers / seconds);
  status.add("mean latency, s", recent_.latency_sum / std::max(1, recent_.answers));
  status.add("largest latency, s", recent_.latency_max);
  status.add("age of the last image, s", last_age_);
  status.add("answers", answers_);
  status.add("skipped while busy", skipped_);
  status.add("left out by the rate limit", left_out_);
  status.add("unusable", unusable_);
  status.add("last problem", last_problem_);
  recent_ = Recent();
}

void Diagnostics::summarize(const Recent& recent, double silence, Status& status) const {
  if (!listening_) {
    status.summary(DiagnosticStatus::OK, "not listening: disabled, or nobody wants the answers");
  } else if (timeout_ > 0 && silence > timeout_) {
    status.summaryf(DiagnosticStatus::WARN, "no image on %s for %.0f s", input_.topic().c_str(),
                    silence);
  } else if (recent.unusable > 0) {
    status.summary(DiagnosticStatus::WARN, "unusable images: " + last_problem_);
  } else if (!image_problem_.empty()) {
    status.summary(DiagnosticStatus::WARN, image_problem_);
  } else if (max_image_age_ > 0 && last_age_ > max_image_age_) {
    status.summaryf(DiagnosticStatus::WARN, "images are %.1f s old when answered", last_age_);
  } else {
    status.summary(DiagnosticStatus::OK, "images are answered");
  }
}

bool Diagnostics::silenceBegins() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (timeout_ == 0 || !listening_ || warned_of_silence_) return false;
  warned_of_silence_ = secondsBetween(last_arrival_, Clock::now()) > timeout_;
  return warned_of_silence_;
}

void Diagnostics::warnOfSilence() {
  if (!silenceBegins()) return;
  ROS_WARN("No image has come on %s for %.0f s. %s", input_.topic().c_str(), timeout_,
           explainSilence(input_.topic(), input_.transport()).c_str());
}

}  // namespace place_recognition
