#include "tuning/cue_comparison.h"

#include <utility>

#include "learning/gram.h"
#include "recognition/training/gamma_choice.h"

namespace place_recognition {
namespace {

/// Of the sigmoid and its like there is no gamma to be found.
bool hasGamma(const KernelOptions& kernel) {
  return kernel.type == "gaussian" || kernel.type == "chi-squared" || kernel.type == "local-match";
}

}  // namespace

CueComparison::CueComparison(CueOptions cue, std::vector<Feature> features,
                             const TuningSamples& samples, unsigned threads)
    : cue_(std::move(cue)), samples_(samples) {
  std::vector<Feature> present;
  std::size_t recorded = 0;
  for (std::size_t i = 0; i < features.size(); ++i) {
    const bool missing = isMissing(features[i]);
    rows_.push_back(missing ? -1 : static_cast<int>(present.size()));
    if (missing) continue;
    present.push_back(std::move(features[i]));
    if (i < samples.recorded) ++recorded;
  }

  const bool open = hasGamma(cue_.kernel) && cue_.kernel.gamma == 0;
  gamma_is_free_ = open && Kernel(cue_.kernel).measureIsFreeOfGamma();
  if (open && !gamma_is_free_) {
    cue_.kernel.gamma = gammaGrid(Kernel(cue_.kernel), measures_).neutral;
  }
  measures_ = measureColumns(Kernel(cue_.kernel), present, recorded, threads);
  neutral_gamma_ = cue_.kernel.gamma;
  if (gamma_is_free_) {
    const Eigen::MatrixXd square = measures_.topRows(static_cast<Eigen::Index>(recorded));
    neutral_gamma_ = gammaGrid(Kernel(cue_.kernel), square).neutral;
  }
}

CueOptions CueComparison::withGamma(double gamma) const {
  CueOptions cue = cue_;
  cue.kernel.gamma = gamma;
  return cue;
}

HeldOut CueComparison::heldOut(double gamma, const SvmOptions& svm, unsigned threads) const {
  const PackedGram gram(Kernel(withGamma(gamma).kernel), measures_, threads);
  ReductionOptions unreduced;
  unreduced.method = "none";
  const Progress silent;
  const TrainingTask task{
      samples_.origins, samples_.places.size(), samples_.folds, svm, threads, silent};
  return std::move(heldOutMargins(gram, rows_, task, {unreduced}).front());
}

}  // namespace place_recognition
