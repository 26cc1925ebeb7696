#pragma once

#include <Eigen/Core>
#include <vector>

#include "learning/kernel.h"

namespace place_recognition {

/// Candidate values of gamma, and the one that is plausible a priori.
struct GammaGrid {
  std::vector<double> gammas;
  double neutral = 1;
};

/// Powers of two around the neutral gamma. For exp(-gamma m) this is one over twice the typical
/// measure m between two samples, which fits the grid to any feature. For the local kernel, whose
/// measures depend on gamma and are expensive, a few values around that of the thesis (Table 8.2);
/// `measures` may be empty then.
GammaGrid gammaGrid(const Kernel& kernel, const Eigen::MatrixXd& measures);

/// The score of a gamma on held-out samples.
struct GammaTrial {
  double gamma;
  double rate;            ///< mean of the rooms' rates
  double standard_error;  ///< of that mean
};

/// The gamma closest to the neutral one, by ratio, among those whose rate is within one standard
/// error of the best. Held-out blocks of the same recordings cannot distinguish these, and the
/// extremes of such a plateau often fail on the next recording. `trials` is not empty.
double chooseGamma(const std::vector<GammaTrial>& trials, double neutral);

}  // namespace place_recognition
