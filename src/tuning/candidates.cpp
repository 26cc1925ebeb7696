#include "tuning/candidates.h"

#include <algorithm>
#include <sstream>

#include "place_recognition/error.h"

namespace place_recognition {
namespace {

std::string joined(const std::vector<std::string>& words, char separator) {
  std::string text;
  for (const std::string& word : words)
    text += (text.empty() ? "" : std::string(1, separator)) + word;
  return text;
}

std::string shortNumber(double number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

/// What the cue is, as a plain name: "Lxx-Lxy-Lyy_t1-4_b28", "gradL-lapL_t0p5_b16".
std::string nameOf(const CrfhOptions& crfh) {
  std::vector<std::string> scales;
  for (const double t : crfh.scales) scales.push_back(shortNumber(t));
  std::string name = joined(crfh.descriptors, '-') + "_t" + joined(scales, '-') + "_b" +
                     std::to_string(crfh.bins.front());
  std::replace(name.begin(), name.end(), '.', 'p');
  name.erase(std::remove_if(name.begin(), name.end(),
                            [](char c) { return c == '(' || c == ')' || c == '+'; }),
             name.end());
  constexpr std::size_t kLongest = 64;
  return name.substr(0, kLongest);
}

bool isAllowed(const CrfhOptions& crfh, int max_dimensions) {
  return static_cast<int>(crfh.descriptors.size() * crfh.scales.size()) <= max_dimensions;
}

Family familyOf(const std::vector<std::string>& descriptors, const SearchSpace& space) {
  Family family{joined(descriptors, ' '), {}};
  std::vector<std::vector<double>> scales = space.scales;
  std::stable_sort(scales.begin(), scales.end(),
                   [](const auto& a, const auto& b) { return a.size() < b.size(); });
  std::vector<int> bins = space.bins;
  std::sort(bins.begin(), bins.end());
  for (const std::vector<double>& set : scales) {
    for (const int count : bins) {
      CrfhOptions crfh;
      crfh.descriptors = descriptors;
      crfh.scales = set;
      crfh.bins = {count};
      if (!isAllowed(crfh, space.max_dimensions)) continue;
      crfh.check();
      CueOptions cue;
      cue.name = nameOf(crfh);
      cue.feature = crfh;
      family.cues.push_back(cue);
    }
  }
  return family;
}

}  // namespace

std::vector<Family> candidateFamilies(const TrainingOptions& base, const SearchSpace& space) {
  std::vector<Family> families;
  for (const std::vector<std::string>& descriptors : space.descriptors) {
    Family family = familyOf(descriptors, space);
    if (!family.cues.empty()) families.push_back(std::move(family));
  }
  for (const CueOptions& cue : base.cues) families.push_back({cue.name, {cue}});
  if (families.empty()) {
    throw Error("There is nothing to try: no set of descriptors has at most 'max_dimensions' " +
                std::to_string(space.max_dimensions) + " dimensions; allow more.");
  }
  return families;
}

}  // namespace place_recognition
