#include "learning/kernel_type.h"

#include "place_recognition/error.h"

namespace place_recognition {
namespace {

constexpr KernelType kKernelTypes[] = {
    {"linear", Measure::kDot, Response::kIdentity},
    {"polynomial", Measure::kDot, Response::kPolynomial},
    {"gaussian", Measure::kSquaredDistance, Response::kExponential},
    {"sigmoid", Measure::kDot, Response::kSigmoid},
    {"chi-squared", Measure::kChiSquared, Response::kExponential},
    {"intersection", Measure::kIntersection, Response::kIdentity},
    {"local-match", Measure::kLocalMatch, Response::kIdentity},
};

}  // namespace

const KernelType& kernelType(const std::string& name) {
  for (const KernelType& type : kKernelTypes) {
    if (name == type.name) return type;
  }
  throw Error("Unknown kernel type '" + name + "'; use one of: " + kernelTypeNames(false) + ", " +
              kernelTypeNames(true) + ".");
}

std::string kernelTypeNames(bool of_descriptors) {
  std::string names;
  for (const KernelType& type : kKernelTypes) {
    if ((type.measure == Measure::kLocalMatch) != of_descriptors) continue;
    names += (names.empty() ? "" : ", ") + std::string(type.name);
  }
  return names;
}

}  // namespace place_recognition
