#include "recognition/training/reduction_sweep.h"

#include <algorithm>

namespace place_recognition {
namespace {

int mostVectors(const Model& model) {
  std::size_t most = 1;
  for (const Classifier& classifier : model.classifiers) {
    most = std::max(most, classifier.supportVectorCount());
  }
  return static_cast<int>(most);
}

/// Options limited only by the number of existing vectors.
ReductionOptions unlimited(ReductionOptions options) {
  options.share = 1;
  options.support_vectors = 0;
  return options;
}

}  // namespace

ReductionSweep::ReductionSweep(const Model& model, const ModelReduction& reduction,
                               const RateOnSamples& rate, ReductionOptions options,
                               const Progress& progress)
    : rate_(rate),
      most_(mostVectors(model)),
      reductions_(reduction.factorize(unlimited(std::move(options)), progress)) {}

double ReductionSweep::rate(int vectors) const {
  std::vector<BinarySvms> machines;
  for (const auto& cue : reductions_) machines.push_back(cue->withVectors(vectors));
  return rate_(machines);
}

int ReductionSweep::fewest(double wanted, const Progress& progress) const {
  int enough = 1;
  int too_few = 0;
  while (enough < most_ && rate(enough) < wanted) {
    report(progress, "Searching for the fewest vectors", static_cast<double>(enough) / most_);
    too_few = enough;
    enough = std::min(most_, enough + 1 + enough / 50);
  }
  for (int vectors = too_few + 1; vectors < enough; ++vectors) {
    if (rate(vectors) >= wanted) return vectors;
  }
  return enough;
}

std::vector<std::pair<double, double>> ReductionSweep::curve() const {
  constexpr int kPoints = 40;
  std::vector<std::pair<double, double>> points;
  for (int i = 1; i <= kPoints; ++i) {
    const int vectors = std::max(1, most_ * i / kPoints);
    points.emplace_back(static_cast<double>(vectors) / most_, rate(vectors));
  }
  return points;
}

}  // namespace place_recognition
