#include "experiments/textons.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "error_of.h"
#include "experiments/material_features.h"
#include "scratch_folder.h"

namespace place_recognition {
namespace {

constexpr int kResponses = Mr8FilterBank::kResponses;

/// Responses of an image, drawn around a few centres.
Mr8FilterBank::Responses drawnResponses(cv::Size size, std::uint64_t seed) {
  cv::RNG random(seed);
  cv::Mat1f centres(6, kResponses);
  random.fill(centres, cv::RNG::UNIFORM, -1, 1);
  Mr8FilterBank::Responses responses;
  for (cv::Mat1f& response : responses) response.create(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const int centre = random.uniform(0, centres.rows);
      for (int k = 0; k < kResponses; ++k) {
        responses[k](y, x) = centres(centre, k) + static_cast<float>(random.gaussian(0.3));
      }
    }
  }
  return responses;
}

double squaredDistance(const float* a, const float* b) {
  double sum = 0;
  for (int k = 0; k < kResponses; ++k) sum += std::pow(static_cast<double>(a[k]) - b[k], 2);
  return sum;
}

/// Returns the nearest row of `centres` in begin..end-1, by the definition.
int nearest(const cv::Mat1f& centres, int begin, int end, const float* point) {
  int best = begin;
  for (int i = begin; i < end; ++i) {
    if (squaredDistance(centres[i], point) < squaredDistance(centres[best], point)) best = i;
  }
  return best;
}

TEST(SampledPixels, LieEvenlyOverTheImage) {
  Mr8FilterBank::Responses responses;
  for (int k = 0; k < kResponses; ++k) {
    responses[k].create(4, 5);
    for (int i = 0; i < 20; ++i) responses[k](i / 5, i % 5) = static_cast<float>(100 * k + i);
  }
  const cv::Mat1f four = sampledPixels(responses, 4);
  ASSERT_EQ(four.rows, 4);
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < kResponses; ++k) EXPECT_EQ(four(i, k), 100 * k + 2 + 5 * i);
  }
  EXPECT_EQ(sampledPixels(responses, 99).rows, 20) << "no pixel twice";
}

// Convergence of k-means: each centre is the mean of the pixels of its material that are nearest to
// it.
TEST(TextonDictionary, HoldsCentresOfEachMaterial) {
  const std::vector<cv::Mat1f> materials = {sampledPixels(drawnResponses({60, 50}, 1), 2000),
                                            sampledPixels(drawnResponses({60, 50}, 2), 2000)};
  const cv::Mat1f textons = TextonDictionary(materials).textons();
  constexpr int kCount = TextonDictionary::kPerMaterial;
  ASSERT_EQ(textons.rows, 2 * kCount);
  for (int m = 0; m < 2; ++m) {
    const cv::Mat1f& pixels = materials[static_cast<std::size_t>(m)];
    cv::Mat1d sums = cv::Mat1d::zeros(textons.rows, kResponses);
    std::vector<int> counts(static_cast<std::size_t>(textons.rows), 0);
    for (int i = 0; i < pixels.rows; ++i) {
      const int centre = nearest(textons, m * kCount, (m + 1) * kCount, pixels[i]);
      for (int k = 0; k < kResponses; ++k) sums(centre, k) += pixels(i, k);
      ++counts[static_cast<std::size_t>(centre)];
    }
    for (int centre = m * kCount; centre < (m + 1) * kCount; ++centre) {
      const int count = counts[static_cast<std::size_t>(centre)];
      ASSERT_GT(count, 0);
      for (int k = 0; k < kResponses; ++k) {
        EXPECT_NEAR(textons(centre, k), sums(centre, k) / count, 0.02);
      }
    }
  }
}

TEST(TextonDictionary, OfFewPixelsHoldsThem) {
  const cv::Mat1f pixels = sampledPixels(drawnResponses({60, 50}, 3), 3);
  const cv::Mat1f textons = TextonDictionary(std::vector<cv::Mat1f>{pixels}).textons();
  ASSERT_EQ(textons.rows, 3);
  for (int i = 0; i < 3; ++i) {
    EXPECT_LT(squaredDistance(textons[nearest(textons, 0, 3, pixels[i])], pixels[i]), 1e-10);
  }
}

