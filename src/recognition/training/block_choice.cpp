#include "recognition/training/block_choice.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "base/quantile.h"
#include "learning/gram.h"
#include "recognition/training/gamma_choice.h"

namespace place_recognition {
namespace {

/// Approximate number of frames of a recording that are compared with all others of their rooms.
constexpr std::size_t kComparedFrames = 100;

/// Sums over frames and lags.
struct Sums {
  std::vector<double> distances, counts;  // [lag - 1]
  double frames = 0;
  double next_is_nearest = 0;
};

/// Mean distance of each lag up to the longest that occurs. Lags of which all frames were thinned
/// out are interpolated, from 0 at lag 0.
std::vector<double> means(const Sums& sums) {
  std::vector<double> result;
  for (std::size_t k = 0; k < sums.counts.size(); ++k) {
    if (sums.counts[k] == 0) continue;
    const double mean = sums.distances[k] / sums.counts[k];
    const double before = result.empty() ? 0 : result.back();
    const double step = (mean - before) / static_cast<double>(k + 1 - result.size());
    while (result.size() < k) result.push_back((result.empty() ? 0 : result.back()) + step);
    result.push_back(mean);
  }
  return result;
}

/// `count` indices in 0..size-1, evenly spread.
std::vector<std::size_t> spread(std::size_t count, std::size_t size) {
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < count; ++k) places.push_back((2 * k + 1) * size / (2 * count));
  return places;
}

/// Distances by one cue between the frames of a sequence (rows) and the frames `compared`
/// (columns), in units of their mean; -1 if one of them lacks the cue.
Eigen::MatrixXd cueDistances(const Sequence& sequence, const std::vector<std::size_t>& compared,
                             const std::vector<Feature>& features, const CueOptions& cue,
                             unsigned threads) {
  std::vector<std::size_t> order;  // the compared ones first
  std::vector<std::size_t> columns;
  const auto has = [&](std::size_t i) { return !isMissing(features[sequence.samples[i]]); };
  for (std::size_t k = 0; k < compared.size(); ++k) {
    if (!has(compared[k])) continue;
    order.push_back(compared[k]);
    columns.push_back(k);
  }
  for (std::size_t i = 0; i < sequence.samples.size(); ++i) {
    if (has(i) && !std::binary_search(compared.begin(), compared.end(), i)) order.push_back(i);
  }
  Eigen::MatrixXd distances =
      Eigen::MatrixXd::Constant(static_cast<Eigen::Index>(sequence.samples.size()),
                                static_cast<Eigen::Index>(compared.size()), -1);
  if (columns.empty() || order.size() < 2) return distances;

  KernelOptions kernel = cue.kernel;
  if (kernel.gamma == 0) kernel.gamma = gammaGrid(Kernel(kernel), {}).neutral;
  std::vector<Feature> ordered;
  for (const std::size_t i : order) ordered.push_back(features[sequence.samples[i]]);
  const Eigen::MatrixXd measures = measureColumns(Kernel(kernel), ordered, columns.size(), threads);
  const Eigen::MatrixXd differences =
      (measures.rowwise() - measures.topRows(measures.cols()).diagonal().transpose()).cwiseAbs();
  const double mean = differences.sum() / static_cast<double>((order.size() - 1) * columns.size());
  for (std::size_t r = 0; r < order.size(); ++r) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      distances(static_cast<Eigen::Index>(order[r]), static_cast<Eigen::Index>(columns[c])) =
          mean > 0 ? differences(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c)) / mean
                   : 0;
    }
  }
  return distances;
}

/// Mean of the cues' distances.
Eigen::MatrixXd distancesOf(const Sequence& sequence, const std::vector<std::size_t>& compared,
                            const std::vector<std::vector<Feature>>& features,
                            const std::vector<CueOptions>& cues, unsigned threads) {
  const auto rows = static_cast<Eigen::Index>(sequence.samples.size());
  const auto columns = static_cast<Eigen::Index>(compared.size());
  Eigen::ArrayXXd sum = Eigen::ArrayXXd::Zero(rows, columns);
  Eigen::ArrayXXd count = sum;
  for (std::size_t c = 0; c < cues.size(); ++c) {
    const Eigen::ArrayXXd distances =
        cueDistances(sequence, compared, features[c], cues[c], threads).array();
    sum += distances.max(0);
    count += (distances >= 0).cast<double>();
  }
  return (count > 0).select(sum / count.max(1), -1);
}

/// Numbers of the frames of a sequence, among which those that were thinned out count.
std::vector<std::size_t> numbersOf(const Sequence& sequence,
                                   const std::vector<SampleOrigin>& samples) {
  std::vector<std::size_t> numbers;
  std::size_t next = 0;
  for (const int sample : sequence.samples) {
    numbers.push_back(next + static_cast<std::size_t>(samples[sample].skipped));
    next = numbers.back() + 1;
  }
  return numbers;
}

