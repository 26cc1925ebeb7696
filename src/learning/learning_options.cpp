#include "place_recognition/learning_options.h"

#include <cmath>

#include "learning/kernel_type.h"
#include "place_recognition/error.h"

namespace place_recognition {
namespace {

void require(bool good, const std::string& field, const std::string& range) {
  if (!good) throw Error("Option '" + field + "' is out of range; give " + range + ".");
}

}  // namespace

void KernelOptions::check() const {
  kernelType(type);
  require(std::isfinite(gamma) && gamma >= 0, "kernel.gamma", "a number from 0");
  require(std::isfinite(p), "kernel.p", "a finite number");
  require(d >= 1 && d <= 10, "kernel.d", "a degree 1..10");
  require(std::isfinite(kappa), "kernel.kappa", "a finite number");
  require(std::isfinite(theta), "kernel.theta", "a finite number");
}

void SvmOptions::check() const {
  require(std::isfinite(c) && c > 0, "svm.c", "a number above 0");
  require(multiclass == "one-against-all" || multiclass == "one-against-one", "svm.multiclass",
          "one-against-all or one-against-one");
}

void ReductionOptions::check() const {
  require(method == "none" || method == "qr" || method == "shared-qr" ||
              method == "shared-greedy" || method == "auto",
          "reduction.method", "none, qr, shared-qr, shared-greedy or auto");
  require(tau >= 0 && tau <= 1, "reduction.tau", "a number 0..1");
  require(share >= 0 && share <= 1, "reduction.share", "a number 0..1");
  require(support_vectors >= 0, "reduction.support_vectors", "a whole number from 0");
  require(share == 0 || support_vectors == 0, "reduction.support_vectors",
          "either it or reduction.share");
  require(method != "auto" || (share == 0 && support_vectors == 0), "reduction.method",
          "one that is not auto along with reduction.share or reduction.support_vectors");
}

}  // namespace place_recognition
