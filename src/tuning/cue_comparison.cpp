#include "tuning/cue_comparison.h"

#include <utility>

#include "learning/gram.h"
#include "recognition/training/cross_validation.h"
#include "recognition/training/gamma_choice.h"

namespace place_recognition {

CueComparison::CueComparison(CueOptions cue, std::vector<Feature> features,
                             const TuningSamples& samples, unsigned threads)
    : cue_(std::move(cue)), kernel_(cue_.kernel), samples_(samples) {
  std::vector<Feature> present;
  std::size_t recorded = 0;
  for (std::size_t i = 0; i < features.size(); ++i) {
    const bool missing = isMissing(features[i]);
    rows_.push_back(missing ? -1 : static_cast<int>(present.size()));
    if (missing) continue;
    present.push_back(std::move(features[i]));
    if (i < samples.recorded) ++recorded;
  }

  const bool open = kernel_.hasGamma() && kernel_.gamma == 0;
  const bool measures_have_gamma = !Kernel(kernel_).measureIsFreeOfGamma();
  if (open && measures_have_gamma) kernel_.gamma = gammaGrid(Kernel(kernel_), measures_).neutral;
  measures_ = measureColumns(Kernel(kernel_), present, recorded, threads);
  if (open && !measures_have_gamma) {
    const Eigen::MatrixXd square = measures_.topRows(static_cast<Eigen::Index>(recorded));
    kernel_.gamma = gammaGrid(Kernel(kernel_), square).neutral;
  }
}

HeldOutValues CueComparison::heldOut(const SvmOptions& svm, unsigned threads) const {
  const PackedGram gram(Kernel(kernel_), measures_, threads);
  ReductionOptions unreduced;
  unreduced.method = "none";
  const Progress silent;
  const TrainingTask task{
      samples_.origins, samples_.places.size(), samples_.folds, svm, threads, silent};
  return std::move(crossValidate(gram, rows_, task, {unreduced}).front());
}

}  // namespace place_recognition
