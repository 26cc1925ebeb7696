#pragma once

#include <string>
#include <vector>

namespace place_recognition {

/// A row of Table 8.4 or 8.5 as the thesis prints it.
struct ThesisRow {
  std::vector<std::string> descriptors;
  std::vector<double> scales;                       ///< t, the best ones found
  int bins;                                         ///< 0 in Table 8.4, which names none
  double cloudy, night, sunny, average, deviation;  ///< per cent
};

/// All 21 combinations of descriptors.
const std::vector<ThesisRow>& table84();

/// The seven combinations that were carried on with, each at its best scales.
const std::vector<ThesisRow>& table85();

}  // namespace place_recognition
