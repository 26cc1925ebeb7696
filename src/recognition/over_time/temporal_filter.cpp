#include "place_recognition/temporal_filter.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "place_recognition/camera_correlation.h"
#include "recognition/over_time/transition_model.h"

namespace place_recognition {
namespace {

/// The fraction of each place among the training images; equal fractions if the model does not
/// state them. Counting one additional image of each keeps a place without any from having infinite
/// weight.
Eigen::RowVectorXd trainingFractions(const Model& model) {
  const std::vector<std::uint64_t>& images = model.provenance.place_images;
  Eigen::RowVectorXd fractions = Eigen::RowVectorXd::Ones(static_cast<int>(model.places.size()));
  if (images.size() == model.places.size()) {
    for (std::size_t k = 0; k < images.size(); ++k) {
      fractions[static_cast<int>(k)] += static_cast<double>(images[k]);
    }
  }
  return fractions / fractions.sum();
}

}  // namespace

TemporalFilter::TemporalFilter(const Model& model, const Adjacency& adjacency,
                               const TemporalFilterOptions& options)
    : TemporalFilter({&model}, Eigen::MatrixXd::Ones(1, 1), adjacency, options) {}

TemporalFilter::TemporalFilter(const std::vector<const Model*>& models,
                               const Eigen::MatrixXd& correlation, const Adjacency& adjacency,
                               const TemporalFilterOptions& options)
    : options_(options), correlation_(correlation) {
  assert(!models.empty() && models.size() <= kMaxCameras);
  assert(correlation.rows() == static_cast<Eigen::Index>(models.size()) &&
         correlation.cols() == correlation.rows());
  options_.check();
  for (const Model* model : models) {
    assert(adjacency.places() == model->places.size());
    cameras_.push_back({trainingFractions(*model)});
    setUnknownThreshold(model->unknown_threshold, cameras_.size() - 1);
  }
  chain_ =
      std::make_unique<TransitionModel>(adjacency, options_.unknown_share, options_.jump_share);
  step_.likelihoods = answer_.probabilities = chain_->prior();
}

TemporalFilter::~TemporalFilter() = default;
TemporalFilter::TemporalFilter(TemporalFilter&&) noexcept = default;
TemporalFilter& TemporalFilter::operator=(TemporalFilter&&) noexcept = default;

void TemporalFilter::setUnknownThreshold(double threshold, std::size_t camera) {
  assert(!std::isnan(threshold));
  cameras_[camera].unknown_threshold = std::clamp(threshold, 0.01, 0.99);
}

const FilteredAnswer& TemporalFilter::update(double stamp, const Recognition& recognition,
                                             const std::optional<Motion>& motion,
                                             std::size_t camera) {
  assert(std::isfinite(stamp) && camera < cameras_.size());
  const double elapsed = stamp - step_.stamp;
  const bool back = cameras_[camera].stamp && stamp < *cameras_[camera].stamp;
  step_.first = !started_ || back || std::abs(elapsed) > options_.maximum_gap;
  if (step_.first) {
    step_.stamp = stamp;
    start();
  } else {
    step_.stamp = std::max(step_.stamp, stamp);
    move(std::max(elapsed, 0.0), motion);
  }
  cameras_[camera].stamp = stamp;
  weigh(recognition, camera);
  decide();
  return answer_;
}

void TemporalFilter::start() {
  started_ = true;
  for (Camera& camera : cameras_) {
    camera.new_fraction = 1;
    camera.stamp.reset();
    camera.told.reset();
  }
  step_.changes = 0;
  answer_.probabilities = chain_->prior();
}

void TemporalFilter::move(double elapsed, const std::optional<Motion>& motion) {
  step_.changes = elapsed / options_.dwell_time;
  double new_fraction = elapsed / options_.decorrelation_time;
  if (motion) {
    assert(motion->distance >= 0 && motion->angle >= 0);
    step_.changes = motion->distance / options_.dwell_distance;
    new_fraction = motion->distance / options_.decorrelation_distance +
                   motion->angle / options_.decorrelation_angle;
  }
  chain_->advance(step_.changes, answer_.probabilities);
  for (Camera& camera : cameras_)
    camera.new_fraction = std::min(1.0, camera.new_fraction + new_fraction);
}

/// The fraction of a camera's information that no other camera provides at the same moment.
double TemporalFilter::independentFraction(std::size_t camera) const {
  double sum = 1;
  for (std::size_t other = 0; other < cameras_.size(); ++other) {
    const std::optional<double>& told = cameras_[other].told;
    if (other == camera || !told || step_.stamp - *told > options_.camera_gap) continue;
    sum += correlation_(static_cast<Eigen::Index>(camera), static_cast<Eigen::Index>(other));
  }
  return 1 / sum;
}

void TemporalFilter::weigh(const Recognition& recognition, std::size_t number) {
  Eigen::RowVectorXd& likelihoods = step_.likelihoods;
  if (recognition.place < 0) {  // no feature, nothing seen: the new part is left to the next frame
    likelihoods.setOnes();
    return;
  }
  const Eigen::Index rooms = recognition.probabilities.size();
  assert(rooms + 1 == likelihoods.size());
  Camera& camera = cameras_[number];
  const double outliers = options_.outlier_share;
  const auto tempered = [outliers](double ratio) { return (1 - outliers) * ratio + outliers; };
  const double any_room = tempered(recognition.evidence / camera.unknown_threshold);
  auto by_room = likelihoods.head(rooms).array();
  by_room = (recognition.probabilities.array() / camera.room_fractions.array()).unaryExpr(tempered);
  by_room *= any_room / by_room.maxCoeff();
  likelihoods[rooms] = tempered((1 - recognition.evidence) / (1 - camera.unknown_threshold));
  likelihoods = likelihoods.array().pow(camera.new_fraction * independentFraction(number));

  answer_.probabilities.array() *= likelihoods.array();
  answer_.probabilities /= answer_.probabilities.sum();
  camera.new_fraction = 0;
  camera.told = step_.stamp;
}

void TemporalFilter::decide() {
  const Eigen::RowVectorXd& belief = answer_.probabilities;
  const int unknown = static_cast<int>(belief.size()) - 1;
  const int best = answeredState(belief, options_.minimum_confidence);

  const bool long_enough = step_.stamp - answer_since_ >= options_.minimum_dwell;
  answer_.changed = step_.first || (best != state_ && long_enough);
  if (answer_.changed) {
    state_ = best;
    answer_since_ = step_.stamp;
  }
  answer_.place = state_ == unknown ? -1 : state_;
  answer_.confidence = belief[state_];
}

}  // namespace place_recognition
