#include "learning/kernel_type.h"

#include <algorithm>
#include <iterator>

#include "base/require.h"

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

const KernelType& kernelType(const std::string& name, const std::string& key) {
  const auto type = std::find_if(std::begin(kKernelTypes), std::end(kKernelTypes),
                                 [&](const KernelType& type) { return name == type.name; });
  requireOption(type != std::end(kKernelTypes), key, name,
                "one of: " + namesOfTypes(false) + ", " + namesOfTypes(true));
  return *type;
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
