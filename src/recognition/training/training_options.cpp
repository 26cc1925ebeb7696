#include "place_recognition/training_options.h"

#include <set>
#include <utility>

#include "base/data_folder.h"
#include "base/require.h"
#include "base/text.h"
#include "learning/folds.h"
#include "learning/kernel_type.h"
#include "recognition/frames/colour_normalization.h"

namespace place_recognition {
namespace {

/// Throws Error unless the kernel of the cue is defined for its feature.
void requireMatchingKernel(const CueOptions& cue) {
  const KernelType& kernel = kernelType(cue.kernel.type);
  try {
    requireMeaning(kernel, std::holds_alternative<LocalFeatureOptions>(cue.feature));
    if (std::holds_alternative<EmbeddingOptions>(cue.feature)) requireSignedMeaning(kernel);
  } catch (const Error& e) {
    throw Error("Cue '" + cue.name + "': " + e.what());
  }
}

void checkCue(const CueOptions& cue) {
  requireOption(isPlainName(cue.name), "cues.name", cue.name, kPlainNameRule);
  const std::string key = "cues." + cue.name;
  colourNormalization(cue.normalize, key + ".normalize");
  requireOption(cue.weight >= 0.01 && cue.weight <= 100, key + ".weight", cue.weight,
                "0.01 to 100");
  std::visit([&](const auto& feature) { feature.check(key + ".feature"); }, cue.feature);
  cue.kernel.check(key + ".kernel");
  requireMatchingKernel(cue);
}

constexpr double kMaxSeconds = 1e6;
constexpr const char* kSecondsRule = "0 to 1000000 seconds";

/// A cue with a composed receptive field histogram and the chi-squared kernel.
CueOptions histogramCue(const std::string& name, const std::string& normalize,
                        const std::vector<std::string>& descriptors,
                        const std::vector<double>& scales, int bins, const std::string& levels) {
  CrfhOptions crfh;
  crfh.descriptors = descriptors;
  crfh.scales = scales;
  crfh.bins = {bins};
  crfh.levels = levels;
  CueOptions cue;
  cue.name = name;
  cue.normalize = normalize;
  cue.feature = crfh;
  return cue;
}

CueOptions directionsCue() {
  CueOptions cue;
  cue.name = "directions";
  cue.weight = 0.5;
  cue.feature = HogOptions();
  return cue;
}

}  // namespace

std::vector<CueOptions> defaultCues() {
  return {
      histogramCue("colours", "run", {"L", "C1", "C2"}, {4}, 16, "linear"),
      histogramCue("tints", "grey-world", {"R", "G", "B"}, {1}, 16, "linear"),
      histogramCue("edges", "none", {"Rx", "Ry", "Gx", "Gy", "Bx", "By"}, {4}, 14, "logarithmic"),
      histogramCue("shapes", "none", {"Lxx", "Lxy", "Lyy"}, {1, 4}, 28, "logarithmic"),
      directionsCue()};
}

void PanoramaOptions::check() const {
  const auto isFraction = [](double value) { return value >= 0 && value <= 1; };
  requireOption(mirror == "none" || mirror == "given" || mirror == "found", "image.panorama.mirror",
                mirror, "none, given or found");
  requireOption(isFraction(center_x), "image.panorama.center_x", center_x,
                "a fraction of the image's width, 0 to 1");
  requireOption(isFraction(center_y), "image.panorama.center_y", center_y,
                "a fraction of the image's height, 0 to 1");
  requireOption(outer > 0 && outer <= 2, "image.panorama.outer", outer, "above 0, up to 2");
  requireOption(inner >= 0 && inner < outer, "image.panorama.inner", inner,
                "0 to less than " + shortest(outer) + " (image.panorama.outer)");
}

void ImageOptions::check() const {
  panorama.check();
  requireOption(max_width == 0 || max_width >= 16, "image.max_width", max_width,
                "at least 16 pixels, or 0 to leave images as they are");
}

void SamplingOptions::check() const {
  requireOption(rate >= 0 && rate <= 1000, "sampling.rate", rate, "0 to 1000 images per second");
  requireOption(most >= 10, "sampling.most", most, "at least 10 images");
}

void InformationOptions::check() const {
  for (const auto& [key, value] :
       {std::pair("left_out_below", left_out_below), std::pair("unknown_below", unknown_below)}) {
    requireOption(value >= 0 && value < 1, std::string("information.") + key, value,
                  "a fraction of the pixels, 0 to less than 1");
  }
}

void ValidationOptions::check() const {
  requireOption(folds >= 2 && folds <= kMaxFolds, "validation.folds", folds,
                "2 to " + std::to_string(kMaxFolds));
  requireOption(block >= 0 && block <= kMaxSeconds, "validation.block", block, kSecondsRule);
  requireOption(gap >= 0 && gap <= kMaxSeconds, "validation.gap", gap, kSecondsRule);
  require(block == 0 || gap <= largestGap(block, folds) * (1 + 1e-9),
          "Option 'validation.gap' is " + shortest(gap) +
              " s, which leaves too little to train on beside blocks of " + shortest(block) +
              " s in " + std::to_string(folds) +
              " folds; give longer blocks (validation.block) or a shorter gap.");
}

void UnknownOptions::check() const {
  requireOption(false_alarm_rate >= 0 && false_alarm_rate <= 1, "unknown.false_alarm_rate",
                false_alarm_rate, "a fraction, 0 to 1");
}

void TrainingOptions::check() const {
  image.check();
  sampling.check();
  information.check();
  requireSome(cues, "cues", "at least one cue");
  std::set<std::string> names;
  for (const CueOptions& cue : cues) {
    checkCue(cue);
    require(names.insert(cue.name).second,
            "Two cues are named '" + cue.name + "' in option 'cues'; rename one.");
  }
  svm.check();
  reduction.check();
  validation.check();
  unknown.check();
}

}  // namespace place_recognition
