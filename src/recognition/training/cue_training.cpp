#include "recognition/training/cue_training.h"

#include <cmath>

#include "learning/gram.h"
#include "place_recognition/error.h"
#include "recognition/training/gamma_choice.h"
#include "recognition/training/sampling.h"

namespace place_recognition {
namespace {

/// Maximum number of samples for the search of gamma: more do not move the plateau from which it is
/// chosen. Fewer are used if every gamma needs its own matrix of measures.
constexpr std::size_t kSamplesForSearch = 2000;
constexpr std::size_t kSamplesForCostlySearch = 120;

/// The features of at most `count` samples, but one of each place; the others become missing.
std::vector<Feature> thinnedOut(std::vector<Feature> features, const TrainingTask& task,
                                std::size_t count) {
  std::vector<int> places;
  for (const SampleOrigin& sample : task.samples) places.push_back(sample.place);
  const std::vector<bool> kept = stratifiedSample(places, count, task.seed);
  for (std::size_t i = 0; i < features.size(); ++i) {
    if (!kept[i]) features[i] = {};
  }
  return features;
}

/// The samples of one cue and their comparisons.
class CueTrainer {
 public:
  CueTrainer(std::vector<Feature> features, const CueOptions& cue, const TrainingTask& task)
      : cue_(cue), task_(task) {
    for (std::size_t i = 0; i < features.size(); ++i) {
      const bool missing = isMissing(features[i]);
      rows_.push_back(missing ? -1 : static_cast<int>(features_.size()));
      if (missing) continue;
      features_.push_back(std::move(features[i]));
      samples_.push_back(static_cast<int>(i));
    }
  }

  void setGamma(double gamma) { cue_.kernel.gamma = gamma; }

  /// The gamma of the kernel, found by cross-validation.
  double searchGamma() {
    if (Kernel(cue_.kernel).measureIsFreeOfGamma()) compare();
    ReductionOptions unreduced;
    unreduced.method = "none";
    const GammaGrid grid = gammaGrid(Kernel(cue_.kernel), measures_);
    std::vector<GammaTrial> trials;
    for (const double gamma : grid.gammas) {
      report(task_.progress, "Choosing gamma",
             static_cast<double>(trials.size()) / static_cast<double>(grid.gammas.size()));
      setGamma(gamma);
      compare();
      const PackedGram gram(Kernel(cue_.kernel), measures_, task_.threads);
      const HeldOutValues held_out = crossValidate(gram, rows_, task_, {unreduced}).front();
      const RoomMean rate = roomRates(held_out, task_.samples, task_.places);
      trials.push_back({gamma, rate.mean, rate.standard_error});
    }
    return chooseGamma(trials, grid.neutral);
  }

  TrainedCue train(const std::vector<ReductionOptions>& reductions) {
    compare();
    const PackedGram gram(Kernel(cue_.kernel), measures_, task_.threads);
    requireBounded(gram);
    std::vector<HeldOutValues> held_out =
        crossValidate(gram, rows_, task_, reductions, task_.progress);
    ReducedMachines reduced = trainReduced(gram, samples_, task_, reductions);
    std::vector<Feature> vectors;
    std::vector<VectorOrigin> origins;
    for (const int i : reduced.vectors) {
      vectors.push_back(std::move(features_[static_cast<std::size_t>(i)]));
      const int sample = samples_[static_cast<std::size_t>(i)];
      const SampleOrigin& origin = task_.samples[static_cast<std::size_t>(sample)];
      origins.push_back({origin.place, origin.age});
    }
    return {cue_.kernel.gamma, std::move(vectors), std::move(origins), std::move(reduced.machines),
            std::move(held_out)};
  }

 private:
  /// Throws Error if the kernel has values on which no machine can be trained.
  void requireBounded(const PackedGram& gram) const {
    constexpr double kLargest = 1e30;  // its square is far from overflow
    for (Eigen::Index i = 0; i < gram.rows(); ++i) {
      for (Eigen::Index j = 0; j < gram.columns(); ++j) {
        if (std::abs(gram(i, j)) <= kLargest) continue;
        throw Error("The kernel of cue '" + cue_.name + "' (" + cue_.kernel.type +
                    ") has values beyond 1e30 on these images; choose smaller parameters, for "
                    "the polynomial kernel cues." +
                    cue_.name + ".kernel.p and d.");
      }
    }
  }

  /// Measures of the current kernel; existing ones are reused unless they depend on gamma.
  void compare() {
    const Kernel kernel(cue_.kernel);
    const bool at_hand = measures_.size() > 0 &&
                         (kernel.measureIsFreeOfGamma() || measured_gamma_ == cue_.kernel.gamma);
    if (at_hand) return;
    measures_ = measureMatrix(kernel, features_, task_.threads, task_.progress);
    measured_gamma_ = cue_.kernel.gamma;
  }

  CueOptions cue_;
  const TrainingTask& task_;
  std::vector<int> rows_;          // by sample: index among the features; -1: it lacks the cue
  std::vector<Feature> features_;  // none missing
  std::vector<int> samples_;       // of the features
  Eigen::MatrixXd measures_;
  double measured_gamma_ = 0;
};

}  // namespace

TrainedCue trainCue(std::vector<Feature> features, const CueOptions& cue,
                    const std::vector<ReductionOptions>& reductions, const TrainingTask& task) {
  double gamma = cue.kernel.gamma;
  const bool gamma_is_open = cue.kernel.hasGamma() && gamma == 0;
  const bool costly = !Kernel(cue.kernel).measureIsFreeOfGamma();
  const std::size_t enough = costly ? kSamplesForCostlySearch : kSamplesForSearch;
  const bool search_apart = costly || features.size() > enough;
  if (gamma_is_open && search_apart) {
    gamma = CueTrainer(thinnedOut(features, task, enough), cue, task).searchGamma();
  }
  CueTrainer trainer(std::move(features), cue, task);
  if (gamma_is_open && !search_apart) gamma = trainer.searchGamma();
  trainer.setGamma(gamma);
  return trainer.train(reductions);
}

}  // namespace place_recognition
