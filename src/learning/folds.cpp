#include "learning/folds.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "base/quantile.h"

namespace place_recognition {
namespace {

using Samples = std::vector<SampleOrigin>;

/// The fold that tests each sample, and the other folds in which it is not trained on.
struct Assignment {
  std::vector<int> tested_in;
  std::vector<std::set<int>> left_out_of;
};

/// Runs in ascending order.
struct Recordings {
  std::vector<int> complete;  // contain every place
  std::vector<int> others;
};

Recordings recordingsOf(const Samples& samples) {
  std::map<int, std::set<int>> places_of_recording;
  std::set<int> places;
  for (const SampleOrigin& sample : samples) {
    places_of_recording[sample.recording].insert(sample.place);
    places.insert(sample.place);
  }
  Recordings recordings;
  for (const auto& [recording, its_places] : places_of_recording) {
    const bool complete = its_places.size() == places.size();
    (complete ? recordings.complete : recordings.others).push_back(recording);
  }
  return recordings;
}

/// Tests whole runs in turn, the complete ones first; runs have no neighbours in time.
Assignment assignRecordings(const Samples& samples, const Recordings& recordings, int count) {
  std::map<int, int> fold_of_run;
  int next = 0;
  for (const std::vector<int>* group : {&recordings.complete, &recordings.others}) {
    for (const int recording : *group) fold_of_run[recording] = next++ % count;
  }
  Assignment assignment{{}, std::vector<std::set<int>>(samples.size())};
  for (const SampleOrigin& sample : samples) {
    assignment.tested_in.push_back(fold_of_run[sample.recording]);
  }
  return assignment;
}

/// Leaves samples of `sequence` within `gap` of the ascending times `tested` out of `fold`.
void leaveOut(const Sequence& sequence, const std::vector<double>& tested, double gap, int fold,
              Assignment& assignment) {
  const std::vector<double>& times = sequence.times;
  auto from = times.begin();
  for (const double time : tested) {
    from = std::lower_bound(from, times.end(), time - gap);
    for (; from < times.end() && *from <= time + gap; ++from) {
      assignment.left_out_of[sequence.samples[from - times.begin()]].insert(fold);
    }
  }
}

/// Whether the times of two sequences are comparable.
bool sameClock(const Sequence& a, const Sequence& b) {
  return &a == &b || (a.recording == b.recording && a.stamped && b.stamped);
}

/// Median of the nonzero steps of ascending `times`; 0 if there is none.
double medianStep(const std::vector<double>& times) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (times[i] > times[i - 1]) steps.push_back(times[i] - times[i - 1]);
  }
  return median(std::move(steps));
}

/// Number of blocks into which a sequence of `size` samples is cut.
std::size_t blockCount(std::size_t size, double step, double length, int folds) {
  const double samples_each = std::max(1.0, std::ceil(length / step - 1e-9));
  const long wanted = std::lround(static_cast<double>(size) / samples_each);
  return static_cast<std::size_t>(
      std::max(wanted, std::min(static_cast<long>(size), static_cast<long>(folds))));
}

/// The division of one sequence.
struct Cut {
  std::size_t parts;
  double gap;  // s
};

Cut cutOf(const Sequence& sequence, int folds, const TimeBlocks& wanted) {
  const auto moments = sequence.samples.size() / static_cast<std::size_t>(sequence.cameras);
  const double step = medianStep(sequence.times);
  const std::size_t parts = blockCount(moments, step, wanted.length, folds);
  const double length = step * static_cast<double>(moments) / static_cast<double>(parts);
  return {parts, std::min(wanted.gap, largestGap(length, folds))};
}

/// The first sample of a part. Simultaneous images of several cameras stay together.
std::size_t startOf(std::size_t part, std::size_t parts, const Sequence& sequence) {
  const std::size_t size = sequence.samples.size();
  std::size_t i = part * size / parts;
  const auto splits = [&] {
    return i > 0 && i < size && sequence.times[i] == sequence.times[i - 1];
  };
  while (sequence.cameras > 1 && splits()) --i;
  return i;
}

/// Blocks of time within each run and place.
Assignment assignBlocks(const Samples& samples, int count, const std::vector<TimeBlocks>& blocks) {
  Assignment assignment{std::vector<int>(samples.size()),
                        std::vector<std::set<int>>(samples.size())};
  const std::vector<Sequence> sequences = sequencesOf(samples);
  std::vector<Cut> cuts;
  for (const Sequence& sequence : sequences) {
    cuts.push_back(cutOf(sequence, count, blocks[sequence.recording]));
  }
  int next_fold = 0;
  for (std::size_t s = 0; s < sequences.size(); ++s) {
    for (std::size_t part = 0; part < cuts[s].parts; ++part) {
      const std::size_t begin = startOf(part, cuts[s].parts, sequences[s]);
      const std::size_t end = startOf(part + 1, cuts[s].parts, sequences[s]);
      if (begin == end) continue;
      for (std::size_t i = begin; i < end; ++i) {
        assignment.tested_in[sequences[s].samples[i]] = next_fold;
      }
      const std::vector<double> tested(sequences[s].times.begin() + begin,
                                       sequences[s].times.begin() + end);
      for (std::size_t other = 0; other < sequences.size(); ++other) {
        if (!sameClock(sequences[s], sequences[other])) continue;
        leaveOut(sequences[other], tested, std::min(cuts[s].gap, cuts[other].gap), next_fold,
                 assignment);
      }
      next_fold = (next_fold + 1) % count;
    }
  }
  return assignment;
}

