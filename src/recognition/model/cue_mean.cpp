#include "recognition/model/cue_mean.h"

namespace place_recognition {

void CueMean::begin(Eigen::Index places) {
  margins_.setZero(places);
  familiarity_ = present_ = 0;
}

void CueMean::add(double weight,
                  const Eigen::Ref<const Eigen::RowVectorXd, 0, Eigen::InnerStride<>>& margins,
                  double familiarity) {
  if (weight == 0) return;
  margins_ += weight * margins;
  familiarity_ += weight * familiarity;
  present_ += weight;
}

bool CueMean::finish() {
  if (present_ == 0) return false;
  margins_ /= present_;
  familiarity_ /= present_;
  return true;
}

}  // namespace place_recognition
