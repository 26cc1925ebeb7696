#include "recognition/frames/light_estimate.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include <cmath>
#include <random>

#include "place_recognition/recognizer.h"
#include "recognition/drawn_recording.h"
#include "recognition/frames/colour_normalization.h"
#include "recognition/frames/colour_statistics.h"

namespace place_recognition {
namespace {

constexpr int kPlaces = 4;

ColourStatistics fourRooms() {
  ColourStatistics rooms;
  rooms.means.resize(kPlaces, 3);
  rooms.means << 4.6, 4.7, 4.8, 4.9, 4.7, 4.5, 4.3, 4.5, 4.4, 4.8, 4.9, 5.0;
  rooms.covariance = 0.02 * Eigen::Matrix3d::Constant(1) + 0.005 * Eigen::Matrix3d::Identity();
  return rooms;
}

/// Frames of the four rooms, one per second, a minute in each, whose light has changed by `gains`.
class Stream {
 public:
  explicit Stream(const Eigen::RowVector3d& gains) : gains_(gains.array().log()) {}

  void show(LightEstimate& estimate, int frames) {
    const Eigen::Matrix3d root = rooms_.covariance.llt().matrixL();
    for (int i = 0; i < frames; ++i, ++stamp_) {
      const int place = static_cast<int>(stamp_ / 60) % kPlaces;
      Eigen::Vector3d noise;
      for (int c = 0; c < 3; ++c) noise[c] = normal_(random_);
      const Eigen::RowVector3d colour =
          rooms_.means.row(place) + gains_ + (root * noise).transpose();
      estimate.beginFrame(stamp_);
      estimate.add(colour, Eigen::RowVectorXd::Unit(kPlaces, place));
    }
  }

