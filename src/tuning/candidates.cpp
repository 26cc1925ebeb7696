#include "tuning/candidates.h"

#include <algorithm>
#include <set>

#include "base/text.h"

namespace place_recognition {
namespace {

/// A name that describes the cue: "Lxx-Lxy-Lyy_t1-4_b28", "gradL-lapL_t0p5_b16".
std::string nameOf(const CrfhOptions& crfh) {
  std::vector<std::string> scales;
  for (const double t : crfh.scales) scales.push_back(significant(t));
  std::string name = listed(crfh.descriptors, "-") + "_t" + listed(scales, "-") + "_b" +
                     std::to_string(crfh.bins.front());
  std::replace(name.begin(), name.end(), '.', 'p');
  name.erase(std::remove_if(name.begin(), name.end(),
                            [](char c) { return c == '(' || c == ')' || c == '+'; }),
             name.end());
  constexpr std::size_t kLongest = 62;  // length of a name, to which "_g" may be appended
  return name.substr(0, kLongest);
}

bool isAllowed(const CrfhOptions& crfh, int max_dimensions) {
  return static_cast<int>(crfh.descriptors.size() * crfh.scales.size()) <= max_dimensions;
}

/// Brightness and colours, as opposed to their derivatives.
bool isColour(const std::vector<std::string>& descriptors) {
  static const std::set<std::string> channels{"L", "R", "G", "B", "C1", "C2"};
  return std::all_of(descriptors.begin(), descriptors.end(),
                     [](const std::string& name) { return channels.count(name) > 0; });
}

CueOptions cueOf(const CrfhOptions& crfh, const std::string& normalize) {
  CueOptions cue;
  cue.name = nameOf(crfh) + (normalize == "grey-world" ? "_g" : "");
  cue.normalize = normalize;
  cue.feature = crfh;
  return cue;
}

Family familyOf(const std::vector<std::string>& descriptors, const SearchSpace& space) {
  Family family{listed(descriptors, " "), {}};
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
      crfh.levels = isColour(descriptors) ? "linear" : "logarithmic";
      if (!isAllowed(crfh, space.max_dimensions)) continue;
      crfh.check();
      if (!isColour(descriptors)) {
        family.cues.push_back(cueOf(crfh, "none"));
      } else {
        for (const char* normalize : {"run", "grey-world"}) {
          family.cues.push_back(cueOf(crfh, normalize));
        }
      }
    }
  }
  return family;
}

}  // namespace

std::vector<Family> candidateFamilies(const SearchSpace& space) {
  std::vector<Family> families;
  for (const std::vector<std::string>& descriptors : space.descriptors) {
    Family family = familyOf(descriptors, space);
    if (!family.cues.empty()) families.push_back(std::move(family));
  }
  return families;
}

}  // namespace place_recognition
