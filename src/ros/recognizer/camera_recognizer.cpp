#include "ros/recognizer/camera_recognizer.h"

#include <algorithm>
#include <chrono>
#include <limits>

#include "base/time_jump.h"
#include "ros/messages/conversions.h"
#include "ros/nodes/node_names.h"
#include "ros/recognizer/debug_image.h"

namespace place_recognition {
namespace {

/// Interval between two warnings of unusable images.
constexpr std::chrono::seconds kWarningPeriod(10);

/// Seconds of a clock that also advances when a camera repeats its stamp.
double secondsOf(std::chrono::steady_clock::time_point time) {
  return std::chrono::duration<double>(time.time_since_epoch()).count();
}

std::string debugImageTopic(const std::string& camera) {
  return camera.empty() ? names::kDebugImage : camera + "/" + names::kDebugImage;
}

}  // namespace

CameraRecognizer::CameraRecognizer(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                                   Parameters& parameters, CameraName name,
                                   const ModelSlot& model_slot, ImageInput::Callback received,
                                   const std::function<void()>& wanted_changed)
    : name_(std::move(name)),
      model_slot_(model_slot),
      input_(node, private_node, parameters, std::move(received), names::kImageQueue, name_.topic),
      status_(parameters, input_) {
  const image_transport::SubscriberStatusCallback changed =
      [wanted_changed](const image_transport::SingleSubscriberPublisher&) { wanted_changed(); };
  debug_image_publisher_ = image_transport::ImageTransport(private_node)
                               .advertise(debugImageTopic(name_.name), 1, changed, changed);
}

void CameraRecognizer::subscribe() {
  status_.listening(true);
  input_.subscribe();
}

void CameraRecognizer::unsubscribe() {
  status_.listening(false);
  input_.unsubscribe();
}

bool CameraRecognizer::follow(const PlaceRecognizerConfig& config) {
  std::shared_ptr<const Model> model = model_slot_.model();
  if (!model) return false;
  const bool is_new = model != model_;
  if (is_new) {
    model_ = std::move(model);
    recognizer_ = std::make_unique<Recognizer>(model_);
    guard_.emplace(*model_);
    level_scale_ = LevelScale(model_->images.levels);
    level_text_.clear();
  }
  const double wanted = config.unknown_threshold;
  unknown_threshold_ = wanted < 0 ? model_->unknown_threshold : wanted;
  recognizer_->setUnknownThreshold(unknown_threshold_);
  recognizer_->setEmbeddingRate(config.embedding_rate);
  recognizer_->setDecorrelationTime(config.smoothing);
  deadline_ = config.deadline / 1000;
  return is_new;
}

double CameraRecognizer::timeOf(const ros::Time& stamp, ImageStatus::Clock::time_point arrival) {
  if (stamp.isZero()) return ros::Time::now().toSec();
  const bool stood_still = stands_still_;
  stands_still_ = standing_stamp_.standsStill(stamp.toSec(), secondsOf(arrival));
  if (!stands_still_) return stamp.toSec();
  if (!stood_still) {
    ROS_WARN(
        "The stamps of the images on %s stand still at %.3f s; images count at the time of their "
        "arrival. Check the camera's driver.",
        topic().c_str(), stamp.toSec());
  }
  return ros::Time::now().toSec();
}

bool CameraRecognizer::admits(double stamp, double maximum_rate) {
  followClock(stamp);
  return rate_limit_.admits(stamp, maximum_rate);
}

void CameraRecognizer::followClock(double stamp) {
  if (stamp < last_stamp_ - kTimeJump) {
    ROS_INFO("Time has jumped back by %.1f s; starting afresh.", last_stamp_ - stamp);
    rate_limit_.reset();
    last_stamp_ = stamp;
  }
  last_stamp_ = std::max(last_stamp_, stamp);
}

cv::Mat CameraRecognizer::imageOf(const ImageMessage& message) {
  const cv::Mat image = message.image();
  if (image.depth() != CV_16U) return image;
  cv::Mat scaled = level_scale_.toEightBits(image);
  if (level_text_ != level_scale_.text()) {
    level_text_ = level_scale_.text();
    ROS_INFO("Images with 16 bits are converted to 8: %s.", level_text_.c_str());
  }
  return scaled;
}

const Recognition& CameraRecognizer::recognize(const cv::Mat& image, double stamp,
                                               ImageStatus::Clock::time_point arrival) {
  const std::string camera = name().empty() ? "" : name() + ": ";
  for (const std::string& warning : guard_->judge(image, secondsOf(arrival))) {
    ROS_WARN("%s%s", camera.c_str(), warning.c_str());
  }
  status_.judged(guard_->problem());
  const Recognition& recognition = recognizer_->recognize(image, stamp, secondsLeft(arrival));
  if (recognition.place < 0) status_.answeredNothing(recognition.reason);
  status_.held(recognition.held.size());
  status_.followed(recognizer_->lightCorrection(), recognizer_->evidenceShift());
  return recognition;
}

double CameraRecognizer::secondsLeft(ImageStatus::Clock::time_point arrival) const {
  if (deadline_ == 0) return std::numeric_limits<double>::infinity();
  return deadline_ - (secondsOf(ImageStatus::Clock::now()) - secondsOf(arrival));
}

Recognition CameraRecognizer::recognizeImage(const ImageMessage& message) {
  LevelScale scale = level_scale_;
  const cv::Mat arrived = message.image();
  const cv::Mat image = arrived.depth() == CV_16U ? scale.toEightBits(arrived) : arrived;
  return recognizer_->recognize(image);
}

void CameraRecognizer::publishDebugImage(const cv::Mat& image, const Recognition& recognition,
                                         const std_msgs::Header& header) {
  if (!debugImageIsWanted()) return;
  debug_image_publisher_.publish(toImageMessage(drawAnswer(image, recognition, *model_), header));
}

void CameraRecognizer::reportUnusable(const std::string& why) {
  status_.unusable(why);
  // Not ROS_WARN_THROTTLE, which would count the warnings of all cameras as one.
  const auto now = ImageStatus::Clock::now();
  if (warned_of_unusable_ && now - *warned_of_unusable_ < kWarningPeriod) return;
  warned_of_unusable_ = now;
  ROS_WARN("An image on %s cannot be used: %s", topic().c_str(), why.c_str());
}

void CameraRecognizer::reset() {
  rate_limit_.reset();
  if (recognizer_) recognizer_->forgetStream();
  last_stamp_ = 0;
}

}  // namespace place_recognition
