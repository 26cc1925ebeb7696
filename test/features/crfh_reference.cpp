#include "features/crfh_reference.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace place_recognition {
namespace {

double channelValue(const cv::Mat& image, const std::string& channel, int x, int y) {
  const bool grey = image.channels() == 1;
  const double b = grey ? image.at<std::uint8_t>(y, x) : image.at<cv::Vec3b>(y, x)[0];
  const double g = grey ? b : image.at<cv::Vec3b>(y, x)[1];
  const double r = grey ? b : image.at<cv::Vec3b>(y, x)[2];
  if (channel == "L") return (r + g + b) / 3;
  if (channel == "R") return r;
  if (channel == "G") return g;
  if (channel == "B") return b;
  if (channel == "C1") return (r - g) / 2;
  return (r + g) / 2 - b;
}

int halfWidth(double t, double sigmas) {
  return std::max(1, static_cast<int>(std::ceil(sigmas * std::sqrt(t))));
}

/// One channel of an image at one scale.
struct ScaleSpace {
  const cv::Mat& image;
  std::string channel;
  double t;
  int half;

  double smooth(int x, int y) const {
    double sum = 0, weights = 0;
    for (int j = -half; j <= half; ++j) {
      for (int i = -half; i <= half; ++i) {
        const double weight = std::exp(-(i * i + j * j) / (2 * t));
        sum += weight * channelValue(image, channel, x + i, y + j);
        weights += weight;
      }
    }
    return sum / weights;
  }

  double dx(int x, int y) const { return (smooth(x + 1, y) - smooth(x - 1, y)) / 2; }
  double dy(int x, int y) const { return (smooth(x, y + 1) - smooth(x, y - 1)) / 2; }
  double dxx(int x, int y) const { return smooth(x + 1, y) - 2 * smooth(x, y) + smooth(x - 1, y); }
  double dyy(int x, int y) const { return smooth(x, y + 1) - 2 * smooth(x, y) + smooth(x, y - 1); }
  double dxy(int x, int y) const { return (dy(x + 1, y) - dy(x - 1, y)) / 2; }
};

struct Response {
  double value, low, high;
};

Response respond(const cv::Mat& image, const std::string& descriptor, double t,
                 const CrfhOptions& options, int x, int y) {
  const double range = options.derivative_range;
  const std::size_t open = descriptor.find('(');
  const std::size_t suffix = std::min(descriptor.find_first_of("xy"), descriptor.size());
  const std::string channel = open == std::string::npos
                                  ? descriptor.substr(0, suffix)
                                  : descriptor.substr(open + 1, descriptor.size() - open - 2);
  const std::string op = descriptor.substr(0, open == std::string::npos ? 0 : open) +
                         (open == std::string::npos ? descriptor.substr(suffix) : "");
  const ScaleSpace l{image, channel, t, halfWidth(t, options.half_width)};

  if (op == "x") return {std::sqrt(t) * l.dx(x, y), -range, range};
  if (op == "y") return {std::sqrt(t) * l.dy(x, y), -range, range};
  if (op == "xx") return {t * l.dxx(x, y), -range, range};
  if (op == "xy") return {t * l.dxy(x, y), -range, range};
  if (op == "yy") return {t * l.dyy(x, y), -range, range};
  if (op == "grad") return {std::sqrt(t) * std::hypot(l.dx(x, y), l.dy(x, y)), 0, range};
  if (op == "lap") return {t * (l.dxx(x, y) + l.dyy(x, y)), -range, range};
  if (op == "det") {
    return {t * t * (l.dxx(x, y) * l.dyy(x, y) - std::pow(l.dxy(x, y), 2)), -range / 4, range / 4};
  }
  if (channel == "C1") return {l.smooth(x, y), -127.5, 127.5};
  if (channel == "C2") return {l.smooth(x, y), -255, 255};
  return {l.smooth(x, y), 0, 255};
}

}  // namespace

std::map<std::uint64_t, int> referenceCrfh(const cv::Mat& image, const CrfhOptions& options) {
  int border = options.border;
  for (double t : options.scales) border = std::max(border, halfWidth(t, options.half_width) + 1);

  std::map<std::uint64_t, int> histogram;
  for (int y = border; y < image.rows - border; ++y) {
    for (int x = border; x < image.cols - border; ++x) {
      std::uint64_t index = 0, weight = 1;
      for (double t : options.scales) {
        for (std::size_t i = 0; i < options.descriptors.size(); ++i) {
          const int bins = options.bins[options.bins.size() == 1 ? 0 : i];
          const auto [value, low, high] = respond(image, options.descriptors[i], t, options, x, y);
          // Rounding must not make a value negative that is exactly zero in theory.
          const double level = std::floor((value - low) * bins / (high - low) + 1e-9);
          index += weight * static_cast<std::uint64_t>(std::clamp(level, 0.0, bins - 1.0));
          weight *= bins;
        }
      }
      ++histogram[index];
    }
  }
  return histogram;
}

}  // namespace place_recognition
