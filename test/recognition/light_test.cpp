#include "recognition/frames/light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/core.hpp>

#include "place_recognition/recognizer.h"
#include "recognition/drawn_recording.h"
#include "recognition/frames/cue_extraction.h"
#include "recognition/training/samples.h"

namespace place_recognition {
namespace {

TEST(Light, GainsMultiplyTheirChannelsAndSaturate) {
  const cv::Mat image(3, 4, CV_8UC3, cv::Scalar(100, 120, 200));
  const cv::Mat changed = inLight(image, {1.5, 1, 0.5});
  EXPECT_EQ(changed.at<cv::Vec3b>(1, 2), cv::Vec3b(50, 120, 255));
  EXPECT_EQ(image.at<cv::Vec3b>(1, 2), cv::Vec3b(100, 120, 200)) << "the image itself stays";
}

TEST(Light, EveryLevelIsRoundedToTheNearest) {
  cv::Mat image(1, 256, CV_8UC1);
  for (int v = 0; v < 256; ++v) image.at<uchar>(v) = static_cast<uchar>(v);
  for (const double gain : {0.0, 0.001, 0.3, 0.99, 1.0, 1.37, 2.5, 100.0, 1000.0}) {
    const cv::Mat changed = inLight(image, {gain, gain, gain});
    for (int v = 0; v < 256; ++v) {
      const double exact = std::min(gain * v, 255.0);
      EXPECT_NEAR(changed.at<uchar>(v), exact, 0.5 + 255.0 / (1 << 17)) << v << " times " << gain;
    }
  }
}

TEST(Light, GreyImagesTakeTheMeanGain) {
  const cv::Mat image(3, 4, CV_8UC1, cv::Scalar(100));
  EXPECT_EQ(inLight(image, {1.2, 0.8, 0.4}).at<uchar>(0, 0), 80);
}

TEST(Light, SamplesComeInOtherLightBehindThoseAsRecorded) {
  TrainingOptions options = quickOptions();
  options.augmentation.other_light = true;
  std::vector<Frame> frames = drawFrames(2, 5);
  frames[3].place.clear();
  const Samples samples = collectSamples({opener(frames)}, options, 2, {});
  ASSERT_EQ(samples.recorded, 9u);
  ASSERT_EQ(samples.origins.size(), 18u);
  EXPECT_EQ(samples.images, (std::vector<std::uint64_t>{4, 5}));
  CueExtraction extraction(options, ImageProfile());
  std::vector<Feature> feature;
  LightDraw draw(options.seed);
  std::size_t recorded = 0;
  for (const Frame& frame : frames) {
    if (frame.place.empty()) continue;
    const std::size_t copy = samples.recorded + recorded;
    EXPECT_EQ(samples.source[copy], static_cast<int>(recorded));
    EXPECT_EQ(samples.origins[copy].place, samples.origins[recorded].place);
    extraction.extract(inLight(frame.image, draw.next(frame.place)), feature);
    EXPECT_EQ(std::get<SparseVector>(samples.features[0][copy]).values,
              std::get<SparseVector>(feature[0]).values);
    ++recorded;
  }
}

bool same(const Light& a, const Light& b) {
  return a.red == b.red && a.green == b.green && a.blue == b.blue;
}

TEST(LightDraw, GivesEveryLightItsTurnButNoAngleTheSameLight) {
  const std::vector<Light>& lights = otherLights();
  LightDraw draw(1), again(1), other(2);
  constexpr std::size_t kAngles = 12;  // per turn of a tripod; with a fixed order of four lights,
                                       // each would meet only three angles
  std::vector<std::vector<int>> count(kAngles, std::vector<int>(lights.size()));
  bool differs = false;
  for (std::size_t i = 0; i < 40 * kAngles; ++i) {
    const Light light = draw.next("kitchen");
    EXPECT_TRUE(same(light, again.next("kitchen")));
    differs = differs || !same(light, other.next("kitchen"));
    const auto which =
        std::find_if(lights.begin(), lights.end(), [&](const Light& l) { return same(l, light); }) -
        lights.begin();
    ++count[i % kAngles][static_cast<std::size_t>(which)];
    if (i % 3 == 0) again.next("corridor");  // each room has its own order of lights
    if (i % 3 == 0) draw.next("corridor");
  }
  EXPECT_TRUE(differs);
  for (std::size_t l = 0; l < lights.size(); ++l) {
    int total = 0;
    for (const std::vector<int>& angle : count) {
      EXPECT_GT(angle[l], 0);
      total += angle[l];
    }
    EXPECT_EQ(total, static_cast<int>(40 * kAngles / lights.size()));
  }
}

TEST(Light, FoldsKeepAnImageAndItsCopyTogether) {
  const std::vector<Fold> folds = withCopies({{{0, 1}, {2}}}, {0, 1, 2, 0, 2}, true);
  EXPECT_EQ(folds[0].train, (std::vector<int>{0, 1, 3}));
  EXPECT_EQ(folds[0].test, (std::vector<int>{2, 4}));
  EXPECT_EQ(withCopies({{{0, 1}, {2}}}, {0, 1, 2, 0, 2}, false)[0].train, (std::vector<int>{0, 1}));
}

TEST(Light, ARoomLearntInOtherLightIsKnownInIt) {
  TrainingOptions options = twoCueOptions();
  const auto rateInTheDark = [&options] {
    const auto model =
        std::make_shared<const Model>(train({opener(drawFrames(3, 16))}, options).model);
    Recognizer recognizer(model);
    double right = 0;
    for (const Frame& frame : drawFrames(3, 8, 900)) {
      const int place = recognizer.recognize(inLight(frame.image, {0.75, 0.75, 0.75})).place;
      right += model->places[static_cast<std::size_t>(place)] == frame.place ? 1 : 0;
    }
    return right;
  };
  const double before = rateInTheDark();
  options.augmentation.other_light = true;
  EXPECT_GE(rateInTheDark(), before);
}

}  // namespace
}  // namespace place_recognition
