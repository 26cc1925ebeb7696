#include "features/mr8.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>
#include <opencv2/imgproc.hpp>

#include "features/feature_images.h"
#include "features/local_images.h"
#include "features/mr8_responses.h"
#include "place_recognition/error.h"

namespace place_recognition {
namespace {

double respond(const cv::Mat1f& image, int x, int y, const cv::Mat1f& filter) {
  constexpr int kHalf = Mr8FilterBank::kSupport / 2;
  double sum = 0;
  for (int v = -kHalf; v <= kHalf; ++v) {
    for (int u = -kHalf; u <= kHalf; ++u) {
      sum += static_cast<double>(filter(kHalf - v, kHalf - u)) *
             image(cv::borderInterpolate(y + v, image.rows, cv::BORDER_REFLECT_101),
                   cv::borderInterpolate(x + u, image.cols, cv::BORDER_REFLECT_101));
    }
  }
  return sum;
}

/// The definition: each filter separately, then the maximum over orientations.
std::array<double, Mr8FilterBank::kResponses> reference(const cv::Mat1f& image, int x, int y) {
  std::array<double, Mr8FilterBank::kResponses> responses{};
  for (int scale = 0; scale < Mr8FilterBank::kScales; ++scale) {
    for (int i = 0; i < Mr8FilterBank::kOrientations; ++i) {
      const double edge = respond(image, x, y, Mr8FilterBank::edge(scale, i));
      const double bar = respond(image, x, y, Mr8FilterBank::bar(scale, i));
      responses[scale] = std::max(responses[scale], std::abs(edge));
      responses[scale + 3] = std::max(responses[scale + 3], std::abs(bar));
    }
  }
  responses[6] = respond(image, x, y, Mr8FilterBank::gaussian());
  responses[7] = respond(image, x, y, Mr8FilterBank::laplacian());
  return responses;
}

TEST(Mr8FilterBank, FiltersHaveZeroMeanAndNormOne) {
  for (int scale = 0; scale < Mr8FilterBank::kScales; ++scale) {
    for (int i = 0; i < Mr8FilterBank::kOrientations; ++i) {
      for (const cv::Mat1f& filter :
           {Mr8FilterBank::edge(scale, i), Mr8FilterBank::bar(scale, i)}) {
        EXPECT_NEAR(cv::sum(filter)[0], 0, 1e-6);
        EXPECT_NEAR(cv::norm(filter, cv::NORM_L1), 1, 1e-6);
      }
    }
  }
  EXPECT_NEAR(cv::sum(Mr8FilterBank::gaussian())[0], 1, 1e-6);
  EXPECT_NEAR(cv::sum(Mr8FilterBank::laplacian())[0], 0, 1e-6);
}

TEST(Mr8FilterBank, RespondsAsTheDefinitionSays) {
  const cv::Mat1f image = texture(75, 62, 1) / 128 - 1;
  Mr8FilterBank::Responses responses;
  Mr8FilterBank().apply(image, responses);
  for (const cv::Point p : {cv::Point(0, 0), cv::Point(74, 61), cv::Point(3, 50), cv::Point(37, 30),
                            cv::Point(60, 12)}) {
    const auto expected = reference(image, p.x, p.y);
    for (int k = 0; k < Mr8FilterBank::kResponses; ++k) {
      ASSERT_EQ(responses[k].size(), image.size());
      EXPECT_NEAR(responses[k](p), expected[k], 1e-5) << "response " << k << " at " << p;
    }
  }
}

/// The same for all pixels, with OpenCV's filters.
Mr8FilterBank::Responses reference(const cv::Mat1f& image) {
  const auto filtered = [&](const cv::Mat1f& filter) {
    cv::Mat1f response;
    cv::filter2D(image, response, CV_32F, filter, {-1, -1}, 0, cv::BORDER_REFLECT_101);
    return response;
  };
  Mr8FilterBank::Responses responses;
  for (int scale = 0; scale < Mr8FilterBank::kScales; ++scale) {
    cv::Mat1f& edges = responses[scale] = cv::Mat1f::zeros(image.size());
    cv::Mat1f& bars = responses[3 + scale] = cv::Mat1f::zeros(image.size());
    for (int i = 0; i < Mr8FilterBank::kOrientations; ++i) {
      cv::max(edges, cv::abs(filtered(Mr8FilterBank::edge(scale, i))), edges);
      cv::max(bars, cv::abs(filtered(Mr8FilterBank::bar(scale, i))), bars);
    }
  }
  responses[6] = filtered(Mr8FilterBank::gaussian());
  responses[7] = filtered(Mr8FilterBank::laplacian());
  return responses;
}

// One tile, several, and partial ones.
TEST(Mr8FilterBank, RespondsToImagesOfAnySize) {
  Mr8FilterBank bank;
  Mr8FilterBank::Responses responses;
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(3, 40), cv::Size(320, 240),
                              cv::Size(333, 25), cv::Size(70, 643)}) {
    const cv::Mat1f image = texture(size.width, size.height, 1) / 128 - 1;
    bank.apply(image, responses);
    const Mr8FilterBank::Responses expected = reference(image);
    for (int k = 0; k < Mr8FilterBank::kResponses; ++k) {
      ASSERT_EQ(responses[k].size(), size);
      EXPECT_LT(cv::norm(responses[k], expected[k], cv::NORM_INF), 1e-5)
          << "response " << k << " to " << size;
    }
  }
}

