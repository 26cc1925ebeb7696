#pragma once

#include <string>
#include <vector>

namespace place_recognition {

// Figures of thesis chapter 8 on KTH-INDECS, for comparison with one's own.

/// Table 8.2 or 8.6. Training sets are in the order cloudy, night, sunny.
struct ThesisFinal {
  double gamma[3];
  double average[3];      ///< per cent
  double rates[5][3][3];  ///< [BO, CR, EO, KT, PR][tested on][trained on]; -1: none

  /// The rate of a room. The room is named by the code of the thesis or of KTH-IDOL, or is the most
  /// similar simulated room (office_a is the smaller office, Barbara's); -1 for other rooms or
  /// sets.
  double rate(const std::string& room, const std::string& test_set, int training_set) const;
};

const ThesisFinal& table82();
const ThesisFinal& table86();

/// A row of Table 8.3 or 8.7: the vectors needed to retain `percent` of the rate.
struct ThesisReduction {
  int percent;                            ///< 0: the classifier before reduction
  double rate, rate_deviation;            ///< per cent
  double reduction, reduction_deviation;  ///< fraction of the vectors dropped, per cent
  int vectors, vectors_deviation;
};

const std::vector<ThesisReduction>& table83();
const std::vector<ThesisReduction>& table87();

}  // namespace place_recognition
