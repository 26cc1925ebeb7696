#pragma once

#include <string>
#include <vector>

namespace place_recognition {

/// A row of Table 8.4 or 8.5, as printed in the thesis.
struct ThesisRow {
  std::vector<std::string> descriptors;
  std::vector<double> scales;                       ///< t, the best of those tried
  int bins;                                         ///< 0 in Table 8.4, which does not state them
  double cloudy, night, sunny, average, deviation;  ///< per cent
};

/// All 21 combinations of descriptors.
const std::vector<ThesisRow>& table84();

/// The seven combinations that the thesis pursues further, each at its best scales.
const std::vector<ThesisRow>& table85();

}  // namespace place_recognition
