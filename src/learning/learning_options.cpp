#include "place_recognition/learning_options.h"

#include <cmath>
#include <iterator>

#include "base/contains.h"
#include "base/require.h"
#include "base/text.h"
#include "learning/kernel_type.h"
#include "learning/reduction.h"

namespace place_recognition {

void KernelOptions::check(const std::string& key) const {
  kernelType(type, key + ".type");
  requireOption(std::isfinite(gamma) && gamma >= 0, key + ".gamma", gamma, "a number from 0");
  requireOption(std::isfinite(p), key + ".p", p, "a finite number");
  requireOption(d >= 1 && d <= 10, key + ".d", d, "1 to 10");
  requireOption(std::isfinite(kappa), key + ".kappa", kappa, "a finite number");
  requireOption(std::isfinite(theta), key + ".theta", theta, "a finite number");
}

bool KernelOptions::hasGamma() const { return place_recognition::hasGamma(kernelType(type)); }

void SvmOptions::check() const {
  requireOption(std::isfinite(c) && c > 0, "svm.c", c, "a number above 0");
  requireOption(multiclass == "one-against-all" || multiclass == "one-against-one",
                "svm.multiclass", multiclass, "one-against-all or one-against-one");
}

void ReductionOptions::check() const {
  requireOption(
      method == "none" || method == "auto" || contains(kReductionMethods, method),
      "reduction.method", method,
      "none, " + listed({std::begin(kReductionMethods), std::end(kReductionMethods)}) + " or auto");
  requireOption(tau >= 0 && tau <= 1, "reduction.tau", tau, "0 to 1");
  requireOption(share >= 0 && share <= 1, "reduction.share", share, "0 to 1");
  requireOption(support_vectors >= 0, "reduction.support_vectors", support_vectors,
                "a whole number from 0");
  requireNotBoth(share > 0, "reduction.share", support_vectors > 0, "reduction.support_vectors");
  const std::string automatic = "reduction.method=auto";
  requireNotBoth(method == "auto", automatic, tau != ReductionOptions().tau, "reduction.tau");
  requireNotBoth(method == "auto", automatic, share > 0, "reduction.share");
  requireNotBoth(method == "auto", automatic, support_vectors > 0, "reduction.support_vectors");
}

}  // namespace place_recognition
