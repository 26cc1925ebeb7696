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

bool isForDescriptors(const KernelType& type) { return type.measure == Measure::kLocalMatch; }

/// Separated by commas.
std::string namesOfTypes(bool for_descriptors) {
  std::string names;
  for (const KernelType& type : kKernelTypes) {
    if (isForDescriptors(type) != for_descriptors) continue;
    names += (names.empty() ? "" : ", ") + std::string(type.name);
  }
  return names;
}

}  // namespace

const KernelType& kernelType(const std::string& name) {
  for (const KernelType& type : kKernelTypes) {
    if (name == type.name) return type;
  }
  throw Error("Unknown kernel type '" + name + "'; use one of: " + namesOfTypes(false) + ", " +
              namesOfTypes(true) + ".");
}

void requireMeaning(const KernelType& type, bool for_descriptors) {
  if (isForDescriptors(type) == for_descriptors) return;
  throw Error(std::string("The kernel '") + type.name + "' has no meaning for " +
              (for_descriptors ? "local descriptors" : "vectors") +
              "; use one of: " + namesOfTypes(for_descriptors) + ".");
}

}  // namespace place_recognition
