#include "experiments/thesis_places.h"

#include <map>

namespace place_recognition {
namespace {

constexpr double kNone = -1;

int indexIn(const std::map<std::string, int>& names, const std::string& name) {
  const auto found = names.find(name);
  return found == names.end() ? -1 : found->second;
}

}  // namespace

double ThesisFinal::rate(const std::string& room, const std::string& test_set,
                         int training_set) const {
  static const std::map<std::string, int> kRooms = {
      {"BO", 0}, {"office_a", 0}, {"CR", 1}, {"corridor", 1}, {"EO", 2},          {"office_b", 2},
      {"KT", 3}, {"kitchen", 3},  {"PR", 4}, {"PA", 4},       {"printer_area", 4}};
  static const std::map<std::string, int> kSets = {{"cloudy", 0}, {"night", 1}, {"sunny", 2}};
  const int r = indexIn(kRooms, room), s = indexIn(kSets, test_set);
  return r < 0 || s < 0 ? kNone : rates[r][s][training_set];
}

const ThesisFinal& table82() {
  static const ThesisFinal table = {
      {2.585, 2.585, 2.239},
      {73.65, 67.59, 66.95},
      {{{kNone, 48.98, 30.61}, {52.58, kNone, 34.02}, {28.87, 27.84, kNone}},
       {{kNone, 97.53, 96.70}, {97.53, kNone, 93.41}, {97.24, 93.65, kNone}},
       {{kNone, 83.44, 76.43}, {88.31, kNone, 76.62}, {73.79, 73.79, kNone}},
       {{kNone, 68.39, 78.76}, {77.08, kNone, 63.54}, {84.97, 70.47, kNone}},
       {{kNone, 63.03, 67.30}, {69.67, kNone, 52.13}, {66.51, 48.80, kNone}}}};
  return table;
}

const ThesisFinal& table86() {
  static const ThesisFinal table = {
      {11.092, 16.788, 10.839},
      {81.10, 72.18, 73.74},
      {{{kNone, 64.82, 49.07}, {82.41, kNone, 44.44}, {44.44, 48.15, kNone}},
       {{kNone, 94.79, 95.31}, {94.53, kNone, 87.50}, {95.05, 89.84, kNone}},
       {{kNone, 87.50, 90.48}, {91.67, kNone, 84.52}, {85.26, 82.05, kNone}},
       {{kNone, 71.76, 92.13}, {80.56, kNone, 83.80}, {93.52, 64.82, kNone}},
       {{kNone, 62.04, 67.13}, {59.72, kNone, 43.06}, {83.80, 56.02, kNone}}}};
  return table;
}

const std::vector<ThesisReduction>& table83() {
  static const std::vector<ThesisReduction> rows = {
      {0, 69.40, 3.70, 0, 0, 968, 17},         {100, 69.40, 3.70, 3.90, 6.55, 929, 56},
      {99, 68.71, 3.66, 10.07, 4.26, 870, 38}, {98, 68.01, 3.62, 16.74, 4.57, 805, 46},
      {97, 67.32, 3.59, 24.79, 1.56, 728, 28}, {96, 66.62, 3.55, 27.47, 1.80, 702, 28},
      {95, 65.93, 3.51, 31.50, 2.10, 663, 23}, {90, 62.46, 3.33, 49.16, 5.71, 492, 63},
      {85, 58.99, 3.14, 59.63, 2.16, 390, 26}, {80, 55.52, 2.96, 70.63, 3.39, 284, 35}};
  return rows;
}

const std::vector<ThesisReduction>& table87() {
  static const std::vector<ThesisReduction> rows = {
      {0, 75.67, 4.76, 0, 0, 1000, 29},        {100, 75.67, 4.76, 0.99, 0.57, 990, 31},
      {99, 74.92, 4.71, 2.40, 0.74, 976, 35},  {98, 74.16, 4.67, 4.70, 1.09, 953, 38},
      {97, 73.40, 4.62, 7.19, 0.60, 928, 32},  {96, 72.65, 4.57, 12.66, 0.65, 873, 25},
      {95, 71.89, 4.52, 17.65, 2.44, 823, 37}, {90, 68.11, 4.29, 32.28, 3.95, 677, 53},
      {85, 64.32, 4.05, 47.48, 3.59, 526, 50}, {80, 60.54, 3.81, 59.43, 2.35, 406, 36}};
  return rows;
}

}  // namespace place_recognition
