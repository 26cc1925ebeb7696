#pragma once

#include <dynamic_reconfigure/server.h>
#include <place_recognition/LoadModel.h>
#include <place_recognition/PlaceRecognizerConfig.h>
#include <place_recognition/Recognize.h>
#include <ros/ros.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <boost/thread/recursive_mutex.hpp>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "ros/nodes/parameters.h"
#include "ros/recognizer/answer_publishers.h"
#include "ros/recognizer/camera_clocks.h"
#include "ros/recognizer/camera_list.h"
#include "ros/recognizer/camera_models.h"
#include "ros/recognizer/camera_recognizer.h"
#include "ros/recognizer/diagnostics.h"
#include "ros/recognizer/doubtful_frames.h"
#include "ros/recognizer/place_tracker.h"
#include "ros/recognizer/work_queue.h"

namespace place_recognition {

/// Names the room in each image of one or several cameras; one class for both the node and the
/// nodelet. Callbacks may come from any number of threads; a separate thread processes the images,
/// always the newest of each camera.
class PlaceRecognizer {
 public:
  /// `name` is that of the node or nodelet, for diagnostics. Throws Error if a parameter is
  /// invalid; a model that cannot be loaded is only reported, because ~load_model may name another
  /// one.
  PlaceRecognizer(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                  const std::string& name);
  ~PlaceRecognizer();
  PlaceRecognizer(const PlaceRecognizer&) = delete;
  PlaceRecognizer& operator=(const PlaceRecognizer&) = delete;

 private:
  PlaceRecognizer(const ros::NodeHandle& node, const ros::NodeHandle& private_node,
                  const std::string& name, Parameters parameters);
  void startCameras(Parameters& parameters);  // requires control_mutex_, as does advertise()
  void advertise();
  void advertiseServices();
  void startReconfigure();
  void startWork();
  void updateSubscription();
  bool isWanted() const;

  void onImage(std::size_t camera, const ImageMessage& message);
  void onReconfigure(PlaceRecognizerConfig& config);
  bool onLoadModel(LoadModel::Request& request, LoadModel::Response& response);
  bool onReloadModel(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool onSetEnabled(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);
  bool onRecognize(Recognize::Request& request, Recognize::Response& response);
  bool onReset(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);

  /// Calls `change` and reports the result in `response`.
  template <typename Change, typename Response>
  void changeModels(const Change& change, Response& response);

  void work();
  void answer(const ArrivedImage& arrived);
  void recognize(const ArrivedImage& arrived);
  /// For ~recognize: has no effect on the answers to frames.
  void answer(Question& question);
  void followModels();
  void publish(const ArrivedImage& arrived, const cv::Mat& image, const Recognition& recognition,
               double seconds);
  void reset();
  /// Discards everything seen over time; the place is unknown. Waits for the answer in progress.
  void forgetAnswers();
  void watchCamera();

  ros::NodeHandle node_;
  ros::NodeHandle private_node_;
  const std::vector<CameraName> names_;
  CameraModels models_;
  const double image_timeout_;  // s; 0: none
  WorkQueue queue_;
  std::vector<bool> usable_;  // per camera: the last image that was not left out
  CameraClocks clocks_;       // used by the worker
  std::vector<std::unique_ptr<CameraRecognizer>> cameras_;
  Diagnostics diagnostics_;

  std::mutex control_mutex_;  // guards what decides whether images are wanted
  const bool lazy_;
  bool enabled_ = true;
  bool subscribed_ = false;

  std::mutex state_mutex_;  // guards what an answer depends on and modifies
  PlaceRecognizerConfig config_;
  PlaceTracker place_tracker_;
  DoubtfulFrames doubtful_frames_;
  ImageStatus::Clock::time_point last_image_;  // arrival of the last usable image
  AnswerPublishers answers_;

  std::vector<ros::ServiceServer> services_;
  boost::recursive_mutex reconfigure_mutex_;
  std::unique_ptr<dynamic_reconfigure::Server<PlaceRecognizerConfig>> reconfigure_server_;
  std::thread worker_;
  ros::WallTimer camera_timer_;
};

}  // namespace place_recognition