TEST(Mr8FilterBank, TurnsWithTheImageByQuarters) {
  const cv::Mat1f image = texture(80, 70, 2) / 128 - 1;
  cv::Mat1f turned_image, expected;
  cv::rotate(image, turned_image, cv::ROTATE_90_CLOCKWISE);
  Mr8FilterBank bank;
  Mr8FilterBank::Responses responses, turned;
  bank.apply(image, responses);
  bank.apply(turned_image, turned);
  for (int k = 0; k < Mr8FilterBank::kResponses; ++k) {
    cv::rotate(responses[k], expected, cv::ROTATE_90_CLOCKWISE);
    EXPECT_LT(cv::norm(expected, turned[k], cv::NORM_INF), 1e-5) << "response " << k;
  }
}

/// Waves of 9 to 30 pixels in all directions, rotated by an angle about the centre.
cv::Mat1f waves(int size, double angle) {
  cv::Mat1f image(size, size);
  for (int row = 0; row < size; ++row) {
    for (int column = 0; column < size; ++column) {
      const double dx = column - size / 2, dy = row - size / 2;
      const double x = std::cos(angle) * dx + std::sin(angle) * dy;
      const double y = -std::sin(angle) * dx + std::cos(angle) * dy;
      double value = 0;
      for (int i = 0; i < 12; ++i) {
        const double direction = 2.4 * i, length = 9 + 21 * i / 11.0;
        value += std::sin(2 * CV_PI * (std::cos(direction) * x + std::sin(direction) * y) / length +
                          1.7 * i);
      }
      image(row, column) = static_cast<float>(value);
    }
  }
  return image;
}

// Only nearly, because the finest filters are sampled coarsely and the widest are cut by their
// square support.
TEST(Mr8FilterBank, NearlyIgnoresTurnsByTheStepOfOrientations) {
  constexpr int kSize = 101, kMiddle = 50;
  Mr8FilterBank bank;
  Mr8FilterBank::Responses upright, turned;
  bank.apply(waves(kSize, 0), upright);
  for (const int degrees : {30, 60, 120, 150}) {
    bank.apply(waves(kSize, degrees * CV_PI / 180), turned);
    for (int k = 0; k < Mr8FilterBank::kResponses; ++k) {
      const double scale = cv::norm(upright[k], cv::NORM_INF);
      EXPECT_NEAR(turned[k](kMiddle, kMiddle), upright[k](kMiddle, kMiddle), 0.06 * scale)
          << "response " << k << " at " << degrees << " degrees";
    }
  }
}

TEST(Mr8Responses, AreScaledByContrast) {
  // A thousandth of the contrast on the right.
  cv::Mat1f image = texture(120, 90, 6);
  image.colRange(60, 120) = image.colRange(60, 120) / 100 + 128;
  Mr8Responses plain(false), scaled(true);
  const Mr8FilterBank::Responses& r = plain.of(cv::Mat1b(image));
  const Mr8FilterBank::Responses& s = scaled.of(cv::Mat1b(image));
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      double square = 0;
      for (const cv::Mat1f& response : r) square += std::pow(response(y, x), 2);
      const double norm = std::sqrt(square);
      for (int k = 0; k < Mr8FilterBank::kResponses; ++k) {
        ASSERT_NEAR(s[k](y, x), r[k](y, x) * std::log1p(norm / 0.03) / norm, 1e-6);
      }
    }
  }
}

