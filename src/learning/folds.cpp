#include "learning/folds.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <set>
#include <utility>

namespace place_recognition {
namespace {

using Samples = std::vector<SampleOrigin>;

/// The fold that tests each sample, and whether the sample is too near to a tested block to be
/// trained on in a fold.
struct Assignment {
  std::vector<int> tested_in;
  std::vector<std::set<int>> left_out_of;
};

/// Runs in ascending order, those that hold every place first.
std::vector<int> completeRunsFirst(const Samples& samples, std::size_t& complete) {
  std::map<int, std::set<int>> places_of_run;
  std::set<int> places;
  for (const SampleOrigin& sample : samples) {
    places_of_run[sample.run].insert(sample.place);
    places.insert(sample.place);
  }
  std::vector<int> runs;
  for (const auto& run : places_of_run) runs.push_back(run.first);
  const auto middle = std::stable_partition(runs.begin(), runs.end(), [&](int run) {
    return places_of_run[run].size() == places.size();
  });
  complete = static_cast<std::size_t>(middle - runs.begin());
  return runs;
}

/// Whole runs in turn; runs have no neighbours.
Assignment assignRuns(const Samples& samples, const std::vector<int>& runs, int count) {
  std::map<int, int> fold_of_run;
  for (std::size_t i = 0; i < runs.size(); ++i) fold_of_run[runs[i]] = static_cast<int>(i) % count;
  Assignment assignment{{}, std::vector<std::set<int>>(samples.size())};
  for (const SampleOrigin& sample : samples) {
    assignment.tested_in.push_back(fold_of_run[sample.run]);
  }
  return assignment;
}

/// Blocks of time within each run and place.
Assignment assignBlocks(const Samples& samples, int count, int gap) {
  std::map<std::pair<int, int>, std::vector<int>> sequences;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    sequences[{samples[i].run, samples[i].place}].push_back(static_cast<int>(i));
  }
  Assignment assignment{std::vector<int>(samples.size()),
                        std::vector<std::set<int>>(samples.size())};
  for (auto& [run_and_place, sequence] : sequences) {
    std::stable_sort(sequence.begin(), sequence.end(),
                     [&](int a, int b) { return samples[a].stamp < samples[b].stamp; });
    const int length = static_cast<int>(sequence.size());
    for (int fold = 0; fold < count; ++fold) {
      const int begin = static_cast<int>(static_cast<long>(fold) * length / count);
      const int end = static_cast<int>(static_cast<long>(fold + 1) * length / count);
      if (begin == end) continue;
      for (int i = begin; i < end; ++i) assignment.tested_in[sequence[i]] = fold;
      for (int i = std::max(0, begin - gap); i < std::min(length, end + gap); ++i) {
        assignment.left_out_of[sequence[i]].insert(fold);
      }
    }
  }
  return assignment;
}

}  // namespace

std::vector<Fold> timeBlockFolds(const Samples& samples, int count, int gap) {
  assert(count >= 2 && gap >= 0);
  std::size_t complete = 0;
  const std::vector<int> runs = completeRunsFirst(samples, complete);
  const Assignment assignment = complete >= static_cast<std::size_t>(count)
                                    ? assignRuns(samples, runs, count)
                                    : assignBlocks(samples, count, gap);
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
