#pragma once

#include <Eigen/Core>

namespace place_recognition {

/// Weighted mean of what the cues of one frame say. Dividing by the weights of those present keeps
/// it in the units that the calibration was fitted in.
class CueMean {
 public:
  void begin(Eigen::Index places);

  void add(double weight,
           const Eigen::Ref<const Eigen::RowVectorXd, 0, Eigen::InnerStride<>>& decision_values,
           double familiarity);

  /// To be called once all cues are added; false if none counts.
  bool finish();

  const Eigen::RowVectorXd& decisionValues() const { return decision_values_; }
  double familiarity() const { return familiarity_; }

 private:
  Eigen::RowVectorXd decision_values_;
  double familiarity_ = 0;
  double present_ = 0;
};

}  // namespace place_recognition
