#pragma once

#include <Eigen/Core>

namespace place_recognition {

/// Weighted mean of the decision values and familiarity of one frame's cues. It is divided by the
/// weights of the cues present, which keeps it in the units that the calibration was fitted in.
class CueMean {
 public:
  void begin(Eigen::Index places);

  void add(double weight,
           const Eigen::Ref<const Eigen::RowVectorXd, 0, Eigen::InnerStride<>>& decision_values,
           double familiarity);

  /// Call it after all cues are added; false if there is none.
  bool finish();

  const Eigen::RowVectorXd& decisionValues() const { return decision_values_; }
  double familiarity() const { return familiarity_; }

 private:
  Eigen::RowVectorXd decision_values_;
  double familiarity_ = 0;
  double present_ = 0;
};

}  // namespace place_recognition
