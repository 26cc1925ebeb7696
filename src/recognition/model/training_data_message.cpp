#include <Eigen/Eigenvalues>
#include <cmath>
#include <cstdint>

#include "base/place_name.h"
#include "base/require.h"
#include "recognition/model/message_parts.h"

namespace place_recognition {
namespace {

/// Symmetric, positive semidefinite up to rounding, and no larger than colours can vary.
bool isSoundCovariance(const Eigen::Matrix3d& covariance) {
  constexpr double kRounding = 1e-9;
  constexpr double kLargest = 100;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance, Eigen::EigenvaluesOnly);
  return solver.eigenvalues().minCoeff() >= -kRounding &&
         solver.eigenvalues().maxCoeff() <= kLargest;
}

void writeHeldOut(const HeldOutFrames& frames, proto::Model& message) {
  for (std::size_t i = 0; i < frames.places.size(); ++i) {
    message.add_held_out_frames(static_cast<std::uint32_t>(frames.places[i]));
    message.add_held_out_frames(static_cast<std::uint32_t>(frames.folds[i]));
    const auto row = static_cast<Eigen::Index>(i);
    for (std::size_t c = 0; c < frames.decision_values.size(); ++c) {
      message.add_held_out_values(frames.familiarity[c][row]);
      for (Eigen::Index k = 0; k < frames.decision_values[c].cols(); ++k) {
        message.add_held_out_values(frames.decision_values[c](row, k));
      }
    }
  }
}

void readHeldOut(const proto::Model& message, Model& model) {
  const auto places = static_cast<Eigen::Index>(model.places.size());
  const std::size_t cues = model.options.cues.size();
  const auto size = static_cast<std::size_t>(message.held_out_frames_size());
  const std::size_t count = size / 2;
  require(size % 2 == 0 && count <= kMaxHeldOutFrames,
          "the number of its held-out frames is invalid");
  require(static_cast<std::size_t>(message.held_out_values_size()) ==
              count * cues * (model.places.size() + 1),
          "it does not have one decision value per place and held-out frame");
  HeldOutFrames& frames = model.held_out;
  frames.decision_values.assign(cues, Eigen::MatrixXf(static_cast<Eigen::Index>(count), places));
  frames.familiarity.assign(cues, Eigen::VectorXf(static_cast<Eigen::Index>(count)));
  int next = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t place = message.held_out_frames(static_cast<int>(2 * i));
    const std::uint32_t fold = message.held_out_frames(static_cast<int>(2 * i + 1));
    require(place < model.places.size() && fold < ValidationOptions::kMaxFolds,
            "a held-out frame shows a place that does not exist");
    frames.places.push_back(static_cast<int>(place));
    frames.folds.push_back(static_cast<int>(fold));
    const auto row = static_cast<Eigen::Index>(i);
    for (std::size_t c = 0; c < cues; ++c) {
      frames.familiarity[c][row] = message.held_out_values(next++);
      require(!std::isinf(frames.familiarity[c][row]), "the familiarity of a frame is infinite");
      for (Eigen::Index k = 0; k < places; ++k) {
        frames.decision_values[c](row, k) = message.held_out_values(next++);
        require(std::isfinite(frames.decision_values[c](row, k)),
                "a held-out decision value is not finite");
      }
    }
  }
}

void writeAdjacency(const Adjacency& adjacency, proto::Model& message) {
  const int places = static_cast<int>(adjacency.places());
  for (int a = 0; a < places; ++a) {
    for (int b = a + 1; b < places; ++b) {
      if (!adjacency.joined(a, b)) continue;
      message.add_adjacency(static_cast<std::uint32_t>(a));
      message.add_adjacency(static_cast<std::uint32_t>(b));
    }
  }
}

void readAdjacency(const proto::Model& message, Model& model) {
  const std::uint64_t places = model.places.size();
  model.adjacency = Adjacency(places);
  require(message.adjacency_size() % 2 == 0, "the map of adjoining rooms has half a pair");
  std::uint64_t before = 0;  // no pair has 0 as its second place
  for (int i = 0; i < message.adjacency_size(); i += 2) {
    const std::uint64_t a = message.adjacency(i);
    const std::uint64_t b = message.adjacency(i + 1);
    require(a < b && b < places, "the map of adjoining rooms names a place that does not exist");
    require(a * places + b > before, "the map of adjoining rooms is not in order");
    before = a * places + b;
    model.adjacency.join(static_cast<int>(a), static_cast<int>(b));
  }
}

