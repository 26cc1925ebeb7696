#include "place_recognition/training_options.h"

#include <set>
#include <utility>

#include "base/data_folder.h"
#include "learning/folds.h"
#include "learning/kernel_type.h"
#include "place_recognition/error.h"
#include "recognition/frames/colour_normalization.h"

namespace place_recognition {
namespace {

/// Runs the checks of a cue's parts, and adds the cue's name to their messages.
void checkCue(const CueOptions& cue) {
  if (!isPlainName(cue.name)) {
    throw Error("Option 'cues.name' is '" + cue.name + "'; give " + kPlainNameRule + ".");
  }
  try {
    colourNormalization(cue.normalize);
    if (!(cue.weight >= 0.01 && cue.weight <= 100)) {
      throw Error("option 'weight' is " + std::to_string(cue.weight) + "; give 0.01 to 100.");
    }
    std::visit([](const auto& feature) { feature.check(); }, cue.feature);
    cue.kernel.check();
    const KernelType& kernel = kernelType(cue.kernel.type);
    requireMeaning(kernel, std::holds_alternative<LocalFeatureOptions>(cue.feature));
    if (std::holds_alternative<EmbeddingOptions>(cue.feature)) requireSignedMeaning(kernel);
  } catch (const Error& e) {
    throw Error("Cue '" + cue.name + "': " + e.what());
  }
}

constexpr double kMaxSeconds = 1e6;

std::string notSeconds(const char* key, double value) {
  return std::string("Option 'validation.") + key + "' is " + std::to_string(value) +
         "; give 0 to 1000000 seconds.";
}

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
  if (mirror != "none" && mirror != "given" && mirror != "found") {
    throw Error("Option 'image.panorama.mirror' is '" + mirror + "'; give none, given or found.");
  }
  const auto isFraction = [](double value) { return value >= 0 && value <= 1; };
  if (!isFraction(center_x) || !isFraction(center_y)) {
    throw Error("Options 'image.panorama.center_x' and 'center_y' are " + std::to_string(center_x) +
                " and " + std::to_string(center_y) +
                "; give fractions of the image's width and height, 0 to 1.");
  }
  if (!(inner >= 0 && inner < outer && outer <= 2)) {
    throw Error("Options 'image.panorama.inner' and 'outer' are " + std::to_string(inner) +
                " and " + std::to_string(outer) + "; give 0 <= inner < outer <= 2.");
  }
}

void ImageOptions::check() const {
  panorama.check();
  if (max_width < 0 || (max_width > 0 && max_width < 16)) {
    throw Error("Option 'image.max_width' is " + std::to_string(max_width) +
                "; give at least 16 pixels, or 0 to leave images as they are.");
  }
}

void SamplingOptions::check() const {
  if (!(rate >= 0 && rate <= 1000)) {
    throw Error("Option 'sampling.rate' is " + std::to_string(rate) +
                "; give 0 to 1000 images per second.");
  }
  if (most < 10) {
    throw Error("Option 'sampling.most' is " + std::to_string(most) + "; give at least 10 images.");
  }
}

void InformationOptions::check() const {
  for (const auto& [key, value] :
       {std::pair("left_out_below", left_out_below), std::pair("unknown_below", unknown_below)}) {
    if (value >= 0 && value < 1) continue;
    throw Error(std::string("Option 'information.") + key + "' is " + std::to_string(value) +
                "; give a fraction of the pixels, 0 to less than 1.");
  }
}

void ValidationOptions::check() const {
  if (folds < 2 || folds > kMaxFolds) {
    throw Error("Option 'validation.folds' is " + std::to_string(folds) + "; give 2 to " +
                std::to_string(kMaxFolds) + ".");
  }
  if (!(block >= 0 && block <= kMaxSeconds)) throw Error(notSeconds("block", block));
  if (!(gap >= 0 && gap <= kMaxSeconds)) throw Error(notSeconds("gap", gap));
  if (block > 0 && gap > largestGap(block, folds) * (1 + 1e-9)) {
    throw Error("Option 'validation.gap' is " + std::to_string(gap) +
                " s, which leaves too little to train on beside blocks of " +
                std::to_string(block) + " s in " + std::to_string(folds) +
                " folds; give longer blocks (validation.block) or a shorter gap.");
  }
}

void UnknownOptions::check() const {
  if (!(false_alarm_rate >= 0 && false_alarm_rate <= 1)) {
    throw Error("Option 'unknown.false_alarm_rate' is " + std::to_string(false_alarm_rate) +
                "; give a fraction, 0 to 1.");
  }
}

void TrainingOptions::check() const {
  image.check();
  sampling.check();
  information.check();
  if (cues.empty()) throw Error("Option 'cues' is empty; give at least one cue.");
  std::set<std::string> names;
  for (const CueOptions& cue : cues) {
    checkCue(cue);
    if (!names.insert(cue.name).second) {
      throw Error("Two cues are named '" + cue.name + "' in option 'cues'; rename one.");
    }
  }
  svm.check();
  reduction.check();
  validation.check();
  unknown.check();
}

}  // namespace place_recognition
