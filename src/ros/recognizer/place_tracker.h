#pragma once

#include <nav_msgs/Odometry.h>
#include <ros/ros.h>

#include <memory>
#include <string>
#include <vector>

#include "base/place_name.h"
#include "place_recognition/temporal_filter.h"
#include "recognition/over_time/odometry_accumulator.h"
#include "ros/nodes/parameters.h"
#include "ros/recognizer/smoothed_answers.h"

namespace place_recognition {

/// Combines the answers to single frames of all cameras over time, with a TemporalFilter and the
/// node's additional knowledge: how the cameras' errors correlate (`~camera_correlation`, else as
/// learned by the model), which rooms adjoin (the file in the parameter `~adjacency`, else as
/// learned by the model) and how far the robot has driven (the topic `odom`, if `~use_odometry` is
/// set). Also provides the smoothed answers (SmoothedAnswers). Not thread-safe, except for
/// odometry, which may arrive at any time.
class PlaceTracker {
 public:
  /// `cameras`: the topics of their images, at least one.
  PlaceTracker(const ros::NodeHandle& node, Parameters& parameters,
               std::vector<std::string> cameras = {""});

  /// Sets the model of each camera; null if it has none. A map that does not fit the models is
  /// reported and ignored. `smoothing`, s: see the parameter; 0: the answer over time is that to
  /// the single frame.
  void setModels(std::vector<std::shared_ptr<const Model>> models, double smoothing);
  void setSmoothing(double smoothing);
  void setUnknownThreshold(double threshold, std::size_t camera = 0);

  /// Whether frames of a camera are used.
  bool counts(std::size_t camera) const;
  /// Why they are not: its model knows other places than the first model. Empty if they are.
  std::string whyNotCounted(std::size_t camera) const;

  /// The place after the frame with `stamp`, s, of a camera whose frames are used, or
  /// kUnknownPlace; valid until the next call.
  const std::string& update(double stamp, const Recognition& recognition, std::size_t camera = 0);

  /// `message`, the answer to the frame of the last update(), with the places' probabilities after
  /// all frames so far. Unchanged if smoothing is 0.
  PlaceRecognition belief(PlaceRecognition message) const;

  /// `message` is the answer to the frame of the last update(). Returns the messages of earlier
  /// frames whose waiting time (`~smoothing_lag`) is over, with their places revised by the frames
  /// since then; none if smoothing is 0.
  std::vector<PlaceRecognition> smooth(const PlaceRecognition& message);
  /// Discards the waiting messages because nobody listens.
  void dropSmoothed() { smoothed_.clear(); }

  /// Discards everything seen. Returns the waiting messages, like smooth(), since no more frames
  /// follow.
  std::vector<PlaceRecognition> reset();

 private:
  void onOdometry(const nav_msgs::OdometryConstPtr& odometry);
  Adjacency adjacencyOf(const Model& model) const;
  Eigen::MatrixXd correlation() const;
  void makeFilter();

  const std::vector<std::string> cameras_;
  const Eigen::MatrixXd given_correlation_;           // empty: as learned
  const std::string adjacency_path_;                  // empty: none
  std::vector<std::shared_ptr<const Model>> models_;  // one per camera; null: none yet
  std::shared_ptr<const Model> model_;  // the first of them, which determines the places
  Adjacency adjacency_{0};
  double smoothing_ = 0;
  std::unique_ptr<TemporalFilter> filter_;  // null: not smoothed
  SmoothedAnswers smoothed_;
  OdometryAccumulator way_;
  ros::Subscriber odometry_subscriber_;
};

}  // namespace place_recognition
