#include "recognition/training/camera_correlation_training.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>

namespace place_recognition {
namespace {

/// Frames at most this far apart, s, show the same moment.
constexpr double kSameMoment = 0.1;
/// Minimum number of moments that determine a pair of cameras.
constexpr std::size_t kLeastMoments = 30;
/// Clamps the log odds, because larger ones say no more about an error and would let single frames
/// decide.
constexpr double kLargestLogOdds = 4;

/// The answer of one camera at one moment.
struct CameraAnswer {
  int recording;
  double stamp;
  double log_odds;  // of the true place
};

/// In order of run and time.
using CameraAnswers = std::vector<CameraAnswer>;

std::vector<CameraAnswers> answersOf(std::size_t cameras, const std::vector<SampleOrigin>& samples,
                                     const HeldOutValues& held_out,
                                     const Calibration& calibration) {
  std::vector<CameraAnswers> answers(cameras);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!held_out.valid[i]) continue;
    const SampleOrigin& sample = samples[i];
    const Eigen::RowVectorXd decision_values =
        held_out.decision_values.row(static_cast<Eigen::Index>(i));
    const double p = calibration.probabilities(decision_values)[sample.place];
    const double log_odds =
        std::clamp(std::log(p) - std::log1p(-p), -kLargestLogOdds, kLargestLogOdds);
    answers[static_cast<std::size_t>(sample.camera)].push_back(
        {sample.recording, sample.stamp, std::isnan(log_odds) ? kLargestLogOdds : log_odds});
  }
  for (CameraAnswers& of_camera : answers) {
    std::stable_sort(of_camera.begin(), of_camera.end(),
                     [](const CameraAnswer& a, const CameraAnswer& b) {
                       return std::tie(a.recording, a.stamp) < std::tie(b.recording, b.stamp);
                     });
  }
  return answers;
}

/// The log odds of `a` and `b` (columns) at the moments of `a` that `b` also saw (rows).
Eigen::MatrixX2d commonMoments(const CameraAnswers& a, const CameraAnswers& b) {
  Eigen::MatrixX2d moments(static_cast<Eigen::Index>(a.size()), 2);
  Eigen::Index count = 0;
  auto next = b.begin();
  for (const CameraAnswer& answer : a) {
    const auto isBefore = [&answer](const CameraAnswer& other) {
      return std::tuple(other.recording, other.stamp) <
             std::tuple(answer.recording, answer.stamp - kSameMoment);
    };
    while (next != b.end() && isBefore(*next)) ++next;
    if (next == b.end()) break;
    if (next->recording != answer.recording || next->stamp > answer.stamp + kSameMoment) continue;
    moments.row(count++) << answer.log_odds, next->log_odds;
  }
  return moments.topRows(count);
}

/// Pearson's coefficient, clamped to 0..1; nothing if there are too few moments.
std::optional<double> correlationOver(const Eigen::MatrixX2d& moments) {
  if (moments.rows() < static_cast<Eigen::Index>(kLeastMoments)) return std::nullopt;
  const Eigen::MatrixX2d centered = moments.rowwise() - moments.colwise().mean();
  const Eigen::Matrix2d covariance = centered.transpose() * centered;
  const double scale = std::sqrt(covariance(0, 0) * covariance(1, 1));
  return scale > 0 ? std::clamp(covariance(0, 1) / scale, 0.0, 1.0) : 0.0;
}

}  // namespace

CameraCorrelation learnCameraCorrelation(const std::vector<std::string>& cameras,
                                         const std::vector<SampleOrigin>& samples,
                                         const HeldOutValues& held_out,
                                         const Calibration& calibration) {
  if (cameras.size() < 2 || cameras.size() > kMaxCameras) return {};
  const std::vector<CameraAnswers> answers =
      answersOf(cameras.size(), samples, held_out, calibration);
  std::vector<std::size_t> order(cameras.size());  // ascending by topic
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return cameras[a] < cameras[b]; });

  CameraCorrelation learned;
  std::vector<double> found;
  const auto count = static_cast<Eigen::Index>(cameras.size());
  learned.coefficients.setConstant(count, count, -1);
  for (Eigen::Index a = 0; a < count; ++a) {
    learned.cameras.push_back(cameras[order[static_cast<std::size_t>(a)]]);
    learned.coefficients(a, a) = 1;
    for (Eigen::Index b = 0; b < a; ++b) {
      const std::optional<double> correlation =
          correlationOver(commonMoments(answers[order[static_cast<std::size_t>(a)]],
                                        answers[order[static_cast<std::size_t>(b)]]));
      if (!correlation) continue;
      learned.coefficients(a, b) = learned.coefficients(b, a) = *correlation;
      found.push_back(*correlation);
    }
  }
  const double mean = found.empty() ? kUnknownCorrelation
                                    : std::accumulate(found.begin(), found.end(), 0.0) /
                                          static_cast<double>(found.size());
  learned.coefficients = (learned.coefficients.array() < 0).select(mean, learned.coefficients);
  return learned;
}

}  // namespace place_recognition
