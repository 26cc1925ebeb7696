// The correlation of the errors of several cameras on one robot.

#include "place_recognition/camera_correlation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "place_recognition/model_file.h"
#include "place_recognition/training.h"
#include "recognition/drawn_recording.h"
#include "recognition/training/camera_correlation_training.h"

namespace place_recognition {
namespace {

/// Held-out answers of two cameras about two rooms at `count` moments, one second apart. The second
/// camera's frames are `offset` s later. Their log odds are Gaussian with correlation `shared`.
struct Moments {
  Moments(int count, double shared, double offset) {
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    held_out.decision_values.resize(2 * count, 2);
    held_out.valid.assign(static_cast<std::size_t>(2 * count), true);
    for (int i = 0; i < count; ++i) {
      const double a = normal(random);
      const double b = shared * a + std::sqrt(1 - shared * shared) * normal(random);
      const int place = i % 2;
      for (const int camera : {0, 1}) {
        const double log_odds = 0.5 + 0.5 * (camera == 0 ? a : b);
        const auto row = static_cast<Eigen::Index>(samples.size());
        held_out.decision_values(row, place) = log_odds / 2;
        held_out.decision_values(row, 1 - place) = -log_odds / 2;
        samples.push_back({place, 0, 100.0 + i + camera * offset, camera});
        said[camera].push_back(log_odds);
      }
    }
  }

  double learned(const std::vector<std::string>& cameras = {"/rear", "/front"}) const {
    return learnCameraCorrelation(cameras, samples, held_out, {}).coefficients(0, 1);
  }

  /// The correlation by its definition.
  double correlation() const {
    double means[2] = {0, 0};
    const auto count = static_cast<double>(said[0].size());
    for (const int camera : {0, 1}) {
      for (const double x : said[camera]) means[camera] += x / count;
    }
    double ab = 0, aa = 0, bb = 0;
    for (std::size_t i = 0; i < said[0].size(); ++i) {
      const double a = said[0][i] - means[0], b = said[1][i] - means[1];
      ab += a * b, aa += a * a, bb += b * b;
    }
    return ab / std::sqrt(aa * bb);
  }

  std::vector<SampleOrigin> samples;
  HeldOutValues held_out;
  std::vector<double> said[2];
};

TEST(CameraCorrelation, IsThatOfTheLogOddsAtTheSameMoments) {
  for (const double offset : {0.0, 0.05, -0.05}) {
    const Moments moments(500, 0.6, offset);
    EXPECT_NEAR(moments.learned(), moments.correlation(), 1e-9) << offset;
    EXPECT_NEAR(moments.learned(), 0.6, 0.1);
  }
  EXPECT_NEAR(Moments(500, 0.0, 0).learned(), 0, 0.1);
  EXPECT_EQ(Moments(500, -0.6, 0).learned(), 0);
}

TEST(CameraCorrelation, IsNotKnownFromFewMomentsOrOneCamera) {
  EXPECT_EQ(Moments(20, 0.9, 0).learned(), kUnknownCorrelation);
  EXPECT_EQ(Moments(500, 0.9, 0.3).learned(), kUnknownCorrelation);  // no common moments
  const Moments moments(500, 0.9, 0);
  EXPECT_FALSE(learnCameraCorrelation({"/front"}, moments.samples, moments.held_out, {}).known());
  // As many topics as the runs of several robots have; the model must still be one that can be
  // saved.
  std::vector<std::string> many;
  for (std::size_t i = 0; i <= kMaxCameras; ++i) many.push_back("/camera" + std::to_string(i));
  EXPECT_FALSE(learnCameraCorrelation(many, moments.samples, moments.held_out, {}).known());
  const CameraCorrelation three =
      learnCameraCorrelation({"/rear", "/front", "/left"}, moments.samples, moments.held_out, {});
  EXPECT_EQ(three.cameras, (std::vector<std::string>{"/front", "/left", "/rear"}));
  EXPECT_EQ(three.coefficients(0, 1), three.coefficients(0, 2));  // the mean of those known
  EXPECT_EQ(three.coefficients, three.coefficients.transpose());
  EXPECT_EQ(three.coefficients.diagonal(), Eigen::Vector3d::Ones());
}

TEST(CameraCorrelation, IsFoundByNameElseTheMean) {
  CameraCorrelation learned;
  learned.cameras = {"/front", "/left", "/rear"};
  learned.coefficients = (Eigen::Matrix3d() << 1, 0.1, 0.2, 0.1, 1, 0.6, 0.2, 0.6, 1).finished();
  const Eigen::Matrix2d known = (Eigen::Matrix2d() << 1, 0.2, 0.2, 1).finished();
  const Eigen::Matrix2d mean = (Eigen::Matrix2d() << 1, 0.3, 0.3, 1).finished();
  EXPECT_EQ(coefficientsFor({"/rear", "/front"}, learned), known);
  EXPECT_TRUE(coefficientsFor({"/front", "/new"}, learned).isApprox(mean));
  EXPECT_EQ(coefficientsFor({"/a", "/b"}, {})(0, 1), kUnknownCorrelation);
  EXPECT_EQ(coefficientsFor({"/a"}, {}), Eigen::MatrixXd::Ones(1, 1));
}

/// Front and rear: each moment shows the same room twice.
std::vector<Frame> framesOfTwoCameras() {
  std::vector<Frame> frames;
  for (Frame& frame : drawFrames(3, 40)) {
    frame.camera = static_cast<int>(frames.size() % 2);
    frames.push_back(frame);
    frames.back().stamp = std::floor(frame.stamp / 2);
  }
  return frames;
}

TEST(TrainingOnCameras, LearnsTheirCorrelationWhichTheFileKeeps) {
  const std::vector<std::string> topics{"/rear", "/front"};
  const RecordingOpener recording = opener(framesOfTwoCameras(), "robot.bag", topics);
  const Model model = train({recording}, quickOptions()).model;
  EXPECT_EQ(model.cameras.cameras, (std::vector<std::string>{"/front", "/rear"}));
  EXPECT_GE(model.cameras.coefficients.minCoeff(), 0);
  EXPECT_LE(model.cameras.coefficients.maxCoeff(), 1);
  const Model read = parseModel(serializeModel(model), "test");
  EXPECT_EQ(read.cameras.cameras, model.cameras.cameras);
  EXPECT_EQ(read.cameras.coefficients, model.cameras.coefficients);

  const Model more = trainIncrementally(model, {opener(drawFrames(3, 10, 500))}, {0}).model;
  EXPECT_EQ(more.cameras.coefficients, model.cameras.coefficients);
  EXPECT_FALSE(train({opener(drawFrames(3, 20))}, quickOptions()).model.cameras.known());
}

TEST(TrainingOnCameras, ThinsEachOutByItself) {
  TrainingOptions options = quickOptions();
  options.sampling.rate = 0.5;
  const Training training =
      train({opener(framesOfTwoCameras(), "robot.bag", {"/front", "/rear"})}, options);
  EXPECT_NEAR(static_cast<double>(training.images), 60, 3);
}

}  // namespace
}  // namespace place_recognition
