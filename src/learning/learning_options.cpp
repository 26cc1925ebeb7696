#include "place_recognition/learning_options.h"

#include <cmath>
#include <iterator>

#include "base/contains.h"
#include "base/require.h"
#include "base/text.h"
#include "learning/kernel_type.h"
#include "learning/reduction.h"

namespace place_recognition {

void KernelOptions::check() const {
  kernelType(type);
  requireOption(std::isfinite(gamma) && gamma >= 0, "kernel.gamma", "a number from 0");
  requireOption(std::isfinite(p), "kernel.p", "a finite number");
  requireOption(d >= 1 && d <= 10, "kernel.d", "a degree 1..10");
  requireOption(std::isfinite(kappa), "kernel.kappa", "a finite number");
  requireOption(std::isfinite(theta), "kernel.theta", "a finite number");
}

bool KernelOptions::hasGamma() const { return place_recognition::hasGamma(kernelType(type)); }

void SvmOptions::check() const {
  requireOption(std::isfinite(c) && c > 0, "svm.c", "a number above 0");
  requireOption(multiclass == "one-against-all" || multiclass == "one-against-one",
                "svm.multiclass", "one-against-all or one-against-one");
}

void ReductionOptions::check() const {
  requireOption(
      method == "none" || method == "auto" || contains(kReductionMethods, method),
      "reduction.method",
      "none, " + listed({std::begin(kReductionMethods), std::end(kReductionMethods)}) + " or auto");
  requireOption(tau >= 0 && tau <= 1, "reduction.tau", "a number 0..1");
  requireOption(share >= 0 && share <= 1, "reduction.share", "a number 0..1");
  requireOption(support_vectors >= 0, "reduction.support_vectors", "a whole number from 0");
  requireOption(share == 0 || support_vectors == 0, "reduction.support_vectors",
                "either it or reduction.share");
  requireOption(
      method != "auto" || (share == 0 && support_vectors == 0 && tau == ReductionOptions().tau),
      "reduction.method",
      "one that is not auto along with reduction.tau, reduction.share or "
      "reduction.support_vectors");
}

}  // namespace place_recognition
