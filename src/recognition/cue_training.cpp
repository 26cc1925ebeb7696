#include "recognition/cue_training.h"

#include "learning/gram.h"
#include "recognition/gamma_choice.h"

namespace place_recognition {
namespace {

/// The samples of one cue and how they compare.
class CueTrainer {
 public:
  CueTrainer(std::vector<Feature> features, const std::vector<SampleOrigin>& samples,
             std::size_t places, const std::vector<Fold>& folds, const CueOptions& cue,
             const TrainingOptions& options, unsigned threads, const Progress& progress)
      : samples_(samples),
        places_(places),
        folds_(folds),
        cue_(cue),
        options_(options),
        threads_(threads),
        progress_(progress) {
    for (std::size_t i = 0; i < features.size(); ++i) {
      const bool missing = isMissing(features[i]);
      rows_.push_back(missing ? -1 : static_cast<int>(features_.size()));
      if (missing) continue;
      features_.push_back(std::move(features[i]));
      labels_.push_back(samples[i].place);
    }
  }

  TrainedCue train() {
    compare();
    if (gammaIsOpen()) chooseGamma();
    const Eigen::MatrixXd gram = gramMatrix(Kernel(cue_.kernel), measures_);
    report(progress_, "Validating", 0);
    HeldOut held_out = heldOut(gram, options_);
    report(progress_, "Training", 0);
    Machines machines = trainReduced(gram, labels_, places_, options_, threads_);
    return {cue_.kernel.gamma, Classifier(cue_.kernel, std::move(machines), std::move(features_)),
            std::move(held_out)};
  }

 private:
  bool gammaIsOpen() const {
    const std::string& type = cue_.kernel.type;
    const bool has_gamma = type == "gaussian" || type == "chi-squared" || type == "local-match";
    return has_gamma && cue_.kernel.gamma == 0;
  }

  void compare() {
    KernelOptions kernel = cue_.kernel;
    if (gammaIsOpen()) kernel.gamma = 1;
    measures_ = measureMatrix(Kernel(kernel), features_, threads_, progress_);
  }

  void chooseGamma() {
    const GammaGrid grid = gammaGrid(Kernel(cue_.kernel), measures_);
    TrainingOptions unreduced = options_;
    unreduced.reduction.method = "none";
    std::vector<GammaTrial> trials;
    for (const double gamma : grid.gammas) {
      report(progress_, "Choosing gamma",
             static_cast<double>(trials.size()) / static_cast<double>(grid.gammas.size()));
      setGamma(gamma);
      const HeldOut held_out = heldOut(gramMatrix(Kernel(cue_.kernel), measures_), unreduced);
      trials.push_back({gamma, averageRate(held_out, samples_, places_),
                        averageRateError(held_out, samples_, places_)});
    }
    setGamma(place_recognition::chooseGamma(trials, grid.neutral));
  }

  void setGamma(double gamma) {
    cue_.kernel.gamma = gamma;
    const Kernel kernel(cue_.kernel);
    if (kernel.measureIsFreeOfGamma()) return;
    measures_ = measureMatrix(kernel, features_, threads_, progress_);
  }

  HeldOut heldOut(const Eigen::MatrixXd& gram, const TrainingOptions& options) const {
    return heldOutMargins(gram, rows_, samples_, places_, folds_, options, threads_);
  }

  const std::vector<SampleOrigin>& samples_;
  const std::size_t places_;
  const std::vector<Fold>& folds_;
  CueOptions cue_;
  const TrainingOptions& options_;
  const unsigned threads_;
  const Progress& progress_;
  std::vector<int> rows_;          // of each sample among the features; -1: it lacks the cue
  std::vector<Feature> features_;  // none missing
  std::vector<int> labels_;        // of the features
  Eigen::MatrixXd measures_;
};

}  // namespace

TrainedCue trainCue(std::vector<Feature> features, const std::vector<SampleOrigin>& samples,
                    std::size_t places, const std::vector<Fold>& folds, const CueOptions& cue,
                    const TrainingOptions& options, unsigned threads, const Progress& progress) {
  return CueTrainer(std::move(features), samples, places, folds, cue, options, threads, progress)
      .train();
}

}  // namespace place_recognition
