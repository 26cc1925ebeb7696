// CRFH against its definition in plain loops, on random images and edge cases.
#include <gtest/gtest.h>

#include <cctype>
#include <opencv2/core.hpp>

#include "features/crfh_reference.h"
#include "features/feature_images.h"

namespace place_recognition {
namespace {

struct Case {
  const char* name;
  CrfhOptions options;
  cv::Mat image;
};

CrfhOptions with(std::vector<std::string> descriptors, std::vector<double> scales,
                 std::vector<int> bins) {
  CrfhOptions options;
  options.descriptors = std::move(descriptors);
  options.scales = std::move(scales);
  options.bins = std::move(bins);
  options.border = 0;
  return options;
}

class CrfhReference : public testing::TestWithParam<Case> {};

// Exactly the same bins and counts: in these images no response is within rounding of an edge,
// unless it is exactly zero.
TEST_P(CrfhReference, GivesTheSameHistogram) {
  const auto& [name, options, image] = GetParam();
  const SparseVector histogram = extractSparse(image, options);
  const std::map<std::uint64_t, int> reference = referenceCrfh(image, options);
  int pixels = 0;
  for (const auto& [bin, count] : reference) pixels += count;
  ASSERT_EQ(histogram.size(), reference.size());
  std::size_t i = 0;
  for (const auto& [bin, count] : reference) {
    EXPECT_EQ(histogram.indices[i], bin);
    EXPECT_EQ(histogram.values[i], static_cast<float>(static_cast<double>(count) / pixels));
    ++i;
  }
}

const std::vector<std::string> kSecond = {"Lxx", "Lxy", "Lyy"};
const std::vector<std::string> kAll = {"L",   "Lx",      "Ly",     "Lxx",   "Lxy",
                                       "Lyy", "grad(L)", "lap(L)", "det(L)"};

INSTANTIATE_TEST_SUITE_P(
    Images, CrfhReference,
    testing::Values(
        Case{"thesis", with(kSecond, {1, 4}, {28}), noise(40, 30)},
        Case{"all_operators", with(kAll, {1.7}, {27, 28, 28, 9, 5, 28, 16, 40, 31}), noise(30, 25)},
        Case{"colors", with({"R", "G", "B", "C1", "C2"}, {1, 3}, {9}), noise(30, 30)},
        Case{"derivatives_of_colors",
             with({"Rx", "Gyy", "det(B)", "C1xy", "grad(C2)", "lap(R)"}, {2, 5}, {11}),
             noise(32, 36)},
        Case{"bins_28^7", with({"Lx", "Ly", "Lxx", "Lxy", "Lyy", "L", "grad(L)"}, {1}, {28}),
             noise(30, 20)},
        Case{"bins_28^10", with({"Lx", "Ly", "Lxx", "Lxy", "Lyy"}, {1, 2}, {28}), noise(30, 20)},
        Case{"bins_28^12", with(kSecond, {1, 2, 3, 4}, {28}), noise(30, 20)},
        Case{"bins_65535^4", with({"Lx", "Ly", "Lxx", "Lyy"}, {1}, {65535}), noise(12, 9)},
        Case{"grey", with(kSecond, {1, 4}, {28}), noise(40, 30, CV_8UC1)},
        Case{"narrow", with(kSecond, {1}, {28}), noise(9, 90)},
        Case{"low", with(kSecond, {1}, {28}), noise(90, 9)},
        Case{"one_pixel", with(kSecond, {1}, {28}), noise(9, 9)},
        Case{"black", with(kAll, {1}, {28}), cv::Mat(20, 20, CV_8UC3, cv::Scalar::all(0))},
        Case{"white", with(kAll, {1}, {28}), cv::Mat(20, 20, CV_8UC3, cv::Scalar::all(255))},
        Case{"saturated", with(kAll, {1}, {28}), 255 * (noise(30, 30, CV_8UC1) > 128) / 255},
        Case{"large_scale", with({"Lx", "Lyy"}, {30}, {101}), noise(42, 40)}),
    [](const auto& info) {
      std::string name = info.param.name;
      for (char& c : name) c = std::isalnum(c) ? c : '_';
      return name;
    });

}  // namespace
}  // namespace place_recognition