/// Median time from one frame to the next, s; 0 if all have the same stamp.
double frameStep(const std::vector<double>& times, const std::vector<std::size_t>& numbers) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (times[i] <= times[i - 1]) continue;
    steps.push_back((times[i] - times[i - 1]) / static_cast<double>(numbers[i] - numbers[i - 1]));
  }
  return median(std::move(steps));
}

/// Adds the distances of one frame of a sequence, with these numbers, to all others.
void add(const Eigen::VectorXd& distances, const std::vector<std::size_t>& numbers,
         std::size_t frame, Sums& sums) {
  double nearest = -1;
  bool next_is_nearest = false;
  bool has_next = false;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const double distance = distances[static_cast<Eigen::Index>(i)];
    if (i == frame || distance < 0) continue;
    const std::size_t lag = i < frame ? numbers[frame] - numbers[i] : numbers[i] - numbers[frame];
    sums.distances[lag - 1] += distance;
    sums.counts[lag - 1] += 1;
    has_next = has_next || lag == 1;
    if (nearest >= 0 && distance >= nearest) continue;
    nearest = distance;
    next_is_nearest = lag == 1;
  }
  if (!has_next) return;
  sums.frames += 1;
  sums.next_is_nearest += next_is_nearest ? 1 : 0;
}

}  // namespace

double gapFor(const LikenessOverTime& likeness) {
  constexpr double kEnough = 1.0 / 8;
  constexpr double kOften = 1.0 / 3;
  const std::vector<double>& distances = likeness.distances;
  std::size_t left_out = likeness.next_is_nearest > kOften ? 1 : 0;
  if (distances.size() >= 2) {
    const double noise = std::clamp(2 * distances[0] - distances[1], 0.0, 1.0);
    const double enough = noise + kEnough * (1 - noise);
    while (left_out + 1 < distances.size() && distances[left_out] < enough) ++left_out;
  }
  return (static_cast<double>(left_out) + 0.5) * likeness.step;
}

LikenessOverTime likenessOverTime(const std::vector<SampleOrigin>& samples, int recording,
                                  const std::vector<std::vector<Feature>>& features,
                                  const std::vector<CueOptions>& cues, unsigned threads) {
  std::vector<Sequence> rooms = cameraSequencesOf(samples);
  rooms.erase(
      std::remove_if(rooms.begin(), rooms.end(),
                     [recording](const Sequence& room) { return room.recording != recording; }),
      rooms.end());
  std::size_t frames = 0;
  std::size_t longest = 0;
  std::vector<std::vector<std::size_t>> numbers;
  std::vector<double> steps;
  for (const Sequence& room : rooms) {
    frames += room.samples.size();
    numbers.push_back(numbersOf(room, samples));
    longest = std::max(longest, numbers.back().back() + 1);
    if (room.samples.size() > 1) steps.push_back(frameStep(room.times, numbers.back()));
  }
  if (steps.empty()) return {1, {}, 0};

  Sums sums;
  sums.distances.assign(longest - 1, 0);
  sums.counts = sums.distances;
  for (std::size_t r = 0; r < rooms.size(); ++r) {
    const Sequence& room = rooms[r];
    const std::size_t size = room.samples.size();
    const std::size_t count = std::min(size, (kComparedFrames * size + frames - 1) / frames);
    const std::vector<std::size_t> compared = spread(count, size);
    const Eigen::MatrixXd distances = distancesOf(room, compared, features, cues, threads);
    for (std::size_t k = 0; k < count; ++k) {
      add(distances.col(static_cast<Eigen::Index>(k)), numbers[r], compared[k], sums);
    }
  }
  LikenessOverTime likeness;
  likeness.step = median(std::move(steps));
  likeness.distances = means(sums);
  if (sums.frames > 0) likeness.next_is_nearest = sums.next_is_nearest / sums.frames;
  return likeness;
}

std::vector<TimeBlocks> chooseBlocks(const std::vector<SampleOrigin>& samples,
                                     const std::vector<std::vector<Feature>>& features,
                                     const std::vector<CueOptions>& cues,
                                     const ValidationOptions& options, unsigned threads) {
  std::vector<TimeBlocks> blocks;
  for (int recording = 0; recording < recordingCount(samples); ++recording) {
    double gap = options.gap;
    double shortest = 0;
    if (gap == 0) {
      const LikenessOverTime likeness =
          likenessOverTime(samples, recording, features, cues, threads);
      gap = gapFor(likeness);
      shortest = likeness.step;
    }
    if (options.gap == 0 && options.block > 0) {
      gap = std::min(gap, largestGap(options.block, options.folds));
    }
    shortest = std::max(shortest, gap * std::max(1.0, 1 / largestGap(1, options.folds)));
    blocks.push_back({options.block > 0 ? options.block : shortest, gap});
  }
  return blocks;
}

}  // namespace place_recognition
