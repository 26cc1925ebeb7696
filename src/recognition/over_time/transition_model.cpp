#include "recognition/over_time/transition_model.h"

#include <algorithm>
#include <cmath>

#include "recognition/model/scores.h"

namespace place_recognition {
namespace {

/// Distribution over the rooms after a change from `room`.
Eigen::RowVectorXd changesFrom(int room, const Adjacency& adjacency, double jump_share) {
  const int rooms = static_cast<int>(adjacency.places());
  Eigen::RowVectorXd anywhere = Eigen::RowVectorXd::Ones(rooms);
  anywhere[room] = rooms == 1 ? 1 : 0;  // a single room can only change to itself
  Eigen::RowVectorXd next_door(rooms);
  for (int other = 0; other < rooms; ++other) next_door[other] = adjacency.adjoin(room, other);
  if (next_door.sum() == 0) next_door = anywhere;
  return jump_share * anywhere / anywhere.sum() + (1 - jump_share) * next_door / next_door.sum();
}

}  // namespace

TransitionModel::TransitionModel(const Adjacency& adjacency, double unknown_share,
                                 double jump_share) {
  const int rooms = static_cast<int>(adjacency.places());
  prior_.setConstant(rooms + 1, (1 - unknown_share) / rooms);
  prior_[rooms] = unknown_share;

  // In equilibrium, as many changes lead to 'unknown' as away from it, where every change leads.
  const double to_unknown = unknown_share / (1 - unknown_share);
  jump_.setZero(rooms + 1, rooms + 1);
  for (int room = 0; room < rooms; ++room) {
    jump_.row(room).head(rooms) = (1 - to_unknown) * changesFrom(room, adjacency, jump_share);
    jump_(room, rooms) = to_unknown;
  }
  jump_.row(rooms).head(rooms).setConstant(1.0 / rooms);
  term_ = next_ = prior_;
}

void TransitionModel::advance(double changes, Eigen::RowVectorXd& belief) {
  step(changes, jump_, belief);
}

void TransitionModel::goBack(double changes, Eigen::RowVectorXd& likelihood) {
  step(changes, jump_.transpose(), likelihood);
}

/// weights exp(changes (jump - I)), normalized to sum 1.
template <typename Matrix>
void TransitionModel::step(double changes, const Matrix& jump, Eigen::RowVectorXd& weights) {
  constexpr double kMany = 100;  // after this many changes, the start no longer matters
  constexpr double kNegligible = 1e-15;
  const double mean = std::min(changes, kMany);
  double weight = std::exp(-mean);
  term_ = weights;
  weights *= weight;
  for (int n = 1; n < mean || weight > kNegligible; ++n) {
    next_.noalias() = term_ * jump;
    term_.swap(next_);
    weight *= mean / n;
    weights += weight * term_;
  }
  weights /= weights.sum();
}

int answeredState(const Eigen::RowVectorXd& belief, double least) {
  const int best = largest(belief);
  return belief[best] < least ? static_cast<int>(belief.size()) - 1 : best;
}

}  // namespace place_recognition
