#include "features/crfh_responses.h"

#include <algorithm>
#include <cassert>

#include "features/channel_rows.h"

namespace place_recognition {

CrfhResponses::CrfhResponses(const CrfhOptions& options)
    : method_(options.derivatives == "gaussian" ? DerivativeMethod::kGaussian
                                                : DerivativeMethod::kCentralDifference),
      half_width_(options.half_width) {}

CrfhResponses::Response CrfhResponses::request(const CrfhDescriptor& descriptor, double t) {
  const std::size_t plane = planeOf(descriptor.channel);
  const std::size_t filter = filterOf(planes_[plane], t);
  planes_[plane].filters[filter].responses.request(descriptor.op);
  return {plane, filter, descriptor.op};
}

std::size_t CrfhResponses::planeOf(Channel channel) {
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    if (planes_[i].channel == channel) return i;
  }
  planes_.push_back({channel, {}, {}});
  return planes_.size() - 1;
}

std::size_t CrfhResponses::filterOf(Plane& plane, double t) {
  for (std::size_t i = 0; i < plane.filters.size(); ++i) {
    if (plane.filters[i].t == t) return i;
  }
  plane.filters.push_back({t, ResponseFilter(t, half_width_, method_)});
  margin_ = std::max(margin_, plane.filters.back().responses.margin());
  return plane.filters.size() - 1;
}

void CrfhResponses::start(cv::Size size, int border) {
  assert(border >= margin_ && 2 * border < std::min(size.width, size.height));
  border_ = border;
  next_row_ = border;
  next_taken_ = border - margin_;
  lanes_ = StripedRows(size.width - 2 * (border - margin_));
  row_.assign(lanes_.size(), 0);
  for (Plane& plane : planes_) {
    plane.rows.start(2 * margin_ + ResponseFilter::kRows, lanes_.size());
  }
}

int CrfhResponses::computeRows(const cv::Mat& image) {
  const int count = std::min(ResponseFilter::kRows, image.rows - border_ - next_row_);
  if (count == 0) return 0;
  next_row_ += count;
  // Extracted just before use, so that the rows are still in the processor's cache.
  while (next_taken_ < next_row_ + margin_) takeRow(image, next_taken_++);
  for (Plane& plane : planes_) {
    for (Filter& filter : plane.filters) {
      filter.responses.computeRows(plane.rows, count, margin_, lanes_);
    }
  }
  return count;
}

void CrfhResponses::takeRow(const cv::Mat& image, int y) {
  const int left = border_ - margin_;
  for (Plane& plane : planes_) {
    extractChannelRow(image, plane.channel, y, left, image.cols - 2 * left, row_.data());
    lanes_.lay(row_.data(), plane.rows.next());
    plane.rows.push();
  }
}

}  // namespace place_recognition