 private:
  const ColourStatistics rooms_ = fourRooms();
  Eigen::RowVector3d gains_;
  double stamp_ = 0;
  std::mt19937 random_{1};
  std::normal_distribution<double> normal_;
};

void expectGains(const Light& light, double red, double green, double blue, double within) {
  EXPECT_NEAR(std::log(light.red), std::log(red), within);
  EXPECT_NEAR(std::log(light.green), std::log(green), within);
  EXPECT_NEAR(std::log(light.blue), std::log(blue), within);
}

void expectCorrection(const LightEstimate& estimate, double red, double green, double blue,
                      double within) {
  expectGains(estimate.correction(), red, green, blue, within);
}

TEST(LightEstimate, FindsTheGainsOfTheRun) {
  LightEstimate estimate(fourRooms());
  Stream stream({0.6, 0.92, 1.12});  // blue, green, red
  stream.show(estimate, 240);
  expectCorrection(estimate, 1 / 1.12, 1 / 0.92, 1 / 0.6, 0.05);
  EXPECT_GT(estimate.certainty(), 0.9);
}

TEST(LightEstimate, IsTheTrainingsWhileNothingSpeaksAgainstIt) {
  LightEstimate estimate(fourRooms());
  expectCorrection(estimate, 1, 1, 1, 0);
  EXPECT_NEAR(estimate.certainty(), 0.25, 0.02);
  Stream stream({1, 1, 1});
  for (int i = 0; i < 240; ++i) {
    stream.show(estimate, 1);
    if (i >= 10) expectCorrection(estimate, 1, 1, 1, 0.06);
  }
  expectCorrection(estimate, 1, 1, 1, 0.01);
  EXPECT_GT(estimate.certainty(), 0.95);
}

TEST(LightEstimate, DoesNotFollowARobotThatStandsForAnHour) {
  LightEstimate estimate(fourRooms());
  const Eigen::RowVector3d wall = fourRooms().means.row(2).array() + 0.15;  // one deviation off
  for (int second = 0; second < 3600; ++second) {
    estimate.beginFrame(second);
    estimate.add(wall, Eigen::RowVectorXd::Unit(kPlaces, 2));
  }
  expectCorrection(estimate, 1, 1, 1, 0.05);
}

TEST(LightEstimate, DependsOnTimeNotOnTheFrameRate) {
  LightEstimate slow(fourRooms()), fast(fourRooms());
  const Eigen::RowVector3d colour = fourRooms().means.row(0).array() - 0.5;
  const Eigen::RowVectorXd answer = Eigen::RowVectorXd::Unit(kPlaces, 0);
  for (int i = 0; i <= 60; ++i) {
    slow.beginFrame(i);
    slow.add(colour, answer);
  }
  for (int i = 0; i <= 60 * 30; ++i) {
    fast.beginFrame(i / 30.0);
    fast.add(colour, answer);
  }
  expectCorrection(fast, slow.correction().red, slow.correction().green, slow.correction().blue,
                   0.01);
}

TEST(LightEstimate, RestartsWhenTimeJumpsBackAndForgetsOverTime) {
  LightEstimate estimate(fourRooms());
  Stream dark({0.4, 0.4, 0.4});
  dark.show(estimate, 240);
  expectCorrection(estimate, 2.5, 2.5, 2.5, 0.1);
  LightEstimate later = estimate;
  estimate.beginFrame(10);
  expectCorrection(estimate, 1, 1, 1, 0);
  later.beginFrame(240 + 3600);
  expectCorrection(later, 1, 1, 1, 0.05);
  EXPECT_LT(later.certainty(), 0.4);
}

TEST(LightEstimate, OfAModelWithoutStatisticsChangesNothing) {
  LightEstimate estimate((ColourStatistics()));
  estimate.beginFrame(1);
  estimate.add({1, 2, 3}, Eigen::RowVectorXd::Unit(kPlaces, 0));
  expectCorrection(estimate, 1, 1, 1, 0);
  EXPECT_EQ(estimate.certainty(), 1);
}

TEST(ColourStatistics, AreMeansAndPooledCovariance) {
  std::vector<ColourMoments> places(2);
  places[0].add(Eigen::RowVector3d(1, 2, 3));
  places[0].add(Eigen::RowVector3d(3, 2, 1));
  places[1].add(Eigen::RowVector3d(5, 5, 5));
  EXPECT_FALSE(colourStatistics({places[0], {}}).known());
  const ColourStatistics statistics = colourStatistics(places);
  EXPECT_EQ(statistics.means.row(0), Eigen::RowVector3d(2, 2, 2));
  EXPECT_EQ(statistics.means.row(1), Eigen::RowVector3d(5, 5, 5));
  EXPECT_NEAR(statistics.covariance(0, 0), 2.0 / 3, 1e-12);
  EXPECT_NEAR(statistics.covariance(0, 2), -2.0 / 3, 1e-12);
  const ColourStatistics again = colourStatistics(colourMoments(statistics, {2, 1}));
  EXPECT_TRUE(again.means.isApprox(statistics.means));
  EXPECT_TRUE(again.covariance.isApprox(statistics.covariance));
}

TEST(ColourNormalization, BringsMeansToTheSameLevel) {
  const cv::Mat image(20, 30, CV_8UC3, cv::Scalar(40, 80, 120));
  NormalizedImage normalized;
  normalized.set(image, logColour(image), {2, 1, 0.5});
  EXPECT_EQ(normalized.in(ColourNormalization::kNone).data, image.data);
  const auto pixel = [&](ColourNormalization kind) {
    return normalized.in(kind).at<cv::Vec3b>(7, 9);
  };
  EXPECT_EQ(pixel(ColourNormalization::kGreyWorld), cv::Vec3b(110, 110, 110));
  EXPECT_EQ(pixel(ColourNormalization::kBrightness), cv::Vec3b(55, 110, 165));
  EXPECT_EQ(pixel(ColourNormalization::kRun), cv::Vec3b(20, 80, 240));
  normalized.set(image, logColour(image), {});
  EXPECT_EQ(normalized.in(ColourNormalization::kRun).data, image.data);
}

TEST(ColourNormalization, TakesLogarithmsOnce) {
  const cv::Mat image(20, 30, CV_8UC3, cv::Scalar(40, 80, 120));
  NormalizedImage normalized;
  const auto pixel = [&]() -> cv::Vec3b& {
    return cv::Mat(normalized.logarithms(ColourNormalization::kRun)).at<cv::Vec3b>(7, 9);
  };
  normalized.set(image, logColour(image), {2, 1, 0.5});
  EXPECT_EQ(pixel(), cv::Vec3b(73, 161, 250)) << "255 log(1 + v / 16) / log(1 + 255 / 16)";
  pixel() = cv::Vec3b();
  EXPECT_EQ(pixel(), cv::Vec3b());
  normalized.set(image, logColour(image), {});
  EXPECT_EQ(pixel(), cv::Vec3b(113, 161, 193));
}

/// A model of three drawn rooms with a cue that adapts to the light of the recording.
std::shared_ptr<const Model> modelThatFollowsLight() {
  CrfhOptions levels;
  levels.descriptors = {"R", "G", "B"};
  levels.scales = {1};
  levels.bins = {16};
  TrainingOptions options;
  options.cues = {CueOptions(), CueOptions()};
  options.cues[0].name = "colours";
  options.cues[0].normalize = "run";
  options.cues[0].feature = levels;
  options.cues[1].name = "tints";
  options.cues[1].normalize = "grey-world";
  options.cues[1].feature = levels;
  return std::make_shared<const Model>(train({opener(drawFrames(3, 20))}, options).model);
}

TEST(Recognizer, LearnsNothingOfTheLightFromACameraThatShowsNothing) {
  const auto model = modelThatFollowsLight();
  for (const double brightness : {3.0, 253.0}) {
    Recognizer recognizer(model), blinded(model);
    cv::Mat blank(72, 96, CV_8UC3);
    cv::RNG random(1);
    for (double stamp : {-0.2, -0.1}) {
      random.fill(blank, cv::RNG::NORMAL, brightness, 2);
      blinded.recognize(blank, stamp);
    }
    for (const Frame& frame : drawFrames(3, 5, 900)) {
      const double evidence = recognizer.recognize(frame.image, frame.stamp).evidence;
      EXPECT_NEAR(blinded.recognize(frame.image, frame.stamp).evidence, evidence, 0.01);
    }
    EXPECT_NEAR(blinded.lightCorrection().red, recognizer.lightCorrection().red, 0.01);
    EXPECT_NEAR(blinded.evidenceShift(), recognizer.evidenceShift(), 0.01);
  }
}

TEST(Recognizer, FollowsTheLightOfAStream) {
  const auto model = modelThatFollowsLight();
  ASSERT_TRUE(model->colours.known());

  const Light evening{1.1, 0.9, 0.6};
  Recognizer recognizer(model);
  int alone = 0, in_stream = 0;
  for (const Frame& frame : drawFrames(3, 20, 900)) {
    const auto isRight = [&](const Recognition& answer) {
      return model->places[static_cast<std::size_t>(answer.place)] == frame.place;
    };
    const cv::Mat image = inLight(frame.image, evening);
    alone += isRight(recognizer.recognize(image));
    in_stream += isRight(recognizer.recognize(image, frame.stamp));
  }
  EXPECT_GE(in_stream, alone);
  EXPECT_GE(in_stream, 54);
  expectGains(recognizer.lightCorrection(), 1 / evening.red, 1 / evening.green, 1 / evening.blue,
              0.1);
}

}  // namespace
}  // namespace place_recognition
