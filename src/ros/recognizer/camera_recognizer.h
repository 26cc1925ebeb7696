#pragma once

#include <image_transport/image_transport.h>
#include <place_recognition/PlaceRecognizerConfig.h>
#include <ros/ros.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "base/rate_limit.h"
#include "base/standing_stamp.h"
#include "datasets/level_scale.h"
#include "place_recognition/recognizer.h"
#include "recognition/frames/image_guard.h"
#include "ros/nodes/image_input.h"
#include "ros/nodes/parameters.h"
#include "ros/recognizer/camera_list.h"
#include "ros/recognizer/image_status.h"
#include "ros/recognizer/model_slot.h"

namespace place_recognition {

/// One camera of place_recognizer: receives its images and recognizes each with the camera's model.
/// Not thread-safe, except where stated.
class CameraRecognizer {
 public:
  /// `model_slot` must outlive it. `wanted_changed` is called when somebody starts or stops
  /// listening to the debug image; images are passed to `received`. Both may be called from any
  /// thread.
  CameraRecognizer(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                   Parameters& parameters, CameraName name, const ModelSlot& model_slot,
                   ImageInput::Callback received, const std::function<void()>& wanted_changed);

  const std::string& name() const { return name_.name; }
  std::string topic() const { return input_.topic(); }
  /// Thread-safe.
  ImageStatus& status() { return status_; }

  /// From one thread at a time.
  void subscribe();
  void unsubscribe();

  /// Adopts the model of the slot and the settings for answers. True if the model has changed.
  bool follow(const PlaceRecognizerConfig& config);
  /// The model in use; null if none.
  const std::shared_ptr<const Model>& model() const { return model_; }
  double unknownThreshold() const { return unknown_threshold_; }

  /// When an image was taken, s: its stamp. The time now if the camera does not stamp its images,
  /// or has given them all the same stamp for a second; `arrival` is that of the image.
  double timeOf(const ros::Time& stamp, ImageStatus::Clock::time_point arrival);
  /// Whether to recognize an image with this stamp, s; remembers the stamp.
  bool admits(double stamp, double maximum_rate);
  /// The stamp of the last image, admitted or not, s; it decreases only if time has jumped back.
  double lastStamp() const { return last_stamp_; }

  /// The image in the form that the model expects; it may share the message's memory. Throws Error
  /// if it is unusable. This and the functions below require a model.
  cv::Mat imageOf(const ImageMessage& message);
  /// The answer to the next image, with `stamp`, s, which arrived at `arrival`.
  const Recognition& recognize(const cv::Mat& image, double stamp,
                               ImageStatus::Clock::time_point arrival);
  /// Whether the camera shows nothing, according to the last image recognized.
  bool blind() const { return guard_->blind(); }
  /// The answer to a single image; has no effect on the answers to the stream.
  Recognition recognizeImage(const ImageMessage& message);

  /// Does nothing if nobody listens.
  void publishDebugImage(const cv::Mat& image, const Recognition& recognition,
                         const std_msgs::Header& header);
  bool debugImageIsWanted() const { return debug_image_publisher_.getNumSubscribers() > 0; }

  /// Records that an image cannot be used, and why; warns of it at most once in 10 s.
  void reportUnusable(const std::string& why);

  /// Discards everything seen.
  void reset();

 private:
  void followClock(double stamp);
  double secondsLeft(ImageStatus::Clock::time_point arrival) const;

  const CameraName name_;
  const ModelSlot& model_slot_;
  ImageInput input_;
  ImageStatus status_;
  std::shared_ptr<const Model> model_;
  std::unique_ptr<Recognizer> recognizer_;  // of the model
  std::optional<ImageGuard> guard_;         // likewise
  double unknown_threshold_ = 0;
  double deadline_ = 0;  // s; 0 if none
  RateLimit rate_limit_;
  LevelScale level_scale_;  // of the model, or of the images so far
  std::string level_text_;  // as last logged
  double last_stamp_ = 0;   // s
  StandingStamp standing_stamp_;
  bool stands_still_ = false;
  std::optional<ImageStatus::Clock::time_point> warned_of_unusable_;  // last
  image_transport::Publisher debug_image_publisher_;
};

}  // namespace place_recognition
