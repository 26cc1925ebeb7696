#pragma once

#include <dynamic_reconfigure/server.h>
#include <image_transport/image_transport.h>
#include <place_recognition/LoadModel.h>
#include <place_recognition/PlaceRecognizerConfig.h>
#include <place_recognition/Recognize.h>
#include <ros/ros.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <boost/thread/recursive_mutex.hpp>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "base/rate_limit.h"
#include "datasets/depth_scale.h"
#include "place_recognition/recognizer.h"
#include "recognition/frames/image_guard.h"
#include "recognition/recognizer/model_slot.h"
#include "ros/nodes/image_input.h"
#include "ros/nodes/newest_image.h"
#include "ros/nodes/parameters.h"
#include "ros/recognizer/diagnostics.h"
#include "ros/recognizer/place_tracker.h"

namespace place_recognition {

/// Names the room of each image, as a node or a nodelet: one object for both. Callbacks may come
/// from any number of threads; images are worked on in a thread of its own, always the newest.
class PlaceRecognizer {
 public:
  /// `name` is that of the node or nodelet, for diagnostics. Throws Error if a parameter is wrong;
  /// a model that cannot be loaded is only reported, for ~load_model may name another.
  PlaceRecognizer(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                  const std::string& name);
  ~PlaceRecognizer();
  PlaceRecognizer(const PlaceRecognizer&) = delete;
  PlaceRecognizer& operator=(const PlaceRecognizer&) = delete;

 private:
  PlaceRecognizer(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                  const std::string& name, Parameters parameters);
  void advertise();
  void loadFirstModel(const std::string& name);
  void updateSubscription();
  bool isWanted() const;

  void onImage(const ImageMessage& message);
  void onReconfigure(PlaceRecognizerConfig& config);
  bool onLoadModel(LoadModel::Request& request, LoadModel::Response& response);
  bool onReloadModel(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool onSetEnabled(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);
  bool onRecognize(Recognize::Request& request, Recognize::Response& response);
  bool onReset(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);

  /// Calls `load` and tells in `response` how that went.
  template <typename Load, typename Response>
  void changeModel(const Load& load, Response& response);

  void work();
  void answer(const ArrivedImage& arrived);
  void recognize(const ArrivedImage& arrived);
  /// Asked by ~recognize: changes nothing that an answer to a frame depends on.
  void answer(Question& question);
  cv::Mat inEightBits(const cv::Mat& image);
  void followClock(double stamp);
  bool followModel();
  void publish(const ArrivedImage& arrived, const cv::Mat& image, const Recognition& recognition,
               double seconds);
  void publishPlace(const std::string& place);
  void publishSmoothed(const PlaceRecognition& message);
  void publishModelInfo();
  void reset();
  void watchCamera();
  void forgetPlace();

  ros::NodeHandle node_;
  ros::NodeHandle private_node_;
  ModelSlot model_slot_;
  ImageInput input_;
  Diagnostics diagnostics_;
  const double image_timeout_;  // s; 0: none
  NewestImage newest_;

  std::mutex control_mutex_;  // of what decides whether images are wanted
  const bool lazy_;
  bool enabled_ = true;
  bool subscribed_ = false;

  std::mutex state_mutex_;  // of what an answer depends on and leaves behind
  PlaceRecognizerConfig config_;
  std::unique_ptr<Recognizer> recognizer_;  // of the model in use
  std::optional<ImageGuard> guard_;         // likewise
  PlaceTracker place_tracker_;              // likewise
  RateLimit rate_limit_;
  DepthScale depth_scale_;                     // of the model, or of the images that came
  std::string depth_text_;                     // as logged last
  double last_stamp_ = 0;                      // s
  Diagnostics::Clock::time_point last_image_;  // arrival of the last one that could be used
  std::string last_place_;                     // as published last

  ros::Publisher recognition_publisher_;
  ros::Publisher place_publisher_;
  ros::Publisher smoothed_publisher_;
  ros::Publisher model_info_publisher_;
  ros::Publisher marker_publisher_;
  image_transport::Publisher debug_image_publisher_;
  std::vector<ros::ServiceServer> services_;
  boost::recursive_mutex reconfigure_mutex_;
  std::unique_ptr<dynamic_reconfigure::Server<PlaceRecognizerConfig>> reconfigure_server_;
  std::thread worker_;
  ros::WallTimer camera_timer_;
};

}  // namespace place_recognition
