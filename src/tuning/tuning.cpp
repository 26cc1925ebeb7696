#include "place_recognition/tuning.h"

#include <chrono>
#include <utility>

#include "recognition/frames/image_profile.h"
#include "tuning/cue_selection.h"
#include "tuning/family_rounds.h"

namespace place_recognition {
namespace {

/// The whole search; search.best is the answer at its end, or when it is stopped.
void look(Search& search, std::uint64_t& pictures) {
  const Thinning thinning = planThinning(search.runs, search.space, search.progress, pictures);
  const std::vector<CueOptions> winners =
      bestOfEach(candidateFamilies(search.base, search.space), thinning, search);

  TuningSamples samples = collectTuningSamples(search.runs, search.withCues(winners), thinning.last,
                                               search.threads, search.progress);
  std::vector<CueComparison> comparisons;
  for (std::size_t c = 0; c < winners.size(); ++c) {
    report(search.progress, "Comparing pictures",
           static_cast<double>(c) / static_cast<double>(winners.size()));
    comparisons.emplace_back(winners[c], std::move(samples.features[c]), samples, search.threads);
  }
  const std::vector<CueChoice> chosen =
      chooseCues(chooseGammas(comparisons, samples, search), samples, search);
  chooseC(chosen, samples, search);
}

}  // namespace

Tuning tune(const std::vector<RunOpener>& runs, const std::vector<RunOpener>& hold_out,
            const TrainingOptions& base, const SearchSpace& space, unsigned threads,
            const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  space.check();
  Search search{{runs, hold_out, commonSize(runs, progress)}, base, space, threads, progress};
  Tuning tuning;
  try {
    look(search, tuning.pictures);
  } catch (const Cancelled&) {
    if (!search.best) throw;
    tuning.complete = false;
  }
  tuning.best = *search.best;
  tuning.trials = std::move(search.trials);
  tuning.options = search.withCues(tuning.best.cues);
  tuning.options.svm.c = tuning.best.c;
  tuning.options.reduction.method = "none";
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  tuning.seconds = elapsed.count();
  return tuning;
}

}  // namespace place_recognition
