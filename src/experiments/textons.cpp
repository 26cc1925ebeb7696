#include "experiments/textons.h"

#include <Eigen/Core>
#include <algorithm>
#include <cassert>
#include <cstdint>

namespace place_recognition {
namespace {

using RowMajor = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The best of several runs of k-means from k-means++ starting points.
cv::Mat1f clusterCentres(const cv::Mat1f& points) {
  constexpr int kRuns = 3;
  const int count = std::min(TextonDictionary::kPerMaterial, points.rows);
  const cv::TermCriteria stop(cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 100, 1e-4);
  cv::Mat labels, centres;
  cv::theRNG() = cv::RNG(1);
  cv::kmeans(points, count, labels, stop, kRuns, cv::KMEANS_PP_CENTERS, centres);
  return centres;
}

}  // namespace

cv::Mat1f sampledPixels(const Mr8FilterBank::Responses& responses, int count) {
  const auto all = static_cast<std::int64_t>(responses[0].total());
  const int rows = static_cast<int>(std::min<std::int64_t>(count, all));
  cv::Mat1f pixels(rows, Mr8FilterBank::kResponses);
  for (int i = 0; i < rows; ++i) {
    const auto pixel = static_cast<int>((2 * i + 1) * all / (2 * rows));
    const int y = pixel / responses[0].cols, x = pixel % responses[0].cols;
    for (int k = 0; k < pixels.cols; ++k) pixels(i, k) = responses[k](y, x);
  }
  return pixels;
}

TextonDictionary::TextonDictionary(const std::vector<cv::Mat1f>& materials) {
  for (const cv::Mat1f& pixels : materials) {
    assert(pixels.rows > 0 && pixels.cols == Mr8FilterBank::kResponses);
    textons_.push_back(clusterCentres(pixels));
  }
}

DenseVector TextonDictionary::histogram(const Mr8FilterBank::Responses& responses) const {
  const Eigen::Map<const RowMajor> textons(textons_[0], textons_.rows, textons_.cols);
  const Eigen::VectorXf half_squares = 0.5f * textons.rowwise().squaredNorm();
  const cv::Size size = responses[0].size();
  RowMajor pixels(Mr8FilterBank::kResponses, size.width);  // of one row of the image
  Eigen::MatrixXf nearness(textons.rows(), size.width);
  std::vector<std::int64_t> counts(static_cast<std::size_t>(textons.rows()), 0);
  for (int y = 0; y < size.height; ++y) {
    for (int k = 0; k < Mr8FilterBank::kResponses; ++k) {
      std::copy_n(responses[k][y], size.width, &pixels(k, 0));
    }
    // Half the squared distance, without the term common to all textons.
    nearness.noalias() = textons * pixels;
    nearness.colwise() -= half_squares;
    for (Eigen::Index x = 0; x < nearness.cols(); ++x) {
      Eigen::Index nearest = 0;
      nearness.col(x).maxCoeff(&nearest);
      ++counts[static_cast<std::size_t>(nearest)];
    }
  }
  DenseVector histogram;
  for (const std::int64_t count : counts) {
    histogram.values.push_back(
        static_cast<float>(100.0 * static_cast<double>(count) / size.area()));
  }
  return histogram;
}

}  // namespace place_recognition
