#include "simulation/patterns.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace place_recognition::simulation {
namespace {

const cv::Size kSize{512, 512};

/// `base` times (1 + amount * (field - 1/2) * 2), the same for the three channels.
cv::Mat shaded(const cv::Scalar& base, const cv::Mat& field, double amount) {
  cv::Mat channels[3], picture;
  for (int c = 0; c < 3; ++c) {
    field.convertTo(channels[c], CV_8U, 2.0 * amount * base[c], base[c] * (1.0 - amount));
  }
  cv::merge(channels, 3, picture);
  return picture;
}

cv::Mat mixed(const cv::Mat& a, double weight, const cv::Mat& b) {
  cv::Mat result;
  cv::addWeighted(a, 1.0 - weight, b, weight, 0.0, result);
  return result;
}

/// Wavering lines along x, like the grain of wood.
cv::Mat grain(Random& random, cv::Size size) {
  const cv::Mat fine = noise(random, size, {4, 96});
  const cv::Mat wide = noise(random, size, {2, 12});
  const cv::Mat pores = noise(random, size, {24, 240});
  return 0.35 * fine + 0.45 * wide + 0.2 * pores;
}

cv::Scalar varied(Random& random, const cv::Scalar& base, float amount) {
  const double brightness = 1.0 + random.uniform(-amount, amount);
  const double warmth = random.uniform(-amount, amount) * 0.3;
  return {base[0] * (brightness - warmth), base[1] * brightness, base[2] * (brightness + warmth)};
}

}  // namespace

cv::Mat noise(Random& random, cv::Size size, cv::Size cells) {
  cells.width = std::min(cells.width, size.width);
  cells.height = std::min(cells.height, size.height);
  cv::Mat grid(cells, CV_32F), wrapped, large;
  for (int y = 0; y < grid.rows; ++y) {
    for (int x = 0; x < grid.cols; ++x) grid.at<float>(y, x) = random.uniform();
  }
  cv::copyMakeBorder(grid, wrapped, 2, 2, 2, 2, cv::BORDER_WRAP);
  const double scale_x = static_cast<double>(size.width) / cells.width;
  const double scale_y = static_cast<double>(size.height) / cells.height;
  const cv::Size with_border(cvRound(wrapped.cols * scale_x), cvRound(wrapped.rows * scale_y));
  cv::resize(wrapped, large, with_border, 0, 0, cv::INTER_CUBIC);
  return large(cv::Rect(cvRound(2 * scale_x), cvRound(2 * scale_y), size.width, size.height))
      .clone();
}

cv::Mat plaster(Random& random, const cv::Scalar& base) {
  const cv::Mat field = 0.4 * noise(random, kSize, {4, 4}) + 0.3 * noise(random, kSize, {40, 40}) +
                        0.3 * noise(random, kSize, {200, 200});
  return shaded(base, field, 0.05);
}

cv::Mat wood(Random& random, const cv::Scalar& base) {
  return shaded(base, grain(random, kSize), 0.28);
}

cv::Mat planks(Random& random, const cv::Scalar& base, int rows) {
  cv::Mat picture(kSize, CV_8UC3);
  for (int row = 0; row < rows; ++row) {
    const int top = row * kSize.height / rows;
    const int bottom = (row + 1) * kSize.height / rows;
    const int cut = random.integer(kSize.width);
    const cv::Mat field = grain(random, {kSize.width, bottom - top});
    cv::Mat strip = picture.rowRange(top, bottom);
    shaded(varied(random, base, 0.16f), field, 0.2).copyTo(strip);
    const cv::Mat other = shaded(varied(random, base, 0.16f), field, 0.2);
    other.colRange(0, cut).copyTo(strip.colRange(0, cut));
    const cv::Scalar gap = base * 0.45;
    cv::line(strip, {cut, 0}, {cut, strip.rows}, gap, 1);
    cv::line(strip, {0, 0}, {strip.cols, 0}, gap, 1);
  }
  return picture;
}

cv::Mat carpet(Random& random, const cv::Scalar& base) {
  const cv::Mat field = 0.25 * noise(random, kSize, {6, 6}) +
                        0.35 * noise(random, kSize, {128, 128}) +
                        0.4 * noise(random, kSize, {400, 400});
  return shaded(base, field, 0.4);
}

