#include "place_recognition/tuning.h"

#include <chrono>
#include <utility>

#include "recognition/frames/image_profile.h"
#include "recognition/frames/mirror_search.h"
#include "recognition/model/embeddings.h"
#include "tuning/cue_selection.h"
#include "tuning/family_rounds.h"

namespace place_recognition {
namespace {

/// The cues to choose from: those of the base, those of the space, and the best of each family.
std::vector<CueOptions> cuesInQuestion(const Thinning& thinning, Search& search) {
  std::vector<CueOptions> cues = search.base.cues;
  cues.insert(cues.end(), search.space.cues.begin(), search.space.cues.end());
  const std::vector<CueOptions> winners =
      bestOfEach(candidateFamilies(search.space), thinning, search);
  cues.insert(cues.end(), winners.begin(), winners.end());
  return cues;
}

/// The whole search; search.best is the answer at its end, or when it is stopped.
void look(Search& search, const Thinning& thinning) {
  const std::vector<CueOptions> cues = cuesInQuestion(thinning, search);
  TuningSamples samples = search.collect(cues, thinning.last, search.progress);
  std::vector<CueComparison> comparisons;
  for (std::size_t c = 0; c < cues.size(); ++c) {
    report(search.progress, "Comparing images",
           static_cast<double>(c) / static_cast<double>(cues.size()));
    comparisons.emplace_back(cues[c], std::move(samples.features[c]), samples, search.threads);
  }
  const Combination chosen = chooseCues(comparisons, search.base.cues.size(), samples, search);
  chooseC(comparisons, chosen, samples, search);
}

}  // namespace

Tuning tune(const std::vector<RecordingOpener>& recordings,
            const std::vector<RecordingOpener>& hold_out, const TrainingOptions& base,
            const SearchSpace& space, unsigned threads, const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  base.check();
  space.check();
  const TrainingOptions ready = withMirror(withNetworks(base), recordings);
  SearchSpace ready_space = space;
  ready_space.cues = withNetworks(withCues(base, space.cues)).cues;
  Search search{{recordings, hold_out, commonSize(recordings, progress)},
                ready,
                ready_space,
                threads,
                progress};
  search.best.cues = base.cues;
  search.best.c = base.svm.c;
  Tuning tuning;
  const Thinning thinning = planThinning(search.recordings, space, progress, tuning.images);
  try {
    look(search, thinning);
  } catch (const Cancelled&) {
    tuning.complete = false;
  }
  tuning.best = search.best;
  tuning.trials = std::move(search.trials);
  tuning.options = withCues(base, tuning.best.cues);
  tuning.options.svm.c = tuning.best.c;
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  tuning.seconds = elapsed.count();
  return tuning;
}

}  // namespace place_recognition
