#include "recognition/cue_training.h"

#include "learning/gram.h"
#include "recognition/gamma_choice.h"

namespace place_recognition {
namespace {

/// The samples of one cue and how they compare.
class CueTrainer {
 public:
  CueTrainer(std::vector<Feature> features, const CueOptions& cue, const TrainingTask& task)
      : cue_(cue), task_(task) {
    for (std::size_t i = 0; i < features.size(); ++i) {
      const bool missing = isMissing(features[i]);
      rows_.push_back(missing ? -1 : static_cast<int>(features_.size()));
      if (missing) continue;
      features_.push_back(std::move(features[i]));
      labels_.push_back(task.samples[i].place);
    }
  }

  TrainedCue train(const ReductionOptions& reduction) {
    if (gammaIsOpen()) chooseGamma();
    compare();
    const Eigen::MatrixXd gram = gramMatrix(Kernel(cue_.kernel), measures_);
    report(task_.progress, "Validating", 0);
    HeldOut held_out = heldOutMargins(gram, rows_, task_, reduction);
    report(task_.progress, "Training", 0);
    Machines machines = trainReduced(gram, labels_, task_, reduction);
    return {cue_.kernel.gamma, Classifier(cue_.kernel, std::move(machines), std::move(features_)),
            std::move(held_out)};
  }

 private:
  bool gammaIsOpen() const {
    const std::string& type = cue_.kernel.type;
    const bool has_gamma = type == "gaussian" || type == "chi-squared" || type == "local-match";
    return has_gamma && cue_.kernel.gamma == 0;
  }

  /// Measures of the kernel as it is now; those at hand serve again unless gamma is part of them.
  void compare() {
    const Kernel kernel(cue_.kernel);
    const bool at_hand = measures_.size() > 0 &&
                         (kernel.measureIsFreeOfGamma() || measured_gamma_ == cue_.kernel.gamma);
    if (at_hand) return;
    measures_ = measureMatrix(kernel, features_, task_.threads, task_.progress);
    measured_gamma_ = cue_.kernel.gamma;
  }

  void chooseGamma() {
    if (Kernel(cue_.kernel).measureIsFreeOfGamma()) compare();
    ReductionOptions unreduced;
    unreduced.method = "none";
    const GammaGrid grid = gammaGrid(Kernel(cue_.kernel), measures_);
    std::vector<GammaTrial> trials;
    for (const double gamma : grid.gammas) {
      report(task_.progress, "Choosing gamma",
             static_cast<double>(trials.size()) / static_cast<double>(grid.gammas.size()));
      cue_.kernel.gamma = gamma;
      compare();
      const Eigen::MatrixXd gram = gramMatrix(Kernel(cue_.kernel), measures_);
      const HeldOut held_out = heldOutMargins(gram, rows_, task_, unreduced);
      trials.push_back({gamma, averageRate(held_out, task_.samples, task_.places),
                        averageRateError(held_out, task_.samples, task_.places)});
    }
    cue_.kernel.gamma = place_recognition::chooseGamma(trials, grid.neutral);
  }

  CueOptions cue_;
  const TrainingTask& task_;
  std::vector<int> rows_;          // of each sample among the features; -1: it lacks the cue
  std::vector<Feature> features_;  // none missing
  std::vector<int> labels_;        // of the features
  Eigen::MatrixXd measures_;
  double measured_gamma_ = 0;
};

}  // namespace

TrainedCue trainCue(std::vector<Feature> features, const CueOptions& cue,
                    const ReductionOptions& reduction, const TrainingTask& task) {
  return CueTrainer(std::move(features), cue, task).train(reduction);
}

}  // namespace place_recognition