void writeColours(const ColourStatistics& colours, proto::Model& message) {
  for (Eigen::Index k = 0; k < colours.means.rows(); ++k) {
    for (int c = 0; c < 3; ++c) message.add_colour_means(colours.means(k, c));
  }
  if (!colours.known()) return;
  for (int c = 0; c < 3; ++c) {
    for (int d = c; d < 3; ++d) message.add_colour_covariance(colours.covariance(c, d));
  }
}

void readColours(const proto::Model& message, Model& model) {
  if (message.colour_means_size() == 0) return;
  const auto places = static_cast<Eigen::Index>(model.places.size());
  require(message.colour_means_size() == 3 * places && message.colour_covariance_size() == 6,
          "its colour statistics are incomplete");
  requireFinite(message.colour_means(), "a colour is not finite");
  requireFinite(message.colour_covariance(), "a variance of colours is not finite");
  ColourStatistics& colours = model.colours;
  colours.means.resize(places, 3);
  for (Eigen::Index k = 0; k < places; ++k) {
    for (int c = 0; c < 3; ++c) {
      colours.means(k, c) = message.colour_means(static_cast<int>(3 * k + c));
    }
  }
  int next = 0;
  for (int c = 0; c < 3; ++c) {
    for (int d = c; d < 3; ++d) {
      colours.covariance(c, d) = colours.covariance(d, c) = message.colour_covariance(next++);
    }
  }
  require(isSoundCovariance(colours.covariance), "its colour statistics are inconsistent");
}

void writeCameras(const CameraCorrelation& cameras, proto::Model& message) {
  if (!cameras.known()) return;
  message.set_cameras(joined(cameras.cameras));
  const auto count = static_cast<Eigen::Index>(cameras.cameras.size());
  for (Eigen::Index a = 0; a < count; ++a) {
    for (Eigen::Index b = a + 1; b < count; ++b) {
      message.add_camera_correlations(cameras.coefficients(a, b));
    }
  }
}

void readCameras(const proto::Model& message, Model& model) {
  CameraCorrelation& cameras = model.cameras;
  cameras.cameras = separated(message.cameras(), kMaxCameras);
  const auto count = static_cast<Eigen::Index>(cameras.cameras.size());
  require(message.camera_correlations_size() == count * (count - 1) / 2,
          "it does not have one correlation per pair of cameras");
  cameras.coefficients.setIdentity(count, count);
  int next = 0;
  for (Eigen::Index a = 0; a < count; ++a) {
    require(isUtf8(cameras.cameras[static_cast<std::size_t>(a)]),
            "the topic of a camera is not UTF-8 text");
    for (Eigen::Index b = a + 1; b < count; ++b) {
      const double correlation = message.camera_correlations(next++);
      require(isFraction(correlation), "the correlation of two cameras is not in 0..1");
      cameras.coefficients(a, b) = cameras.coefficients(b, a) = correlation;
    }
  }
}

void writeImages(const ImageProfile& images, proto::Model& message) {
  if (!images.known()) return;
  proto::ImageProfile& profile = *message.mutable_images();
  profile.set_width(static_cast<std::uint32_t>(images.width));
  profile.set_height(static_cast<std::uint32_t>(images.height));
  profile.set_colour(images.colour);
  profile.set_darkest(images.darkest);
  profile.set_brightest(images.brightest);
  profile.set_depth_low(images.levels.low);
  profile.set_depth_high(images.levels.high);
}

void readImages(const proto::Model& message, Model& model) {
  if (!message.has_images()) return;
  constexpr std::uint32_t kMaxSide = 1u << 16;
  const proto::ImageProfile& profile = message.images();
  const auto isSide = [](std::uint32_t side) { return side >= 1 && side <= kMaxSide; };
  require(isSide(profile.width()) && isSide(profile.height()),
          "the size of its training images is not in 1..65536");
  require(profile.darkest() >= 0 && profile.darkest() <= profile.brightest() &&
              profile.brightest() <= 255,
          "the brightness of its training images is not in 0..255");
  require(profile.depth_low() <= profile.depth_high() && profile.depth_high() < 1u << 16,
          "the range of levels of its training images is not in 0..65535");
  model.images = {static_cast<int>(profile.width()),
                  static_cast<int>(profile.height()),
                  profile.colour(),
                  profile.darkest(),
                  profile.brightest(),
                  {profile.depth_low(), profile.depth_high()}};
}

}  // namespace

void writeTrainingData(const Model& model, proto::Model& message) {
  writeColours(model.colours, message);
  writeHeldOut(model.held_out, message);
  writeAdjacency(model.adjacency, message);
  writeImages(model.images, message);
  writeCameras(model.cameras, message);
}

void readTrainingData(const proto::Model& message, Model& model) {
  readColours(message, model);
  readHeldOut(message, model);
  readAdjacency(message, model);
  readImages(message, model);
  readCameras(message, model);
}

}  // namespace place_recognition
