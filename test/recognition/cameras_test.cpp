// Several cameras on one robot: the correlation of their errors, and their combination over time.

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "place_recognition/camera_correlation.h"
#include "place_recognition/model_file.h"
#include "place_recognition/temporal_filter.h"
#include "place_recognition/training.h"
#include "recognition/drawn_recording.h"
#include "recognition/over_time/transition_model.h"
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

constexpr double kThreshold = 0.5;

Recognition seen(int place, double probability = 0.7) {
  Recognition frame;
  frame.probabilities.setConstant(3, (1 - probability) / 2);
  frame.probabilities[place] = frame.confidence = probability;
  frame.place = place;
  frame.evidence = 0.9;
  frame.known = true;
  return frame;
}

Model threeRooms() {
  Model model;
  model.places = {"hall", "kitchen", "lab"};
  model.provenance.place_images = {50, 50, 50};
  model.unknown_threshold = kThreshold;
  return model;
}

TemporalFilter filterOf(int cameras, double correlation) {
  static const Model model = threeRooms();
  Eigen::MatrixXd all = Eigen::MatrixXd::Constant(cameras, cameras, correlation);
  all.diagonal().setOnes();
  return {
      std::vector<const Model*>(static_cast<std::size_t>(cameras), &model), all, Adjacency(3), {}};
}

/// Returns the belief after frames (stamp, camera, place) within one second, by the equations.
struct Shown {
  double stamp;
  std::size_t camera;
  int place;
  double weight;
};

Eigen::RowVectorXd expected(const std::vector<Shown>& frames) {
  const TemporalFilterOptions options;
  TransitionModel chain(Adjacency(3), options.unknown_share, options.jump_share);
  Eigen::RowVectorXd belief = chain.prior();
  double now = frames.front().stamp;
  for (const Shown& frame : frames) {
    const double elapsed = std::max(0.0, frame.stamp - now);
    now += elapsed;
    if (elapsed > 0) chain.advance(elapsed / options.dwell_time, belief);
    const auto tempered = [](double ratio) { return 0.9 * ratio + 0.1; };
    for (int state = 0; state < 4; ++state) {
      const double room = tempered(3 * (state == frame.place ? 0.7 : 0.15)) / tempered(3 * 0.7);
      const double likelihood = state == 3 ? tempered(0.1 / 0.5) : tempered(0.9 / 0.5) * room;
      belief[state] *= std::pow(likelihood, frame.weight);
    }
    belief /= belief.sum();
  }
  return belief;
}

TEST(TemporalFilterOfCameras, CountsEachByItsOwnTimeAndWhatTheOthersDoNotSay) {
  // Decorrelation time 0.2 s; the second frame of a moment shares 0.25 of its evidence.
  const std::vector<Shown> frames{{10, 0, 0, 1},
                                  {10, 1, 1, 1 / 1.25},
                                  {10.1, 0, 0, 0.5 / 1.25},
                                  {10.13, 1, 0, 0.65 / 1.25},
                                  {10.4, 1, 2, 1 / 1.25},
                                  {10.4, 0, 0, 1 / 1.25}};
  TemporalFilter filter = filterOf(2, 0.25);
  FilteredAnswer last;
  for (const Shown& frame : frames) {
    last = filter.update(frame.stamp, seen(frame.place), std::nullopt, frame.camera);
  }
  EXPECT_TRUE(last.probabilities.isApprox(expected(frames), 1e-9)) << last.probabilities;
}

TEST(TemporalFilterOfCameras, CamerasThatAlwaysErrTogetherCountAsOne) {
  TemporalFilter one = filterOf(1, 1), three = filterOf(3, 1);
  // Weighted by their fractions, three frames per moment carry the evidence of one.
  const auto show = [&](double stamp) {
    one.update(stamp, seen(0));
    for (const std::size_t camera : {0, 1, 2}) three.update(stamp, seen(0), std::nullopt, camera);
  };
  for (int i = 0; i <= 10; ++i) show(0.1 * i);
  const double odds[2] = {one.answer().probabilities[0] / one.answer().probabilities[1],
                          three.answer().probabilities[0] / three.answer().probabilities[1]};
  EXPECT_NEAR(odds[1] / odds[0], 1, 0.05);
}

