#include "place_recognition/tuning.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

#include "base/options.h"
#include "recognition/frames/image_profile.h"
#include "recognition/frames/mirror_search.h"
#include "recognition/model/embeddings.h"
#include "tuning/cue_selection.h"
#include "tuning/family_rounds.h"

namespace place_recognition {
namespace {

Search prepare(const std::vector<RecordingOpener>& recordings,
               const std::vector<RecordingOpener>& hold_out, const TrainingOptions& base,
               const SearchSpace& space, unsigned threads, const Progress& progress,
               const std::string& cells) {
  base.check();
  space.check();
  const TuningRecordings given{recordings, hold_out, commonSize(recordings, progress)};
  Search search{given,
                lookThrough(given, progress),
                withMirror(withNetworks(base), recordings),
                space,
                threads,
                progress,
                {}};
  search.space.cues = withNetworks(withCues(base, space.cues)).cues;
  if (!cells.empty()) search.cells.emplace(cells);
  search.best.cues = base.cues;
  search.best.c = base.svm.c;
  return search;
}

bool isNamed(const std::vector<CueOptions>& cues, const std::string& name) {
  return std::any_of(cues.begin(), cues.end(),
                     [&name](const CueOptions& cue) { return cue.name == name; });
}

/// Appends a cue unless it is among `cues`, under a name that none of them has.
void addDistinct(CueOptions cue, std::vector<CueOptions>& cues) {
  const std::string name = cue.name;
  for (const CueOptions& other : cues) {
    cue.name = other.name;
    if (writeOptions(cue) == writeOptions(other)) return;
  }
  constexpr std::size_t kLongest = 60;  // of a name, to which a number is appended
  cue.name = name;
  for (int number = 2; isNamed(cues, cue.name); ++number) {
    cue.name = name.substr(0, kLongest) + "_" + std::to_string(number);
  }
  cues.push_back(std::move(cue));
}

/// The cues to choose from: those of the base and of the space, and the best of each family.
std::vector<CueOptions> cuesInQuestion(const Thinning& thinning, Search& search) {
  std::vector<CueOptions> cues = search.base.cues;
  for (const CueOptions& cue : search.space.cues) addDistinct(cue, cues);
  for (CueOptions& cue : bestOfEach(candidateFamilies(search.space), thinning, search)) {
    addDistinct(std::move(cue), cues);
  }
  return cues;
}

/// Runs the whole search. search.best is the result, also if the search is stopped.
void look(Search& search) {
  const Thinning thinning = planThinning(search.images.labelled, search.space);
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

/// Every N-th family, because neighbouring families take about the same time.
std::vector<Family> familiesOf(const Part& part, const SearchSpace& space) {
  const std::vector<Family> all = candidateFamilies(space);
  std::vector<Family> families;
  for (std::size_t f = static_cast<std::size_t>(part.number) - 1; f < all.size();
       f += static_cast<std::size_t>(part.count)) {
    families.push_back(all[f]);
  }
  return families;
}

}  // namespace

Tuning tune(const std::vector<RecordingOpener>& recordings,
            const std::vector<RecordingOpener>& hold_out, const TrainingOptions& base,
            const SearchSpace& space, unsigned threads, const Progress& progress,
            const std::string& cells) {
  const auto start = std::chrono::steady_clock::now();
  Search search = prepare(recordings, hold_out, base, space, threads, progress, cells);
  Tuning tuning;
  tuning.images = search.images.labelled;
  try {
    look(search);
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

TuningPart tunePart(const std::vector<RecordingOpener>& recordings,
                    const std::vector<RecordingOpener>& hold_out, const TrainingOptions& base,
                    const SearchSpace& space, const std::string& cells, const Part& part,
                    unsigned threads, const Progress& progress) {
  if (part.number < 1 || part.number > part.count) {
    throw Error("Part " + std::to_string(part.number) + " of " + std::to_string(part.count) +
                " does not exist; count from 1.");
  }
  if (cells.empty()) throw Error("A part of a search needs a folder for its cells; name one.");
  Search search = prepare(recordings, hold_out, base, space, threads, progress, cells);
  bestOfEach(familiesOf(part, space), planThinning(search.images.labelled, space), search);
  return {search.used_cells, search.computed_cells};
}

}  // namespace place_recognition
