#include "ros/recognizer/image_status.h"

#include <ros/ros.h>

#include <algorithm>

#include "ros/nodes/image_topics.h"
#include "ros/nodes/node_names.h"
#include "ros/nodes/seconds_between.h"

namespace place_recognition {
namespace {

using diagnostic_msgs::DiagnosticStatus;

double secondsElapsed(ImageStatus::Clock::time_point from, ImageStatus::Clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

}  // namespace

ImageStatus::ImageStatus(Parameters& parameters, const ImageInput& input)
    : input_(input),
      timeout_(parameters.real("image_timeout", names::kImageTimeout, 0)),
      max_image_age_(parameters.real("max_image_age", 0, 0)) {}

void ImageStatus::listening(bool subscribed) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (subscribed && !listening_) last_arrival_ = Clock::now();
  listening_ = subscribed;
}

void ImageStatus::arrived() {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++recent_.images;
  last_arrival_ = Clock::now();
  warned_of_silence_ = false;
}

void ImageStatus::skipped() {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++skipped_;
}

void ImageStatus::leftOut() {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++left_out_;
}

void ImageStatus::unusable(const std::string& problem) {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++unusable_;
  ++recent_.unusable;
  last_problem_ = problem;
  last_unusable_ = true;
}

void ImageStatus::judged(const std::string& problem) {
  const std::lock_guard<std::mutex> lock(mutex_);
  image_problem_ = problem;
}

void ImageStatus::answeredNothing(const std::string& reason) {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++answered_nothing_;
  last_nothing_ = reason;
}

void ImageStatus::held(std::size_t cues) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (cues > 0) ++with_held_cues_;
}

void ImageStatus::followed(const Light& correction, double evidence_shift) {
  const std::lock_guard<std::mutex> lock(mutex_);
  light_correction_ = correction;
  evidence_shift_ = evidence_shift;
}

void ImageStatus::notCounted(const std::string& why) {
  const std::lock_guard<std::mutex> lock(mutex_);
  not_counted_ = why;
}

void ImageStatus::answered(const ros::Time& stamp, Clock::time_point arrival) {
  const double latency = secondsElapsed(arrival, Clock::now());
  const double age = stamp.isZero() ? 0 : secondsBetween(stamp, ros::Time::now());
  const std::lock_guard<std::mutex> lock(mutex_);
  ++answers_;
  ++recent_.answers;
  last_unusable_ = false;
  recent_.latency_sum += latency;
  recent_.latency_max = std::max(recent_.latency_max, latency);
  last_age_ = age;
}

void ImageStatus::report(Report& report) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const Clock::time_point now = Clock::now();
  const double seconds = std::max(1e-3, secondsElapsed(last_report_, now));
  last_report_ = now;
  summarize(recent_, secondsElapsed(last_arrival_, now), report);
  report.add("images/s", recent_.images / seconds);
  report.add("answers/s", recent_.answers / seconds);
  report.add("mean latency, s", recent_.latency_sum / std::max(1, recent_.answers));
  report.add("largest latency, s", recent_.latency_max);
  report.add("age of the last image, s", last_age_);
  report.add("answers", answers_);
  report.add("answers with held cues", with_held_cues_);
  report.add("skipped while busy", skipped_);
  report.add("left out by the rate limit", left_out_);
  report.add("unusable", unusable_);
  report.add("without a place", answered_nothing_);
  report.add("last reason for no place", last_nothing_);
  report.addf("gains to the light of the training: red, green, blue", "%.2f, %.2f, %.2f",
              light_correction_.red, light_correction_.green, light_correction_.blue);
  report.addf("shift of the evidence", "%.2f", evidence_shift_);
  report.add("last problem", last_problem_);
  recent_ = Recent();
}

void ImageStatus::summarize(const Recent& recent, double silence, Report& report) const {
  if (!listening_) {
    report.summary(DiagnosticStatus::OK, "not listening: disabled, or nobody wants the answers");
  } else if (timeout_ > 0 && silence > timeout_) {
    report.summaryf(DiagnosticStatus::WARN, "no image on %s for %.0f s", input_.topic().c_str(),
                    silence);
  } else if (recent.unusable > 0 || last_unusable_) {
    report.summary(DiagnosticStatus::WARN, "unusable images: " + last_problem_);
  } else if (!not_counted_.empty()) {
    report.summary(DiagnosticStatus::WARN, not_counted_);
  } else if (!image_problem_.empty()) {
    report.summary(DiagnosticStatus::WARN, image_problem_);
  } else if (max_image_age_ > 0 && last_age_ > max_image_age_) {
    report.summaryf(DiagnosticStatus::WARN, "images are %.1f s old when answered", last_age_);
  } else {
    report.summary(DiagnosticStatus::OK, "images are answered");
  }
}

bool ImageStatus::silenceBegins() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (timeout_ == 0 || !listening_ || warned_of_silence_) return false;
  warned_of_silence_ = secondsElapsed(last_arrival_, Clock::now()) > timeout_;
  return warned_of_silence_;
}

void ImageStatus::warnOfSilence() {
  if (!silenceBegins()) return;
  ROS_WARN("No image has arrived on %s for %.0f s. %s", input_.topic().c_str(), timeout_,
           explainSilence(input_.topic(), input_.transport()).c_str());
}

}  // namespace place_recognition