cv::Mat linoleum(Random& random, const cv::Scalar& base) {
  const cv::Mat field = 0.3 * noise(random, kSize, {8, 8}) + 0.4 * noise(random, kSize, {60, 40}) +
                        0.3 * noise(random, kSize, {250, 250});
  cv::Mat picture = shaded(base, field, 0.16);
  for (int i = 0; i < 900; ++i) {
    const cv::Point at(random.integer(kSize.width), random.integer(kSize.height));
    cv::circle(picture, at, 1, varied(random, base * (random.chance(0.5f) ? 0.75 : 1.12), 0.1f),
               cv::FILLED);
  }
  return picture;
}

cv::Mat tiles(Random& random, const cv::Scalar& base, const cv::Scalar& joint, int count) {
  cv::Mat picture(kSize, CV_8UC3, joint);
  const int side = kSize.width / count;
  const int gap = std::max(1, side / 48);
  const cv::Mat field = 0.6 * noise(random, kSize, {16, 16}) + 0.4 * noise(random, kSize, {90, 90});
  for (int y = 0; y < count; ++y) {
    for (int x = 0; x < count; ++x) {
      const cv::Rect tile(x * side + gap, y * side + gap, side - gap, side - gap);
      shaded(varied(random, base, 0.06f), field(tile), 0.08).copyTo(picture(tile));
    }
  }
  return picture;
}

cv::Mat ceilingPanel(Random& random) {
  cv::Mat picture = plaster(random, rgb(222, 222, 217));
  for (int i = 0; i < 1500; ++i) {
    const cv::Point at(random.integer(kSize.width), random.integer(kSize.height));
    cv::ellipse(picture, at, {1 + random.integer(3), 1}, random.integer(180), 0, 360,
                rgb(188, 188, 184), cv::FILLED);
  }
  cv::rectangle(picture, {0, 0}, {511, 511}, rgb(236, 236, 234), 16);
  cv::rectangle(picture, {9, 9}, {502, 502}, rgb(165, 165, 163), 2);
  return picture;
}

cv::Mat fabric(Random& random, const cv::Scalar& base, const cv::Scalar& stripe) {
  cv::Mat weave(kSize, CV_32F);
  for (int y = 0; y < weave.rows; ++y) {
    for (int x = 0; x < weave.cols; ++x) {
      const bool over = ((x / 4) + (y / 4)) % 2 == 0;
      weave.at<float>(y, x) = over ? 0.7f : 0.3f;
    }
  }
  const cv::Mat field =
      0.5 * weave + 0.3 * noise(random, kSize, {128, 128}) + 0.2 * noise(random, kSize, {6, 6});
  cv::Mat picture = shaded(base, field, 0.3);
  const cv::Mat striped = shaded(stripe, field, 0.3);
  for (int x = 0; x < kSize.width; x += 128) {
    striped.colRange(x, x + 20).copyTo(picture.colRange(x, x + 20));
  }
  return picture;
}

cv::Mat curtain(Random& random, const cv::Scalar& base) {
  const cv::Mat waver = noise(random, kSize, {3, 2});
  cv::Mat folds(kSize, CV_32F);
  for (int y = 0; y < folds.rows; ++y) {
    for (int x = 0; x < folds.cols; ++x) {
      const float phase = 6.2831853f * static_cast<float>(x) / 64.0f + 3.0f * waver.at<float>(y, x);
      folds.at<float>(y, x) = 0.5f + 0.35f * std::sin(phase) + 0.15f * std::sin(2.3f * phase);
    }
  }
  return mixed(shaded(base, folds, 0.35), 0.3, shaded(base, noise(random, kSize, {256, 256}), 0.2));
}

cv::Mat plastic(Random& random, const cv::Scalar& base) {
  return shaded(base, noise(random, kSize, {180, 180}), 0.02);
}

cv::Mat leaf(Random& random) {
  cv::Mat picture = shaded(rgb(58, 104, 44), grain(random, kSize), 0.4);
  cv::line(picture, {0, 256}, {511, 256}, rgb(120, 150, 90), 14);
  return picture;
}

}  // namespace place_recognition::simulation
