#include "tuning/family_rounds.h"

#include <algorithm>
#include <string>
#include <utility>

#include "tuning/judged_family.h"

namespace place_recognition {
namespace {

std::size_t stepTo(std::uint64_t images, int wanted) {
  return std::max<std::size_t>(1,
                               static_cast<std::size_t>(images) / static_cast<std::size_t>(wanted));
}

/// The progress of family `index` as a fraction of `round`.
Progress partOfRound(const Search& search, const std::string& round, std::size_t index,
                     std::size_t families) {
  return [&search, round, index, families](const std::string&, double fraction) {
    const double done = (static_cast<double>(index) + fraction) / static_cast<double>(families);
    return !search.progress || search.progress("Looking for cues, " + round, done);
  };
}

/// The `count` best cues of a family, in their previous order.
std::vector<CueOptions> bestOf(const Family& family, std::size_t count, const Round& round,
                               const Progress& progress, Search& search) {
  if (family.cues.size() <= count) return family.cues;
  const JudgedFamily judged = judgeFamily(family, count, round, progress, search);
  search.trials.insert(search.trials.end(), judged.trials.begin(), judged.trials.end());
  std::vector<CueOptions> best;
  for (const std::size_t c : judged.best) best.push_back(family.cues[c]);
  return best;
}

}  // namespace

Thinning planThinning(std::uint64_t images, const SearchSpace& space) {
  return {stepTo(images, space.first_pictures), stepTo(images, space.max_pictures)};
}

std::vector<CueOptions> bestOfEach(std::vector<Family> families, const Thinning& thinning,
                                   Search& search) {
  const bool one_round = thinning.first == thinning.last;
  const int rounds = one_round ? 1 : 2;
  std::size_t step = thinning.first;
  for (int number = 1; number <= rounds; ++number) {
    const Round round{"round " + std::to_string(number) + " of " + std::to_string(rounds), step};
    for (std::size_t f = 0; f < families.size(); ++f) {
      const std::size_t count = number == rounds ? 1 : (families[f].cues.size() + 3) / 4;
      families[f].cues = bestOf(families[f], count, round,
                                partOfRound(search, round.name, f, families.size()), search);
    }
    step = std::max(thinning.last, step / 2);
  }
  std::vector<CueOptions> winners;
  for (const Family& family : families) winners.push_back(family.cues.front());
  return winners;
}

}  // namespace place_recognition