/// Returns the evidence of an update for the first room against the second, in log odds. `before`:
/// the belief before it; `changes`: the mean number of changes of room since.
double spoken(Eigen::RowVectorXd before, double changes, const Eigen::RowVectorXd& after) {
  const TemporalFilterOptions options;
  TransitionModel(Adjacency(3), options.unknown_share, options.jump_share).advance(changes, before);
  return std::log(after[0] / before[0]) - std::log(after[1] / before[1]);
}

TEST(TemporalFilterOfCameras, OneThatIsSilentOrSaysNothingStopsCounting) {
  const TemporalFilterOptions options;
  const auto lastWeight = [&](double silence, bool blind) {
    TemporalFilter filter = filterOf(2, 1);
    filter.update(0, seen(0));
    filter.update(0, seen(0), std::nullopt, 1);
    Recognition nothing = seen(0);
    nothing.place = -1;
    for (double t = 0.2; t < silence - 0.1; t += 0.2) {
      filter.update(t, nothing);
      if (blind) filter.update(t, nothing, std::nullopt, 1);
    }
    // Little evidence for the rooms, so that the odds can be distinguished.
    const Eigen::RowVectorXd before = filter.update(silence - 0.1, nothing).probabilities;
    return spoken(before, 0.1 / options.dwell_time, filter.update(silence, seen(0)).probabilities);
  };
  const double together = lastWeight(0.8, false);
  const double alone = lastWeight(0.8 + options.camera_gap, false);
  EXPECT_NEAR(alone / together, 2, 1e-6);
  EXPECT_NEAR(lastWeight(0.8 + options.camera_gap, true) / together, 2, 1e-6);
}

TEST(TemporalFilterOfCameras, AFrameThatComesAfterALaterOneOfAnotherCounts) {
  const std::vector<Shown> frames{{10, 0, 0, 1}, {9.9, 1, 1, 1 / 1.5}, {10.2, 0, 0, 1 / 1.5}};
  TemporalFilter filter = filterOf(2, 0.5);
  for (const Shown& frame : frames) {
    filter.update(frame.stamp, seen(frame.place), std::nullopt, frame.camera);
  }
  EXPECT_TRUE(filter.answer().probabilities.isApprox(expected(frames), 1e-9));
  // Before the last one of its own camera, or as far from all as after a pause: restarts.
  const Eigen::RowVectorXd anew = filterOf(2, 0.5).update(0, seen(1)).probabilities;
  EXPECT_EQ(filter.update(10.1, seen(1)).probabilities, anew);
  EXPECT_EQ(filter.update(-10, seen(1), std::nullopt, 1).probabilities, anew);
}

TEST(TemporalFilterOfCameras, MotionSinceTheLastFrameIsNewToAll) {
  TemporalFilter filter = filterOf(2, 0);
  filter.update(0, seen(0));
  filter.update(0, seen(0), std::nullopt, 1);
  double stamp = 0;
  const auto weightOf = [&](std::size_t camera, double metres) {
    const Eigen::RowVectorXd before = filter.answer().probabilities;
    filter.update(stamp += 0.1, seen(0), Motion{metres, 0}, camera);
    return spoken(before, metres / TemporalFilterOptions().dwell_distance,
                  filter.answer().probabilities);
  };
  const double full = weightOf(0, 1);
  EXPECT_NEAR(weightOf(1, 0), full, 1e-6);  // for the metre before the other camera's frame
  EXPECT_NEAR(weightOf(1, 0.05), full / 2, 1e-6);
  EXPECT_NEAR(weightOf(0, 0), full / 2, 1e-6);
}

TEST(TemporalFilterOfCameras, EachHasTheThresholdAndSharesOfItsModel) {
  Model other = threeRooms();
  other.provenance.place_images = {5, 50, 500};
  other.unknown_threshold = 0.8;
  const Model model = threeRooms();
  TemporalFilter both({&model, &other}, Eigen::Matrix2d::Identity(), Adjacency(3), {});
  TemporalFilter first(model, Adjacency(3), {}), second(other, Adjacency(3), {});
  // From equal beliefs in all rooms, the likelihoods can be derived.
  EXPECT_EQ(both.update(0, seen(0), std::nullopt, 0).probabilities,
            first.update(0, seen(0)).probabilities);
  both.reset();
  EXPECT_EQ(both.update(0, seen(1), std::nullopt, 1).probabilities,
            second.update(0, seen(1)).probabilities);
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
