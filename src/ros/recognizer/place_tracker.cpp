#include "ros/recognizer/place_tracker.h"

#include <algorithm>
#include <cassert>

#include "base/place_name.h"
#include "base/user_path.h"
#include "place_recognition/error.h"
#include "ros/messages/conversions.h"
#include "ros/messages/pose_conversions.h"
#include "ros/nodes/node_names.h"
#include "ros/recognizer/camera_list.h"

namespace place_recognition {
namespace {

/// s; nobody can use images after a longer wait.
constexpr double kLongestLag = 10;

}  // namespace

PlaceTracker::PlaceTracker(const ros::NodeHandle& node, Parameters& parameters,
                           std::vector<std::string> cameras)
    : cameras_(std::move(cameras)),
      given_correlation_(readCameraCorrelation(parameters, cameras_.size())),
      adjacency_path_(userPath(parameters.text("adjacency"))),
      smoothed_(parameters.real("smoothing_lag", 1, 0, kLongestLag)) {
  if (parameters.flag("use_odometry", false)) {
    odometry_subscriber_ = ros::NodeHandle(node).subscribe(names::kOdometry, names::kOdometryQueue,
                                                           &PlaceTracker::onOdometry, this);
  }
}

void PlaceTracker::onOdometry(const nav_msgs::OdometryConstPtr& odometry) {
  way_.add(toOdometryPose(*odometry));
}

void PlaceTracker::setModels(std::vector<std::shared_ptr<const Model>> models, double smoothing) {
  models_ = std::move(models);
  model_ =
      *std::find_if(models_.begin(), models_.end(), [](const auto& m) { return m != nullptr; });
  adjacency_ = adjacencyOf(*model_);
  smoothing_ = smoothing;
  makeFilter();
}

Adjacency PlaceTracker::adjacencyOf(const Model& model) const {
  if (adjacency_path_.empty()) return model.adjacency;
  try {
    return readAdjacency(adjacency_path_, model.places);
  } catch (const Error& e) {
    ROS_ERROR("Any room may adjoin any other, because the map of ~adjacency cannot be used: %s",
              e.what());
    return Adjacency(model.places.size());
  }
}

bool PlaceTracker::counts(std::size_t camera) const {
  return models_[camera] && models_[camera]->places == model_->places;
}

std::string PlaceTracker::whyNotCounted(std::size_t camera) const {
  if (counts(camera) || !models_[camera]) return "";
  return "the places of its model " + models_[camera]->name + " differ from those of " +
         model_->name + ", so it is not used for ~place";
}

Eigen::MatrixXd PlaceTracker::correlation() const {
  if (given_correlation_.size() > 0) return given_correlation_;
  const bool one_model = std::all_of(models_.begin(), models_.end(),
                                     [this](const auto& model) { return model == model_; });
  return coefficientsFor(cameras_, one_model ? model_->cameras : CameraCorrelation());
}

void PlaceTracker::setSmoothing(double smoothing) {
  if (smoothing == smoothing_) return;
  smoothing_ = smoothing;
  if (model_) makeFilter();
}

void PlaceTracker::makeFilter() {
  filter_.reset();
  smoothed_.finish();
  if (smoothing_ <= 0) return;
  TemporalFilterOptions options;
  options.decorrelation_time = smoothing_;
  std::vector<const Model*> models;
  for (std::size_t i = 0; i < cameras_.size(); ++i) {
    models.push_back(counts(i) ? models_[i].get() : model_.get());
  }
  filter_ = std::make_unique<TemporalFilter>(models, correlation(), adjacency_, options);
  smoothed_.follow(adjacency_, options);
}

void PlaceTracker::setUnknownThreshold(double threshold, std::size_t camera) {
  if (filter_) filter_->setUnknownThreshold(threshold, camera);
}

const std::string& PlaceTracker::update(double stamp, const Recognition& recognition,
                                        std::size_t camera) {
  assert(counts(camera));
  static const std::string unknown = kUnknownPlace;
  const std::optional<Motion> motion = way_.take(stamp);
  const int frame_place = recognition.known ? recognition.place : -1;
  const int place =
      filter_ ? filter_->update(stamp, recognition, motion, camera).place : frame_place;
  return place < 0 ? unknown : model_->places[static_cast<std::size_t>(place)];
}

PlaceRecognition PlaceTracker::belief(PlaceRecognition message) const {
  if (filter_) revise(filter_->answer(), message);
  return message;
}

std::vector<PlaceRecognition> PlaceTracker::smooth(const PlaceRecognition& message) {
  if (filter_) smoothed_.add(*filter_, message);
  return smoothed_.take();
}

std::vector<PlaceRecognition> PlaceTracker::reset() {
  if (filter_) filter_->reset();
  smoothed_.finish();
  return smoothed_.take();
}

}  // namespace place_recognition
