#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>

#include "features/feature_images.h"

namespace place_recognition {
namespace {

CrfhOptions one(const std::string& descriptor, double t, int bins) {
  CrfhOptions options;
  options.descriptors = {descriptor};
  options.scales = {t};
  options.bins = {bins};
  options.border = 0;
  return options;
}

/// All pixels give the same response. Expects it in the bin given by the formula.
void expectConstantResponse(const CrfhOptions& options, const cv::Mat& image, double response,
                            double low, double high) {
  const SparseVector histogram = extractSparse(image, options);
  const double level = (response - low) * options.bins[0] / (high - low);
  EXPECT_EQ(histogram.indices, std::vector<std::uint64_t>{static_cast<std::uint64_t>(level)})
      << options.descriptors[0] << ", t = " << options.scales[0] << ", " << options.derivatives;
  EXPECT_EQ(histogram.values, std::vector<float>{1});
}

class CrfhDerivatives : public testing::TestWithParam<const char*> {
 protected:
  CrfhOptions fine(const std::string& descriptor, double t) const {
    CrfhOptions options = one(descriptor, t, 1001);
    options.derivatives = GetParam();
    return options;
  }
};
INSTANTIATE_TEST_SUITE_P(BothMethods, CrfhDerivatives,
                         testing::Values("central-difference", "gaussian"));

TEST_P(CrfhDerivatives, OfARampAreItsSlope) {
  const cv::Mat image = draw(40, 30, [](int x, int y) { return 3 * x + 2 * y + 5; });
  for (double t : {1.0, 4.0, 6.5}) {
    expectConstantResponse(fine("Lx", t), image, 3 * std::sqrt(t), -128, 128);
    expectConstantResponse(fine("Ly", t), image, 2 * std::sqrt(t), -128, 128);
    expectConstantResponse(fine("grad(L)", t), image, std::sqrt(13 * t), 0, 128);
    for (const char* second : {"Lxx", "Lxy", "Lyy", "lap(L)", "det(L)"}) {
      expectConstantResponse(fine(second, t), image, 0, -128, 128);
    }
  }
}

TEST_P(CrfhDerivatives, OfAParabolaAreItsCurvature) {
  const cv::Mat image = draw(31, 31, [](int x, int y) {
    const int u = x - 15, v = y - 15;
    return 128 + u * (u + 1) / 2 - v * (v + 1) / 2;
  });
  for (double t : {1.0, 4.0}) {
    expectConstantResponse(fine("Lxx", t), image, t, -128, 128);
    expectConstantResponse(fine("Lyy", t), image, -t, -128, 128);
    expectConstantResponse(fine("Lxy", t), image, 0, -128, 128);
    expectConstantResponse(fine("lap(L)", t), image, 0, -128, 128);
    expectConstantResponse(fine("det(L)", t), image, -t * t, -32, 32);
  }
}

TEST_P(CrfhDerivatives, OfASaddleAreMixed) {
  const cv::Mat image = draw(23, 23, [](int x, int y) { return 128 + (x - 11) * (y - 11); });
  expectConstantResponse(fine("Lxy", 2), image, 2, -128, 128);
  expectConstantResponse(fine("det(L)", 2), image, -4, -32, 32);
}

TEST_P(CrfhDerivatives, OfAFlatImageAreExactlyZero) {
  for (int level : {0, 1, 77, 255}) {
    CrfhOptions options;  // Zero is the edge of the even number of bins.
    options.derivatives = GetParam();
    options.descriptors = {"Lx", "Ly", "Lxx", "Lxy", "Lyy", "lap(L)", "det(L)"};
    options.scales = {2};
    std::uint64_t index = 0;
    for (int i = 0; i < 7; ++i) index = 28 * index + 14;
    EXPECT_EQ(extractSparse(cv::Mat(40, 50, CV_8UC1, cv::Scalar(level)), options).indices,
              std::vector<std::uint64_t>{index});
  }
}

// At this scale there is no smoothing, and this image has a single pixel inside its border.
TEST(Crfh, IndexIsMixedRadixWithTheFirstDigitFastest) {
  CrfhOptions options;
  options.descriptors = {"R", "G", "B", "C1", "C2"};
  options.scales = {0.01, 0.02};
  options.bins = {5, 10, 17, 4, 6};
  options.border = 0;
  const cv::Mat image(5, 5, CV_8UC3, cv::Scalar(10, 130, 250));  // B, G, R
  // floor((v - low) bins / (high - low)) for R = 250, G = 130, B = 10, C1 = 60, C2 = 180.
  const std::uint64_t digits = 4 + 5 * (5 + 10 * (0 + 17 * (2 + 4 * 5)));
  const std::uint64_t bins = 5 * 10 * 17 * 4 * 6;
  const SparseVector histogram = extractSparse(image, options);
  EXPECT_EQ(histogram.indices, std::vector<std::uint64_t>{digits + bins * digits});
  EXPECT_EQ(histogram.values, std::vector<float>{1});
}

TEST(Crfh, ResponsesBeyondTheRangeFallInTheEndBins) {
  CrfhOptions options = one("Lx", 1, 8);
  options.derivative_range = 0.5;
  const cv::Mat up = draw(20, 20, [](int x, int) { return 10 * x; });
  const cv::Mat down = draw(20, 20, [](int x, int) { return 200 - 10 * x; });
  EXPECT_EQ(extractSparse(up, options).indices, std::vector<std::uint64_t>{7});
  EXPECT_EQ(extractSparse(down, options).indices, std::vector<std::uint64_t>{0});

  // A determinant far beyond what fits an integer.
  options = one("det(L)", 100, 8);
  options.derivative_range = 1e-6;
  const cv::Mat saddle = draw(90, 90, [](int x, int y) { return x / 45 == y / 45 ? 255 : 0; });
  for (std::uint64_t bin : extractSparse(saddle, options).indices) {
    EXPECT_TRUE(bin == 0 || bin == 7);
  }
}

TEST(Crfh, LogarithmicLevelsAreThoseOfTheFormula) {
  cv::Mat levels(noise(60, 50).size(), CV_8UC3);
  const cv::Mat image = noise(60, 50);
  for (int i = 0; i < 60 * 50 * 3; ++i) {
    levels.data[i] = cv::saturate_cast<std::uint8_t>(255 * std::log(1 + image.data[i] / 16.0) /
                                                     std::log(1 + 255 / 16.0));
  }
  CrfhOptions options;
  const SparseVector linear = extractSparse(levels, options);
  EXPECT_NE(linear.indices, extractSparse(image, options).indices);
  options.levels = "logarithmic";
  const SparseVector logarithmic = extractSparse(image, options);
  EXPECT_EQ(logarithmic.indices, linear.indices);
  EXPECT_EQ(logarithmic.values, linear.values);
}

TEST(Crfh, SumsToOneWithAscendingIndices) {
  for (int bins : {1, 2, 28, 65536}) {
    CrfhOptions options;
    options.bins = {bins};
    options.scales = {1};
    const SparseVector histogram = extractSparse(noise(70, 60), options);
    double sum = 0;
    for (float value : histogram.values) sum += value;
    EXPECT_NEAR(sum, 1, 1e-5);
    EXPECT_EQ(histogram.indices.size(), histogram.values.size());
    for (std::size_t i = 1; i < histogram.size(); ++i) {
      ASSERT_LT(histogram.indices[i - 1], histogram.indices[i]);
    }
  }
}

TEST(Crfh, ShiftKeepsTheHistogram) {
  cv::Mat here(90, 100, CV_8UC3, cv::Scalar(90, 120, 60)), there = here.clone();
  const cv::Mat thing = noise(20, 15);
  thing.copyTo(here(cv::Rect(35, 40, 20, 15)));
  thing.copyTo(there(cv::Rect(48, 33, 20, 15)));
  CrfhOptions options;
  options.descriptors = {"L", "Lx", "C2yy", "grad(R)"};
  const SparseVector a = extractSparse(here, options), b = extractSparse(there, options);
  EXPECT_GT(a.size(), 100u);
  EXPECT_EQ(a.indices, b.indices);
  EXPECT_EQ(a.values, b.values);
}

TEST(Crfh, TranspositionSwapsXAndY) {
  CrfhOptions xy, yx;
  xy.descriptors = {"Lx", "Lyy", "Lxy", "det(L)"};
  yx.descriptors = {"Ly", "Lxx", "Lxy", "det(L)"};
  xy.bins = yx.bins = {27};
  const cv::Mat image = noise(60, 50);
  const SparseVector a = extractSparse(image, xy), b = extractSparse(image.t(), yx);
  EXPECT_EQ(a.indices, b.indices);
  EXPECT_EQ(a.values, b.values);
}

TEST(Crfh, GreyImageIsOneWithEqualColours) {
  const cv::Mat grey = noise(60, 50, CV_8UC1);
  cv::Mat colour;
  cv::merge(std::vector<cv::Mat>(3, grey), colour);
  CrfhOptions options;
  options.descriptors = {"L", "Rx", "Gyy", "Bxy", "C1", "C2"};
  options.bins = {10};
  EXPECT_EQ(extractSparse(grey, options).indices, extractSparse(colour, options).indices);
  EXPECT_EQ(extractSparse(grey, options).values, extractSparse(colour, options).values);
}

TEST(Crfh, SigmaIsTheRootOfScale) {
  CrfhOptions scales, sigmas;
  scales.scales = {2.25, 9};
  sigmas.sigmas = {1.5, 3};
  const cv::Mat image = noise(60, 50);
  EXPECT_EQ(extractSparse(image, scales).indices, extractSparse(image, sigmas).indices);
}

TEST(Crfh, ExtractorKeepsNothingFromImageToImage) {
  CrfhOptions options;
  options.descriptors = {"L", "Lx", "C1yy"};
  const auto extractor = makeFeatureExtractor(options);
  const cv::Mat large = noise(100, 80);
  const std::vector<cv::Mat> images = {large, large(cv::Rect(7, 9, 50, 61)), noise(41, 99, CV_8UC1),
                                       noise(20, 20), large};
  Feature feature;
  for (const cv::Mat& image : images) {
    extractor->extract(image, feature);
    if (image.rows == 20) {
      EXPECT_TRUE(isMissing(feature));
    } else {
      EXPECT_EQ(std::get<SparseVector>(feature).indices,
                extractSparse(image.clone(), options).indices);
      EXPECT_EQ(std::get<SparseVector>(feature).values,
                extractSparse(image.clone(), options).values);
    }
  }
}

TEST(Crfh, ImageWithinItsBorderHasNoFeature) {
  const auto extractor = makeFeatureExtractor(CrfhOptions());
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(30, 200), cv::Size(200, 30)}) {
    Feature feature = SparseVector();
    extractor->extract(noise(size.width, size.height), feature);
    EXPECT_TRUE(isMissing(feature));
    EXPECT_NE(extractor->missingReason().find("15"), std::string::npos)
        << extractor->missingReason();
  }
  Feature feature;
  extractor->extract(noise(31, 31), feature);  // A single pixel.
  EXPECT_EQ(std::get<SparseVector>(feature).values, std::vector<float>{1});
}

// At t = 100 the kernel is 30 pixels to each side, and the derivative takes one more.
TEST(Crfh, BorderGrowsWithTheScale) {
  const auto extractor = makeFeatureExtractor(one("Lx", 100, 28));
  Feature feature;
  extractor->extract(noise(62, 100), feature);
  EXPECT_TRUE(isMissing(feature));
  extractor->extract(noise(63, 63), feature);
  EXPECT_FALSE(isMissing(feature));
}

}  // namespace
}  // namespace place_recognition
