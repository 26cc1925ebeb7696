#include "recognition/evidence.h"

namespace place_recognition {

double evidence(const Calibration& calibration, const Eigen::RowVectorXd& margins) {
  return calibration.sigmoids(margins).maxCoeff();
}

}  // namespace place_recognition