TEST(TextonDictionary, CountsTheNearestTextonOfEachPixel) {
  const Mr8FilterBank::Responses responses = drawnResponses({41, 23}, 4);
  const TextonDictionary dictionary(
      {sampledPixels(drawnResponses({60, 50}, 5), 500), sampledPixels(responses, 500)});
  const cv::Mat1f& textons = dictionary.textons();
  std::vector<double> expected(static_cast<std::size_t>(textons.rows), 0);
  for (int y = 0; y < 23; ++y) {
    for (int x = 0; x < 41; ++x) {
      float pixel[kResponses];
      for (int k = 0; k < kResponses; ++k) pixel[k] = responses[k](y, x);
      expected[static_cast<std::size_t>(nearest(textons, 0, textons.rows, pixel))] +=
          100.0 / (23 * 41);
    }
  }
  const DenseVector histogram = dictionary.histogram(responses);
  ASSERT_EQ(histogram.values.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(histogram.values[i], expected[i], 1e-4) << "texton " << i;
  }
}

class MaterialFeaturesTest : public testing::Test {
 protected:
  /// Two materials of three samples, two images each.
  MaterialFeaturesTest() {
    for (int sample = 0; sample < 3; ++sample) {
      ImageSet& set = sets_.emplace_back();
      set.name = std::to_string(sample);
      for (const char* material : {"cork", "wool"}) {
        for (int i = 0; i < 2; ++i) {
          const std::string name = std::string(material) + set.name + std::to_string(i) + ".png";
          set.images.push_back({folder_ / name, material, 1.0 * i});
          draw(set.images.back().path, 10 * sample + i + (material[0] == 'c' ? 100 : 200));
        }
      }
    }
  }

  static void draw(const std::string& path, int seed) {
    cv::Mat1b image(60, 70);
    cv::RNG(static_cast<std::uint64_t>(seed)).fill(image, cv::RNG::UNIFORM, 0, 256);
    cv::GaussianBlur(image, image, {}, seed < 200 ? 1 : 3);
    cv::imwrite(path, image);
  }

  ScratchFolder folder_;
  std::vector<ImageSet> sets_;
};

TEST_F(MaterialFeaturesTest, TextonsAreLearnedFromTrainingSamplesOnly) {
  const auto values = [](const std::vector<Feature>& features, std::size_t i) {
    return std::get<DenseVector>(features[i]).values;
  };
  const MaterialFeatures before = extractMaterials("mr8", sets_, {{0}, {1, 2}}, 2, {});
  for (const LabelledImage& image : sets_[1].images) draw(image.path, 999);
  const MaterialFeatures after = extractMaterials("mr8", sets_, {{0}, {1, 2}}, 1, {});
  ASSERT_EQ(before.lists.size(), 2u);
  ASSERT_EQ(before.lists[0].size(), 12u);
  for (std::size_t i = 0; i < 12; ++i) {
    ASSERT_EQ(values(before.lists[0], i).size(), 2u * TextonDictionary::kPerMaterial);
    if (before.samples.sets[i] == 1) continue;
    EXPECT_EQ(values(before.lists[0], i), values(after.lists[0], i)) << i;
    EXPECT_NE(values(before.lists[1], i), values(after.lists[1], i)) << i;
  }
}

TEST_F(MaterialFeaturesTest, AnImageThatCannotBeReadIsNamed) {
  std::remove(sets_[2].images[1].path.c_str());
  const std::string error = errorOf([&] { extractMaterials("mr8", sets_, {{0}}, 1, {}); });
  EXPECT_NE(error.find("cork21.png"), std::string::npos) << error;
}

TEST(MaterialSplits, TrainOnEachSampleEquallyOften) {
  const std::vector<TrainingSamples> splits = materialSplits(4);
  ASSERT_EQ(splits.size(), 12u) << "one, two or three samples, four splits each (section 7.2)";
  for (const std::size_t size : {1u, 2u, 3u}) {
    std::vector<int> counts(4, 0);
    for (const TrainingSamples& split : splits) {
      if (split.size() != size) continue;
      for (const int sample : split) ++counts[static_cast<std::size_t>(sample)];
    }
    EXPECT_EQ(counts, std::vector<int>(4, static_cast<int>(size)));
  }
  EXPECT_EQ(materialSplits(3).size(), 6u) << "two samples are all but one";
}

// (2 x 7 + 2 x 5) x 4 x 2 classifiers per feature and split, section 7.2.
TEST(MaterialGrid, IsTheThesis) {
  EXPECT_EQ(materialKernels().size() * materialSvms().size(), (2u * 7 + 2 * 5) * 4 * 2);
}

}  // namespace
}  // namespace place_recognition
