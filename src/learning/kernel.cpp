#include "learning/kernel.h"

#include <algorithm>
#include <cmath>

#include "base/simd.h"
#include "place_recognition/error.h"

namespace place_recognition {
namespace {

/// Sum of term(x_i, y_i) over the bins in which x or y is not zero.
template <typename Term>
double sumOverBins(const SparseVector& x, const SparseVector& y, Term term) {
  double sum = 0;
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < x.size() && j < y.size()) {
    if (x.indices[i] < y.indices[j]) {
      sum += term(x.values[i++], 0);
    } else if (x.indices[i] > y.indices[j]) {
      sum += term(0, y.values[j++]);
    } else {
      sum += term(x.values[i++], y.values[j++]);
    }
  }
  while (i < x.size()) sum += term(x.values[i++], 0);
  while (j < y.size()) sum += term(0, y.values[j++]);
  return sum;
}

template <typename Term>
double sumOverBins(const DenseVector& x, const DenseVector& y, Term term) {
  if (x.values.size() != y.values.size()) {
    throw Error("Cannot compare a vector of " + std::to_string(x.values.size()) +
                " elements with one of " + std::to_string(y.values.size()) +
                "; extract both with the same options.");
  }
  double sum = 0;
  for (std::size_t i = 0; i < x.values.size(); ++i) sum += term(x.values[i], y.values[i]);
  return sum;
}

template <typename Vector>
double measureVectors(Measure measure, const Vector& x, const Vector& y) {
  switch (measure) {
    case Measure::kSquaredDistance:
      return sumOverBins(x, y, [](double a, double b) { return (a - b) * (a - b); });
    case Measure::kChiSquared:
      return sumOverBins(
          x, y, [](double a, double b) { return a + b > 0 ? (a - b) * (a - b) / (a + b) : 0; });
    case Measure::kIntersection:
      return sumOverBins(x, y, [](double a, double b) { return std::min(a, b); });
    default:
      return sumOverBins(x, y, [](double a, double b) { return a * b; });
  }
}

/// Eq. 5.40 with the Gaussian kernel of eq. 5.35 as K_l.
double meanOfBestMatches(const DescriptorSet& x, const DescriptorSet& y, double gamma) {
  constexpr double kUnit = DescriptorSet::kUnit;
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    double best = 0;
    for (std::size_t j = 0; j < y.size(); ++j) {
      double squared_distance = 0;
      for (std::size_t k = 0; k < DescriptorSet::kDimension; ++k) {
        const double difference = (x.row(i)[k] - y.row(j)[k]) / kUnit;
        squared_distance += difference * difference;
      }
      best = std::max(best, std::exp(-gamma * squared_distance));
    }
    sum += best;
  }
  return sum / static_cast<double>(x.size());
}

PLACE_RECOGNITION_TARGET_CLONES
bool hasNegative(const float* values, std::size_t size) {
  std::size_t count = 0;  // of all vectors: examining only some would be slower
  for (std::size_t i = 0; i < size; ++i) count += values[i] < 0;
  return count > 0;
}

template <typename Values>
bool hasNegative(const Values& values) {
  return hasNegative(values.data(), values.size());
}

bool hasNegative(const Feature& feature) {
  if (const auto* sparse = std::get_if<SparseVector>(&feature)) return hasNegative(sparse->values);
  if (const auto* dense = std::get_if<DenseVector>(&feature)) return hasNegative(dense->values);
  return false;
}

}  // namespace

Kernel::Kernel(const KernelOptions& options) : options_(options), type_(kernelType(options.type)) {
  options.check();
}

double Kernel::measure(const Feature& x, const Feature& y) const {
  requireMeaningFor(x);
  requireMeaningFor(y);
  if (x.index() != y.index()) {
    throw Error("Cannot compare features of two kinds; extract both with the same options.");
  }
  if (const auto* sparse = std::get_if<SparseVector>(&x)) {
    return measureVectors(type_.measure, *sparse, std::get<SparseVector>(y));
  }
  if (const auto* dense = std::get_if<DenseVector>(&x)) {
    return measureVectors(type_.measure, *dense, std::get<DenseVector>(y));
  }
  const auto& a = std::get<DescriptorSet>(x);
  const auto& b = std::get<DescriptorSet>(y);
  return 0.5 * (meanOfBestMatches(a, b, options_.gamma) + meanOfBestMatches(b, a, options_.gamma));
}

double Kernel::value(double measure) const {
  switch (type_.response) {
    case Response::kPolynomial:
      return std::pow(measure + options_.p, options_.d);
    case Response::kSigmoid:
      return std::tanh(options_.kappa * measure + options_.theta);
    case Response::kExponential:
      return std::exp(-options_.gamma * measure);
    default:
      return measure;
  }
}

void Kernel::requireMeaningFor(const Feature& feature) const {
  if (isMissing(feature))
    throw Error("An image without this feature cannot be compared; skip the image.");
  const auto* set = std::get_if<DescriptorSet>(&feature);
  requireMeaningFor(set != nullptr, hasNegative(feature));
  if (set && set->size() == 0) {
    throw Error("An empty set of local descriptors cannot be compared; skip such images.");
  }
}

void Kernel::requireMeaningFor(const PostingLists& lists) const {
  requireMeaningFor(false, hasNegative(lists.rows) || hasNegative(lists.values));
}

void Kernel::requireMeaningFor(bool descriptors, bool negative_elements) const {
  requireMeaning(type_, descriptors);
  if (negative_elements) requireSignedMeaning(type_);
}

bool Kernel::measureIsFreeOfGamma() const { return type_.measure != Measure::kLocalMatch; }

}  // namespace place_recognition
