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

bool isForHistograms(const KernelType& type) {
  return type.measure == Measure::kChiSquared || type.measure == Measure::kIntersection;
}

/// Names of the types that satisfy `belongs`, separated by commas.
template <typename Predicate>
std::string namesOfTypes(const Predicate& belongs) {
  std::string names;
  for (const KernelType& type : kKernelTypes) {
    if (belongs(type)) names += (names.empty() ? "" : ", ") + std::string(type.name);
  }
  return names;
}

std::string namesOfTypes(bool for_descriptors) {
  return namesOfTypes(
      [=](const KernelType& type) { return isForDescriptors(type) == for_descriptors; });
}

}  // namespace

const KernelType& kernelType(const std::string& name) {
  for (const KernelType& type : kKernelTypes) {
    if (name == type.name) return type;
  }
  throw Error("Unknown kernel type '" + name + "'; use one of: " + namesOfTypes(false) + ", " +
              namesOfTypes(true) + ".");
}

bool hasGamma(const KernelType& type) {
  return type.response == Response::kExponential || type.measure == Measure::kLocalMatch;
}

void requireMeaning(const KernelType& type, bool for_descriptors) {
  if (isForDescriptors(type) == for_descriptors) return;
  throw Error(std::string("The kernel '") + type.name + "' is not defined for " +
              (for_descriptors ? "local descriptors" : "vectors") +
              "; use one of: " + namesOfTypes(for_descriptors) + ".");
}

void requireSignedMeaning(const KernelType& type) {
  if (!isForHistograms(type)) return;
  const std::string others = namesOfTypes(
      [](const KernelType& other) { return !isForHistograms(other) && !isForDescriptors(other); });
  throw Error(std::string("The kernel '") + type.name +
              "' is not defined for negative elements; use one of: " + others + ".");
}

}  // namespace place_recognition
