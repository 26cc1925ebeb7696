#include "features/lbp.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <opencv2/imgproc.hpp>

#include "features/feature_images.h"
#include "place_recognition/error.h"

namespace place_recognition {
namespace {

int codeOf(const cv::Mat1b& patch) { return LbpOperator({8, 1}).encodeRow(patch, 1).at(0); }

TEST(Lbp, CodesOfSmallPatches) {
  const auto patch = [](std::initializer_list<std::uint8_t> values) {
    return cv::Mat1b(std::vector<std::uint8_t>(values), true).reshape(1, 3).clone();
  };
  EXPECT_EQ(codeOf(patch({7, 7, 7, 7, 7, 7, 7, 7, 7})), 8) << "even: all as bright as the centre";
  EXPECT_EQ(codeOf(patch({50, 50, 50, 50, 100, 50, 50, 50, 50})), 0) << "a bright spot";
  EXPECT_EQ(codeOf(patch({150, 150, 150, 150, 100, 150, 150, 150, 150})), 8) << "a dark spot";
  EXPECT_EQ(codeOf(patch({50, 50, 150, 50, 100, 150, 50, 50, 150})), 3) << "an edge";
  EXPECT_EQ(codeOf(patch({50, 50, 50, 50, 100, 150, 50, 50, 50})), 1) << "a line's end";
  EXPECT_EQ(codeOf(patch({0, 200, 0, 200, 100, 200, 0, 200, 0})), 9) << "a cross: not uniform";
  EXPECT_EQ(codeOf(patch({0, 200, 0, 0, 100, 0, 0, 200, 0})), 9) << "a line: changes four times";
}

/// Returns the code by the definition, in double precision. Sets `unsure` if a neighbour is within
/// rounding of the centre.
int reference(const cv::Mat1b& image, int x, int y, const LbpCircle& circle, bool& unsure) {
  std::vector<int> bits;
  unsure = false;
  for (int i = 0; i < circle.points; ++i) {
    const double angle = 2 * CV_PI * i / circle.points;
    const double px = x + circle.radius * std::cos(angle), py = y + circle.radius * std::sin(angle);
    double value = 0;
    for (int v = 0; v < image.rows; ++v) {
      for (int u = 0; u < image.cols; ++u) {
        value +=
            image(v, u) * std::max(0.0, 1 - std::abs(u - px)) * std::max(0.0, 1 - std::abs(v - py));
      }
    }
    unsure |= std::abs(value - image(y, x)) < 0.15;
    bits.push_back(value >= image(y, x));
  }
  int changes = 0;
  for (int i = 0; i < circle.points; ++i) changes += bits[i] != bits[(i + 1) % circle.points];
  return changes <= 2 ? std::accumulate(bits.begin(), bits.end(), 0) : circle.points + 1;
}

TEST(Lbp, CodesAreThoseOfTheDefinition) {
  cv::Mat1b image = noise(24, 20, CV_8UC1);
  cv::GaussianBlur(image, image, cv::Size(), 1.5);  // otherwise hardly any pattern is uniform
  for (const LbpCircle& circle : std::vector<LbpCircle>{{8, 1}, {16, 2}, {24, 3}, {5, 1.7}}) {
    LbpOperator op(circle);
    int compared = 0;
    for (int y = op.border(); y < image.rows - op.border(); ++y) {
      const std::vector<std::int32_t>& codes = op.encodeRow(image, y);
      for (int x = op.border(); x < image.cols - op.border(); ++x) {
        bool unsure;
        const int code = reference(image, x, y, circle, unsure);
        if (unsure) continue;
        ++compared;
        EXPECT_EQ(codes[x - op.border()], code) << circle.points << " points at " << x << ", " << y;
      }
    }
    EXPECT_GT(compared, 100);
  }
}

TEST(Lbp, HistogramsSumToOneEach) {
  const std::vector<float> values = extractDense(noise(60, 40, CV_8UC1), LbpOptions());
  ASSERT_EQ(values.size(), 10u + 18 + 26);
  EXPECT_NEAR(std::accumulate(values.begin(), values.begin() + 10, 0.0), 1, 1e-6);
  EXPECT_NEAR(std::accumulate(values.begin() + 10, values.begin() + 28, 0.0), 1, 1e-6);
  EXPECT_NEAR(std::accumulate(values.begin() + 28, values.end(), 0.0), 1, 1e-6);

  const std::vector<float> even = extractDense(cv::Mat1b(30, 30, std::uint8_t{77}), LbpOptions());
  EXPECT_EQ(even[8], 1);
  EXPECT_EQ(even[10 + 16], 1);
  EXPECT_EQ(even[28 + 24], 1);
}

TEST(Lbp, IgnoresQuarterTurnsAndContrast) {
  const cv::Mat1b image = noise(70, 50, CV_8UC1) / 4;
  const std::vector<float> values = extractDense(image, LbpOptions());
  for (const int turn : {cv::ROTATE_90_CLOCKWISE, cv::ROTATE_180, cv::ROTATE_90_COUNTERCLOCKWISE}) {
    cv::Mat turned;
    cv::rotate(image, turned, turn);
    EXPECT_EQ(extractDense(turned, LbpOptions()), values);
  }
  EXPECT_EQ(extractDense(image * 3 + 20, LbpOptions()), values);
}

TEST(Lbp, OfGreyImagesInColourIsTheSame) {
  cv::Mat colour;
  cv::cvtColor(noise(40, 30, CV_8UC1), colour, cv::COLOR_GRAY2BGR);
  EXPECT_EQ(extractDense(colour, LbpOptions()), extractDense(noise(40, 30, CV_8UC1), LbpOptions()));
}

TEST(Lbp, IsMissingInImagesSmallerThanACircle) {
  LbpExtractor extractor{LbpOptions()};
  Feature feature;
  extractor.extract(noise(7, 7, CV_8UC1), feature);
  EXPECT_FALSE(isMissing(feature));
  extractor.extract(noise(200, 6, CV_8UC1), feature);
  EXPECT_TRUE(isMissing(feature));
  EXPECT_EQ(extractor.missingReason(),
            "the image of 200 x 6 pixels has no pixel farther than 3 from its edges");
}

TEST(LbpOptions, RefuseWhatIsOutOfRange) {
  for (const std::vector<LbpCircle>& circles :
       std::vector<std::vector<LbpCircle>>{{}, {{3, 1}}, {{33, 1}}, {{8, 0.4}}, {{8, 16.1}}}) {
    LbpOptions options;
    options.circles = circles;
    EXPECT_THROW(makeFeatureExtractor(options), Error);
  }
}

}  // namespace
}  // namespace place_recognition
