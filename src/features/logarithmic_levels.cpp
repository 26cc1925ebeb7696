#include "features/logarithmic_levels.h"

#include <cmath>
#include <opencv2/core.hpp>

namespace place_recognition {
namespace {

cv::Mat makeTable() {
  constexpr double kOffset = 16;
  const double unit = 255 / std::log1p(255 / kOffset);
  cv::Mat table(1, 256, CV_8UC1);
  for (int v = 0; v < 256; ++v) {
    table.at<uchar>(v) = cv::saturate_cast<uchar>(unit * std::log1p(v / kOffset));
  }
  return table;
}

}  // namespace

void takeLogarithms(const cv::Mat& image, cv::Mat& levels) {
  static const cv::Mat table = makeTable();
  cv::LUT(image, table, levels);
}

}  // namespace place_recognition
