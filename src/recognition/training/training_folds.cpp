#include "recognition/training/training_folds.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "recognition/training/block_choice.h"

namespace place_recognition {
namespace {

/// The blocks of time that represent those of all recordings: the ones of median length.
TimeBlocks typicalBlocks(std::vector<TimeBlocks> blocks) {
  const auto middle = blocks.begin() + static_cast<std::ptrdiff_t>(blocks.size() / 2);
  std::nth_element(blocks.begin(), middle, blocks.end(),
                   [](const auto& a, const auto& b) { return a.length < b.length; });
  return *middle;
}

}  // namespace

std::vector<Fold> chooseFolds(const Samples& samples, unsigned threads, TrainingOptions& options) {
  const std::vector<SampleOrigin> origins = samples.recordedOrigins();
  std::vector<TimeBlocks> blocks(1);
  if (completeRecordings(origins) < options.validation.folds) {
    blocks = chooseBlocks(origins, samples.features, options.cues, options.validation, threads);
    const TimeBlocks typical = typicalBlocks(blocks);
    options.validation.block = typical.length;
    options.validation.gap = typical.gap;
  }
  return withCopies(timeBlockFolds(origins, options.validation.folds, blocks), samples.source,
                    true);
}

std::vector<Fold> withRemembered(std::vector<Fold> folds, std::size_t remembered) {
  const auto isFresh = [remembered](int sample) {
    return static_cast<std::size_t>(sample) >= remembered;
  };
  for (Fold& fold : folds) {
    std::vector<int> train(remembered);
    std::iota(train.begin(), train.end(), 0);
    std::copy_if(fold.train.begin(), fold.train.end(), std::back_inserter(train), isFresh);
    fold.train = std::move(train);
    fold.test.erase(std::stable_partition(fold.test.begin(), fold.test.end(), isFresh),
                    fold.test.end());
  }
  return folds;
}

}  // namespace place_recognition
