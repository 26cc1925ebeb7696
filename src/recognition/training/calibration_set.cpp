#include "recognition/training/calibration_set.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "learning/selection.h"
#include "recognition/training/sampling.h"

namespace place_recognition {
namespace {

/// Mean held-out decision values of the first samples: one row per true place, one column per
/// answered place; -1 if no sample shows the true place.
Eigen::MatrixXd meanValues(const HeldOutValues& held_out, const std::vector<SampleOrigin>& samples,
                           std::size_t count) {
  const Eigen::Index places = held_out.decision_values.cols();
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(places, places);
  Eigen::VectorXd counts = Eigen::VectorXd::Zero(places);
  for (std::size_t i = 0; i < count; ++i) {
    if (!held_out.valid[i]) continue;
    sums.row(samples[i].place) += held_out.decision_values.row(static_cast<Eigen::Index>(i));
    counts[samples[i].place] += 1;
  }
  for (Eigen::Index place = 0; place < places; ++place) {
    if (counts[place] > 0) {
      sums.row(place) /= counts[place];
    } else {
      sums.row(place).setConstant(-1);
    }
  }
  return sums;
}

/// Appends the frames' decision values of one cue.
void append(const HeldOutFrames& frames, std::size_t cue, const std::vector<int>& place_of,
            const Eigen::MatrixXd& mean_values, HeldOutValues& held_out) {
  const Eigen::Index before = held_out.decision_values.rows();
  const auto count = static_cast<Eigen::Index>(frames.places.size());
  held_out.decision_values.conservativeResize(before + count, Eigen::NoChange);
  held_out.familiarity.conservativeResize(before + count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto frame = static_cast<std::size_t>(i);
    held_out.decision_values.row(before + i) = mean_values.row(place_of[frames.places[frame]]);
    for (std::size_t k = 0; k < place_of.size(); ++k) {
      held_out.decision_values(before + i, place_of[k]) =
          frames.decision_values[cue](i, static_cast<Eigen::Index>(k));
    }
    const float familiarity = frames.familiarity[cue][i];
    held_out.valid.push_back(!std::isnan(familiarity));
    held_out.familiarity[before + i] = held_out.valid.back() ? familiarity : 0;
  }
}

/// The samples that "unknown" is fitted to and that are valid in some cue.
std::vector<int> judgesOfUnknown(const std::vector<HeldOutValues>& cues,
                                 const std::vector<bool>& judges_unknown) {
  std::vector<int> judges;
  for (std::size_t i = 0; i < judges_unknown.size(); ++i) {
    const auto has = [i](const HeldOutValues& cue) { return cue.valid[i]; };
    if (judges_unknown[i] && std::any_of(cues.begin(), cues.end(), has)) {
      judges.push_back(static_cast<int>(i));
    }
  }
  return judges;
}

/// Some samples of one cue, in the form that a model keeps.
void keep(const HeldOutValues& held_out, const std::vector<int>& samples, HeldOutFrames& frames) {
  const auto count = static_cast<Eigen::Index>(samples.size());
  Eigen::MatrixXf decision_values(count, held_out.decision_values.cols());
  Eigen::VectorXf familiarity(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const int sample = samples[static_cast<std::size_t>(i)];
    decision_values.row(i) = held_out.decision_values.row(sample).cast<float>();
    familiarity[i] = held_out.valid[sample] ? static_cast<float>(held_out.familiarity[sample])
                                            : std::numeric_limits<float>::quiet_NaN();
  }
  frames.decision_values.push_back(std::move(decision_values));
  frames.familiarity.push_back(std::move(familiarity));
}

}  // namespace

void CalibrationSet::add(const HeldOutFrames& frames, const std::vector<int>& place_of,
                         std::size_t remembered) {
  for (std::vector<HeldOutValues>& cues : reductions) {
    for (std::size_t c = 0; c < cues.size() && !frames.places.empty(); ++c) {
      append(frames, c, place_of, meanValues(cues[c], samples, remembered), cues[c]);
    }
  }
  for (std::size_t i = 0; i < frames.places.size(); ++i) {
    const std::size_t fold = static_cast<std::size_t>(frames.folds[i]) % folds.size();
    folds[fold].test.push_back(static_cast<int>(samples.size()));
    samples.push_back({place_of[frames.places[i]], -1, 0});
    judges_unknown.push_back(true);
  }
}

HeldOutFrames keptFrames(const CalibrationSet& calibration_set, std::size_t reduction,
                         std::uint64_t seed) {
  const std::vector<HeldOutValues>& cues = calibration_set.reductions[reduction];
  const std::vector<int> valid = judgesOfUnknown(cues, calibration_set.judges_unknown);
  std::vector<int> places;
  for (const int sample : valid) places.push_back(calibration_set.samples[sample].place);
  const std::vector<bool> kept = stratifiedSample(places, kMaxHeldOutFrames, seed);
  std::vector<int> samples;
  for (std::size_t i = 0; i < valid.size(); ++i) {
    if (kept[i]) samples.push_back(valid[i]);
  }

  HeldOutFrames frames;
  for (const int sample : samples) frames.places.push_back(calibration_set.samples[sample].place);
  frames.folds = pick(testingFolds(calibration_set.folds, calibration_set.samples.size()), samples);
  for (const HeldOutValues& cue : cues) keep(cue, samples, frames);
  return frames;
}

}  // namespace place_recognition