/// Groups samples by `key`, in ascending order of the key.
template <typename Key>
std::vector<Sequence> grouped(const Samples& samples, const Key& key) {
  std::map<decltype(key(samples[0])), std::vector<int>> groups;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    groups[key(samples[i])].push_back(static_cast<int>(i));
  }
  std::vector<Sequence> sequences;
  for (auto& group : groups) {
    std::vector<int>& members = group.second;
    std::stable_sort(members.begin(), members.end(),
                     [&](int a, int b) { return samples[a].stamp < samples[b].stamp; });
    Sequence sequence;
    std::set<int> cameras;
    for (const int i : members) {
      sequence.times.push_back(samples[i].stamp);
      cameras.insert(samples[i].camera);
    }
    sequence.recording = samples[members.front()].recording;
    sequence.cameras = static_cast<int>(cameras.size());
    sequence.samples = std::move(members);
    std::vector<double>& times = sequence.times;
    sequence.stamped = times.back() > times.front();
    if (!sequence.stamped) std::iota(times.begin(), times.end(), 0.0);
    sequences.push_back(std::move(sequence));
  }
  return sequences;
}

}  // namespace

int recordingCount(const Samples& samples) {
  int count = 0;
  for (const SampleOrigin& sample : samples) count = std::max(count, sample.recording + 1);
  return count;
}

double largestGap(double length, int folds) { return length * (0.6 * folds - 1) / 2; }

std::vector<Sequence> sequencesOf(const Samples& samples) {
  return grouped(samples, [](const SampleOrigin& s) { return std::tuple(s.recording, s.place); });
}

std::vector<Sequence> cameraSequencesOf(const Samples& samples) {
  return grouped(samples,
                 [](const SampleOrigin& s) { return std::tuple(s.recording, s.place, s.camera); });
}

int completeRecordings(const Samples& samples) {
  return static_cast<int>(recordingsOf(samples).complete.size());
}

std::vector<Fold> timeBlockFolds(const Samples& samples, int count,
                                 const std::vector<TimeBlocks>& blocks) {
  assert(count >= 2);
  const Recordings recordings = recordingsOf(samples);
  const Assignment assignment = recordings.complete.size() >= static_cast<std::size_t>(count)
                                    ? assignRecordings(samples, recordings, count)
                                    : assignBlocks(samples, count, blocks);
  std::vector<Fold> folds(static_cast<std::size_t>(count));
  for (int fold = 0; fold < count; ++fold) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (assignment.tested_in[i] == fold) {
        folds[fold].test.push_back(static_cast<int>(i));
      } else if (assignment.left_out_of[i].count(fold) == 0) {
        folds[fold].train.push_back(static_cast<int>(i));
      }
    }
  }
  return folds;
}

std::vector<Fold> longestBlockFolds(const Samples& samples, int count, double gap) {
  const TimeBlocks longest{std::numeric_limits<double>::infinity(), gap};
  return timeBlockFolds(
      samples, count,
      std::vector<TimeBlocks>(static_cast<std::size_t>(recordingCount(samples)), longest));
}

std::vector<int> testingFolds(const std::vector<Fold>& folds, std::size_t samples) {
  std::vector<int> fold_of(samples, -1);
  for (std::size_t f = 0; f < folds.size(); ++f) {
    for (const int sample : folds[f].test)
      fold_of[static_cast<std::size_t>(sample)] = static_cast<int>(f);
  }
  return fold_of;
}

std::vector<Fold> withCopies(std::vector<Fold> folds, const std::vector<int>& source,
                             bool train_on_copies) {
  std::vector<std::vector<int>> copies(source.size());
  for (std::size_t i = 0; i < source.size(); ++i) {
    if (source[i] != static_cast<int>(i)) copies[source[i]].push_back(static_cast<int>(i));
  }
  const auto addCopies = [&copies](std::vector<int>& samples) {
    const std::vector<int> originals = samples;
    for (const int i : originals) {
      samples.insert(samples.end(), copies[i].begin(), copies[i].end());
    }
  };
  for (Fold& fold : folds) {
    addCopies(fold.test);
    if (train_on_copies) addCopies(fold.train);
  }
  return folds;
}

}  // namespace place_recognition
