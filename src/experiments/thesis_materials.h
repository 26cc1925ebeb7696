#pragma once

#include <string>
#include <vector>

namespace place_recognition {

/// The percentages of the initial rate that the tables of chapter 7 retain.
constexpr int kMaterialFractions[] = {100, 98, 95, 90, 80};

/// One classifier of Tables 7.1 to 7.6, on KTH-TIPS2.
struct ThesisMaterial {
  std::string kernel;
  double rate, rate_deviation;  ///< before reduction, per cent
  int vectors;                  ///< before reduction
  double reduction[5];          ///< at kMaterialFractions, per cent
};

/// A table of chapter 7: its fixed parameters, and its rows.
struct ThesisMaterialTable {
  const char* number;
  const char* feature;     ///< mr8 or lbp
  const char* multiclass;  ///< as in SvmOptions
  std::vector<ThesisMaterial> rows;
};

/// Tables 7.1 (by gamma), 7.2 (by C), 7.3 ... 7.6 (by kernel).
const std::vector<ThesisMaterialTable>& materialTables();

}  // namespace place_recognition
