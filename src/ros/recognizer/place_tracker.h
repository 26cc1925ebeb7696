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

/// What the answers to single frames of all cameras amount to over time: a TemporalFilter with what
/// the node knows beside them, how alike the cameras err (`~camera_correlation`, else what the
/// model has learned), which rooms adjoin (the file that the parameter `~adjacency` names, else
/// what the model has learned) and how far the robot has driven (the topic `odom`, if
/// `~use_odometry`); and what they amount to when one waits a little (SmoothedAnswers). Not
/// thread-safe, but for odometry, which may come at any time.
class PlaceTracker {
 public:
  /// `cameras`: the topics of their images, one at least.
  PlaceTracker(const ros::NodeHandle& node, Parameters& parameters,
               std::vector<std::string> cameras = {""});

  /// From now on frames of each camera are answered by its model; null: by none. A map that does
  /// not fit them is reported and left out. `smoothing`, s: see the parameter; 0: the answer is
  /// that to the single frame.
  void setModels(std::vector<std::shared_ptr<const Model>> models, double smoothing);
  void setModel(std::shared_ptr<const Model> model, double smoothing);
  void setSmoothing(double smoothing);
  void setUnknownThreshold(double threshold, std::size_t camera = 0);

  /// Whether frames of a camera count.
  bool counts(std::size_t camera) const;
  /// Why they do not, for its model knows other places than the first one;
  /// empty: they do.
  std::string whyNotCounted(std::size_t camera) const;

  /// The place after the frame of `stamp`, s, of a camera that counts, or kUnknownPlace; valid
  /// until the next call.
  const std::string& update(double stamp, const Recognition& recognition, std::size_t camera = 0);

  /// `message` answers the frame of the last update(). The same with what all frames so far make of
  /// the places; where the smoothing is 0, as it is.
  PlaceRecognition belief(PlaceRecognition message) const;

  /// `message` answers the frame of the last update(). The messages of frames before it, whose time
  /// to wait (`~smoothing_lag`) is over, with the places that they have in the light of what came
  /// since; none where the smoothing is 0.
  std::vector<PlaceRecognition> smooth(const PlaceRecognition& message);
  /// Nobody is interested: messages that wait are forgotten.
  void dropSmoothed() { smoothed_.clear(); }

  /// Forgets what was seen. The messages that wait for what does not come now, as smooth().
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
  std::shared_ptr<const Model> model_;                // the first of them, whose places count
  Adjacency adjacency_{0};
  double smoothing_ = 0;
  std::unique_ptr<TemporalFilter> filter_;  // none: not smoothed
  SmoothedAnswers smoothed_;
  OdometryAccumulator way_;
  ros::Subscriber odometry_subscriber_;
};

}  // namespace place_recognition
