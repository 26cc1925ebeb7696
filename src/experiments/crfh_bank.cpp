#include "experiments/crfh_bank.h"

#include <algorithm>

#include "features/channel_rows.h"
#include "features/crfh_quantizer.h"

namespace place_recognition {

CrfhBank::CrfhBank(const std::vector<CrfhOptions>& histograms) {
  for (const CrfhOptions& options : histograms) {
    options.check();
    std::vector<Dimension>& dimensions = histograms_.emplace_back();
    std::uint64_t weight = 1;
    for (const double t : options.variances()) {
      for (std::size_t i = 0; i < options.descriptors.size(); ++i) {
        const int bins = options.bins[options.bins.size() > 1 ? i : 0];
        dimensions.push_back(
            {digitsOf(parseDescriptor(options.descriptors[i]), t, bins, options), weight});
        weight *= static_cast<std::uint64_t>(bins);
      }
    }
    border_ = std::max(border_, options.border);
  }
  for (const Filter& filter : filters_) border_ = std::max(border_, filter.responses.margin());
}

std::size_t CrfhBank::planeOf(Channel channel) {
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    if (planes_[i].channel == channel) return i;
  }
  planes_.push_back({channel, {}});
  return planes_.size() - 1;
}

std::size_t CrfhBank::filterOf(Channel channel, double t, const CrfhOptions& options) {
  const std::size_t plane = planeOf(channel);
  for (std::size_t i = 0; i < filters_.size(); ++i) {
    if (filters_[i].plane == plane && filters_[i].t == t) return i;
  }
  const auto method = options.derivatives == "gaussian" ? DerivativeMethod::kGaussian
                                                        : DerivativeMethod::kCentralDifference;
  filters_.push_back({plane, t, ResponseFilter(t, options.half_width, method)});
  return filters_.size() - 1;
}

std::size_t CrfhBank::digitsOf(const CrfhDescriptor& descriptor, double t, int bins,
                               const CrfhOptions& options) {
  const std::size_t filter = filterOf(descriptor.channel, t, options);
  for (std::size_t i = 0; i < digits_.size(); ++i) {
    const Digits& digits = digits_[i];
    if (digits.filter == filter && digits.op == descriptor.op && digits.bins == bins) return i;
  }
  filters_[filter].responses.request(descriptor.op);
  digits_.push_back({filter,
                     descriptor.op,
                     bins,
                     crfhQuantizer(descriptor, t, options.derivative_range, bins, 1),
                     {}});
  return digits_.size() - 1;
}

std::vector<Feature> CrfhBank::extract(const cv::Mat& image) {
  std::vector<Feature> features(histograms_.size());
  const int columns = image.cols - 2 * border_;
  const int rows = image.rows - 2 * border_;
  if (columns <= 0 || rows <= 0) return features;
  quantise(image, columns, rows);
  const std::size_t pixels = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  for (std::size_t h = 0; h < features.size(); ++h) count(histograms_[h], pixels, features[h]);
  return features;
}

void CrfhBank::quantise(const cv::Mat& image, int columns, int rows) {
  for (Plane& plane : planes_) {
    plane.pixels.create(image.size());
    for (int y = 0; y < image.rows; ++y) {
      extractChannelRow(image, plane.channel, y, plane.pixels[y]);
    }
  }
  const std::size_t pixels = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  for (Digits& digits : digits_) digits.pixels.resize(pixels);
  for (int y = 0; y < rows; ++y) {
    for (Filter& filter : filters_) {
      filter.responses.computeRow(planes_[filter.plane].pixels, border_ + y, border_, columns);
    }
    const std::size_t begin = static_cast<std::size_t>(y) * static_cast<std::size_t>(columns);
    for (Digits& digits : digits_) {
      quantize(filters_[digits.filter].responses.row(digits.op), digits.quantizer, false, columns,
               digits.pixels.data() + begin);
    }
  }
}

void CrfhBank::count(const std::vector<Dimension>& histogram, std::size_t pixels,
                     Feature& feature) {
  constexpr std::size_t kBlock = 2048;  // stays in the processor's cache
  bins_.resize(kBlock);
  counter_.clear();
  for (std::size_t begin = 0; begin < pixels; begin += kBlock) {
    const std::size_t n = std::min(kBlock, pixels - begin);
    bool add = false;
    for (const Dimension& dimension : histogram) {
      joinWord(digits_[dimension.digits].pixels.data() + begin, dimension.weight, add,
               static_cast<int>(n), bins_.data());
      add = true;
    }
    counter_.add(bins_.data(), n);
  }
  counter_.histogram(static_cast<double>(pixels), feature.emplace<SparseVector>());
}

}  // namespace place_recognition
