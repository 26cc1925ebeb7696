#include "place_recognition/temporal_filter.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "recognition/over_time/transition_model.h"

namespace place_recognition {
namespace {

/// The share of each place among the training images, equal ones if the model does not tell.
/// Counting one image more for each keeps a place without any from counting infinitely.
Eigen::RowVectorXd trainingShares(const Model& model) {
  const std::vector<std::uint64_t>& images = model.provenance.place_images;
  Eigen::RowVectorXd shares = Eigen::RowVectorXd::Ones(static_cast<int>(model.places.size()));
  if (images.size() == model.places.size()) {
    for (std::size_t k = 0; k < images.size(); ++k) {
      shares[static_cast<int>(k)] += static_cast<double>(images[k]);
    }
  }
  return shares / shares.sum();
}

}  // namespace

TemporalFilter::TemporalFilter(const Model& model, const Adjacency& adjacency,
                               const TemporalFilterOptions& options)
    : options_(options), room_shares_(trainingShares(model)) {
  assert(adjacency.places() == model.places.size());
  options_.check();
  chain_ =
      std::make_unique<TransitionModel>(adjacency, options_.unknown_share, options_.jump_share);
  setUnknownThreshold(model.unknown_threshold);
  step_.likelihoods = answer_.probabilities = chain_->prior();
}

TemporalFilter::~TemporalFilter() = default;
TemporalFilter::TemporalFilter(TemporalFilter&&) noexcept = default;
TemporalFilter& TemporalFilter::operator=(TemporalFilter&&) noexcept = default;

void TemporalFilter::setUnknownThreshold(double threshold) {
  unknown_threshold_ = std::clamp(threshold, 0.01, 0.99);
}

const FilteredAnswer& TemporalFilter::update(double stamp, const Recognition& recognition,
                                             const std::optional<Motion>& motion) {
  assert(std::isfinite(stamp));
  const double elapsed = stamp - step_.stamp;
  step_.stamp = stamp;
  step_.first = !started_ || elapsed < 0 || elapsed > options_.maximum_gap;
  if (step_.first) {
    start();
  } else {
    move(elapsed, motion);
  }
  weigh(recognition);
  decide();
  return answer_;
}

void TemporalFilter::start() {
  started_ = true;
  new_share_ = 1;
  step_.changes = 0;
  answer_.probabilities = chain_->prior();
}

void TemporalFilter::move(double elapsed, const std::optional<Motion>& motion) {
  step_.changes = elapsed / options_.dwell_time;
  double new_share = elapsed / options_.decorrelation_time;
  if (motion) {
    assert(motion->distance >= 0 && motion->angle >= 0);
    step_.changes = motion->distance / options_.dwell_distance;
    new_share = motion->distance / options_.decorrelation_distance +
                motion->angle / options_.decorrelation_angle;
  }
  chain_->advance(step_.changes, answer_.probabilities);
  new_share_ = std::min(1.0, new_share_ + new_share);
}

void TemporalFilter::weigh(const Recognition& recognition) {
  Eigen::RowVectorXd& likelihoods = step_.likelihoods;
  if (recognition.place < 0) {  // no feature, nothing seen: what is new waits for the next
    likelihoods.setOnes();
    return;
  }
  const Eigen::Index rooms = recognition.probabilities.size();
  assert(rooms + 1 == likelihoods.size());
  const double outliers = options_.outlier_share;
  const auto tempered = [outliers](double ratio) { return (1 - outliers) * ratio + outliers; };
  const double any_room = tempered(recognition.evidence / unknown_threshold_);
  auto by_room = likelihoods.head(rooms).array();
  by_room = (recognition.probabilities.array() / room_shares_.array()).unaryExpr(tempered);
  by_room *= any_room / by_room.maxCoeff();
  likelihoods[rooms] = tempered((1 - recognition.evidence) / (1 - unknown_threshold_));
  likelihoods = likelihoods.array().pow(new_share_);

  answer_.probabilities.array() *= likelihoods.array();
  answer_.probabilities /= answer_.probabilities.sum();
  new_share_ = 0;
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
