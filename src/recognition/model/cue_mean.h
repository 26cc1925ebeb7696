#pragma once

#include <Eigen/Core>

namespace place_recognition {

/// Weighted means of the decision values f and the familiarity of one frame's cues. They are
/// divided by the weights of the cues present, which keeps them in the units that the calibration
/// was fitted in.
class CueMean {
 public:
  /// `limit`: see Model::decision_limit.
  explicit CueMean(double limit) : limit_(limit) {}

  void begin(Eigen::Index places);

  void add(double weight,
           const Eigen::Ref<const Eigen::RowVectorXd, 0, Eigen::InnerStride<>>& decision_values,
           double familiarity);

  /// Call it after all cues are added; false if there is none.
  bool finish();

  /// The mean of limit tanh(f / limit), or of f if the limit is 0. It names the place.
  const Eigen::RowVectorXd& decisionValues() const { return decision_values_; }
  /// The mean of f. It tells how evident the place is: large values are rare in unknown buildings.
  const Eigen::RowVectorXd& unlimited() const { return unlimited_; }
  double familiarity() const { return familiarity_; }

 private:
  double limit_;
  Eigen::RowVectorXd decision_values_;
  Eigen::RowVectorXd unlimited_;
  double familiarity_ = 0;
  double present_ = 0;
};

}  // namespace place_recognition