TEST(Mr8, CountsTheLevelsOfTheResponses) {
  const cv::Mat1b image(texture(80, 60, 7));
  const Mr8FilterBank::Responses responses = Mr8Responses(true).of(image);
  for (const int bins : {2, 5, 200}) {
    Mr8Options options;
    options.bins = bins;
    options.range = 0.7;
    std::map<std::uint64_t, double> expected;
    for (int y = 0; y < image.rows; ++y) {
      for (int x = 0; x < image.cols; ++x) {
        std::uint64_t bin = 0;
        for (int k = 7; k >= 0; --k) {
          const double fraction = responses[k](y, x) / options.range;
          const double level = std::floor(bins * (k < 6 ? fraction : (fraction + 1) / 2));
          bin = bin * bins + static_cast<std::uint64_t>(std::clamp(level, 0.0, bins - 1.0));
        }
        expected[bin] += 1.0 / static_cast<double>(image.total());
      }
    }
    const SparseVector h = extractSparse(image, options);
    double difference = 0;
    for (std::size_t i = 0; i < h.size(); ++i) expected[h.indices[i]] -= h.values[i];
    for (const auto& [bin, rest] : expected) difference += std::abs(rest);
    EXPECT_LT(difference, 2e-3) << bins << " bins; but for pixels within rounding of a level";
  }
}

TEST(Mr8, IsAJointHistogram) {
  const SparseVector h = extractSparse(cv::Mat1b(texture(120, 90, 3)), Mr8Options());
  EXPECT_NEAR(std::accumulate(h.values.begin(), h.values.end(), 0.0), 1, 1e-5);
  EXPECT_TRUE(std::is_sorted(h.indices.begin(), h.indices.end()));
  EXPECT_LT(h.indices.back(), 65536u) << "4^8 bins";
  EXPECT_GT(h.size(), 100u);
}

// Every response to a blank image is zero: the lowest level of the magnitudes, the third of
// four of the Gaussian and its Laplacian.
TEST(Mr8, OfABlankImageHasOneBin) {
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(30, 7), cv::Size(200, 100)}) {
    for (const std::uint8_t grey : {9, 18, 93}) {
      const SparseVector h = extractSparse(cv::Mat1b(size, grey), Mr8Options());
      ASSERT_EQ(h.size(), 1u);
      EXPECT_EQ(h.indices[0], 2u * 4096 + 2u * 16384);
      EXPECT_EQ(h.values[0], 1);
    }
  }
}

TEST(Mr8, IgnoresBrightnessAndContrast) {
  const cv::Mat1b image = cv::Mat1b(texture(120, 90, 4)) / 4;
  const SparseVector a = extractSparse(image, Mr8Options()),
                     b = extractSparse(image * 3 + 40, Mr8Options());
  double difference = 0;
  std::size_t j = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    while (j < b.size() && b.indices[j] < a.indices[i]) difference += b.values[j++];
    const bool shared = j < b.size() && b.indices[j] == a.indices[i];
    difference += std::abs(a.values[i] - (shared ? b.values[j++] : 0));
  }
  EXPECT_LT(difference, 1e-3) << "but for pixels within rounding of a level";
}

TEST(Mr8, IsTheSameEveryTimeAndInColour) {
  const cv::Mat1b image(texture(120, 90, 5));
  cv::Mat colour;
  cv::cvtColor(image, colour, cv::COLOR_GRAY2BGR);
  Mr8Extractor extractor{Mr8Options()};
  Feature feature;
  for (const cv::Mat& image : {cv::Mat(image), cv::Mat(image(cv::Rect(5, 5, 50, 40))), colour}) {
    extractor.extract(image, feature);
    const SparseVector expected = extractSparse(image, Mr8Options());
    EXPECT_EQ(std::get<SparseVector>(feature).indices, expected.indices);
    EXPECT_EQ(std::get<SparseVector>(feature).values, expected.values);
  }
  EXPECT_EQ(extractSparse(colour, Mr8Options()).values, extractSparse(image, Mr8Options()).values);
}

TEST(Mr8Options, RefuseWhatIsOutOfRange) {
  const auto refused = [](auto change) {
    Mr8Options options;
    change(options);
    EXPECT_THROW(makeFeatureExtractor(options), Error);
  };
  refused([](auto& o) { o.bins = 1; });
  refused([](auto& o) { o.bins = 201; });
  refused([](auto& o) { o.range = 0; });
  refused([](auto& o) { o.range = std::nan(""); });
}

}  // namespace
}  // namespace place_recognition
