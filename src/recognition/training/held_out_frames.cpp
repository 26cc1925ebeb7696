#include "recognition/training/held_out_frames.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "recognition/training/sampling.h"

namespace place_recognition {
namespace {

/// Mean held-out margins of the first samples: a row a place that they show, a column a place that
/// is answered; -1 if no sample shows it.
Eigen::MatrixXd meanMargins(const HeldOut& held_out, const std::vector<SampleOrigin>& samples,
                            std::size_t count) {
  const Eigen::Index places = held_out.margins.cols();
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(places, places);
  Eigen::VectorXd counts = Eigen::VectorXd::Zero(places);
  for (std::size_t i = 0; i < count; ++i) {
    if (!held_out.valid[i]) continue;
    sums.row(samples[i].place) += held_out.margins.row(static_cast<Eigen::Index>(i));
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

/// Appends the frames' margins of one cue.
void append(const HeldOutFrames& frames, std::size_t cue, const std::vector<int>& place_of,
            const Eigen::MatrixXd& mean_margins, HeldOut& held_out) {
  const Eigen::Index before = held_out.margins.rows();
  const auto count = static_cast<Eigen::Index>(frames.places.size());
  held_out.margins.conservativeResize(before + count, Eigen::NoChange);
  held_out.familiarity.conservativeResize(before + count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto frame = static_cast<std::size_t>(i);
    held_out.margins.row(before + i) = mean_margins.row(place_of[frames.places[frame]]);
    for (std::size_t k = 0; k < place_of.size(); ++k) {
      held_out.margins(before + i, place_of[k]) =
          frames.margins[cue](i, static_cast<Eigen::Index>(k));
    }
    const float familiarity = frames.familiarity[cue][i];
    held_out.valid.push_back(!std::isnan(familiarity));
    held_out.familiarity[before + i] = held_out.valid.back() ? familiarity : 0;
  }
}

/// The valid samples of some cues.
std::vector<int> validSamples(const std::vector<HeldOut>& cues) {
  std::vector<int> valid;
  for (std::size_t i = 0; i < cues[0].valid.size(); ++i) {
    const auto has = [i](const HeldOut& cue) { return cue.valid[i]; };
    if (std::any_of(cues.begin(), cues.end(), has)) valid.push_back(static_cast<int>(i));
  }
  return valid;
}

/// Some samples of one cue, in the form that a model keeps.
void keep(const HeldOut& held_out, const std::vector<int>& samples, HeldOutFrames& frames) {
  const auto count = static_cast<Eigen::Index>(samples.size());
  Eigen::MatrixXf margins(count, held_out.margins.cols());
  Eigen::VectorXf familiarity(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const int sample = samples[static_cast<std::size_t>(i)];
    margins.row(i) = held_out.margins.row(sample).cast<float>();
    familiarity[i] = held_out.valid[sample] ? static_cast<float>(held_out.familiarity[sample])
                                            : std::numeric_limits<float>::quiet_NaN();
  }
  frames.margins.push_back(std::move(margins));
  frames.familiarity.push_back(std::move(familiarity));
}

/// Which samples, of these places, a model keeps. stratifiedSample() rounds the share of each place
/// up, so that it may have to be asked for less than there is room for.
std::vector<bool> keptOf(const std::vector<int>& places, std::uint64_t seed) {
  std::size_t most = kMaxHeldOutFrames;
  std::vector<bool> kept = stratifiedSample(places, most, seed);
  const auto excess = [&kept] {
    const auto count = static_cast<std::size_t>(std::count(kept.begin(), kept.end(), true));
    return count - std::min(count, kMaxHeldOutFrames);
  };
  while (excess() > 0 && most > 1) {
    most -= std::min(most - 1, excess());
    kept = stratifiedSample(places, most, seed);
  }
  return kept;
}

}  // namespace

void Judges::add(const HeldOutFrames& frames, const std::vector<int>& place_of,
                 std::size_t remembered) {
  for (std::vector<HeldOut>& cues : reductions) {
    for (std::size_t c = 0; c < cues.size() && !frames.places.empty(); ++c) {
      append(frames, c, place_of, meanMargins(cues[c], samples, remembered), cues[c]);
    }
  }
  for (std::size_t i = 0; i < frames.places.size(); ++i) {
    const std::size_t fold = static_cast<std::size_t>(frames.folds[i]) % folds.size();
    folds[fold].test.push_back(static_cast<int>(samples.size()));
    samples.push_back({place_of[frames.places[i]], -1, 0});
  }
}

HeldOutFrames keptFrames(const Judges& judges, std::size_t reduction, std::uint64_t seed) {
  const std::vector<HeldOut>& cues = judges.reductions[reduction];
  std::vector<int> valid = validSamples(cues);
  std::vector<int> places;
  for (const int sample : valid) places.push_back(judges.samples[sample].place);
  const std::vector<bool> kept = keptOf(places, seed);
  std::vector<int> samples;
  for (std::size_t i = 0; i < valid.size() && samples.size() < kMaxHeldOutFrames; ++i) {
    if (kept[i]) samples.push_back(valid[i]);
  }

  std::vector<int> fold_of(judges.samples.size(), 0);
  for (std::size_t f = 0; f < judges.folds.size(); ++f) {
    for (const int sample : judges.folds[f].test) fold_of[sample] = static_cast<int>(f);
  }
  HeldOutFrames frames;
  for (const int sample : samples) {
    frames.places.push_back(judges.samples[sample].place);
    frames.folds.push_back(fold_of[sample]);
  }
  for (const HeldOut& cue : cues) keep(cue, samples, frames);
  return frames;
}

}  // namespace place_recognition
