#include "features/crfh_responses.h"

#include <algorithm>

#include "features/channel_rows.h"

namespace place_recognition {

CrfhResponses::CrfhResponses(const CrfhOptions& options)
    : method_(options.derivatives == "gaussian" ? DerivativeMethod::kGaussian
                                                : DerivativeMethod::kCentralDifference),
      half_width_(options.half_width) {}

CrfhResponses::Response CrfhResponses::request(const CrfhDescriptor& descriptor, double t) {
  const std::size_t filter = filterOf(descriptor.channel, t);
  filters_[filter].responses.request(descriptor.op);
  return {filter, descriptor.op};
}

std::size_t CrfhResponses::planeOf(Channel channel) {
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    if (planes_[i].channel == channel) return i;
  }
  planes_.push_back({channel, {}});
  return planes_.size() - 1;
}

std::size_t CrfhResponses::filterOf(Channel channel, double t) {
  const std::size_t plane = planeOf(channel);
  for (std::size_t i = 0; i < filters_.size(); ++i) {
    if (filters_[i].plane == plane && filters_[i].t == t) return i;
  }
  filters_.push_back({plane, t, ResponseFilter(t, half_width_, method_)});
  margin_ = std::max(margin_, filters_.back().responses.margin());
  return filters_.size() - 1;
}

void CrfhResponses::start(cv::Size size) {
  for (Plane& plane : planes_) plane.pixels.create(size);
  next_row_ = 0;
}

void CrfhResponses::computeRow(const cv::Mat& image, int y, int left, int columns) {
  // Just before they are needed, so that they are still in the processor's cache then.
  for (; next_row_ <= y + margin_; ++next_row_) {
    for (Plane& plane : planes_) {
      extractChannelRow(image, plane.channel, next_row_, plane.pixels[next_row_]);
    }
  }
  for (Filter& filter : filters_) {
    filter.responses.computeRow(planes_[filter.plane].pixels, y, left, columns);
  }
}

}  // namespace place_recognition
