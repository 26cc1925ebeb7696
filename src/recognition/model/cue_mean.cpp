#include "recognition/model/cue_mean.h"

namespace place_recognition {

void CueMean::begin(Eigen::Index places) {
  decision_values_.setZero(places);
  unlimited_.setZero(places);
  familiarity_ = present_ = 0;
}

void CueMean::add(
    double weight,
    const Eigen::Ref<const Eigen::RowVectorXd, 0, Eigen::InnerStride<>>& decision_values,
    double familiarity) {
  if (weight == 0) return;
  unlimited_ += weight * decision_values;
  if (limit_ > 0) {
    decision_values_.array() += weight * limit_ * (decision_values.array() / limit_).tanh();
  } else {
    decision_values_ += weight * decision_values;
  }
  familiarity_ += weight * familiarity;
  present_ += weight;
}

bool CueMean::finish() {
  if (present_ == 0) return false;
  decision_values_ /= present_;
  unlimited_ /= present_;
  familiarity_ /= present_;
  return true;
}

}  // namespace place_recognition
