#pragma once

#include <cstddef>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "features/crfh_descriptor.h"
#include "features/response_filter.h"
#include "place_recognition/feature_options.h"

namespace place_recognition {

/// Responses of CRFH descriptors, not normalised by scale, a row of a picture after the other. A
/// channel is taken from the picture once, and what is asked of one channel at one scale shares a
/// filter. Keeps its buffers: one a thread.
class CrfhResponses {
 public:
  /// The responses of one descriptor at one scale.
  struct Response {
    std::size_t filter;
    Operator op;

    bool operator==(const Response& other) const {
      return filter == other.filter && op == other.op;
    }
  };

  /// Takes `derivatives` and `half_width` from the options.
  explicit CrfhResponses(const CrfhOptions& options);

  /// Has computeRow() compute these responses.
  Response request(const CrfhDescriptor& descriptor, double t);
  /// Pixels at each side of the picture where there are no responses.
  int margin() const { return margin_; }

  /// Begins a picture.
  void start(cv::Size size);
  /// Row y of that picture (CV_8UC3 BGR or CV_8UC1) in columns left..left + columns - 1, all of
  /// them margin() or farther from the edges. Rows must come from the top down.
  void computeRow(const cv::Mat& image, int y, int left, int columns);
  /// Requested responses in that row, column `left` first.
  const float* row(const Response& response) const {
    return filters_[response.filter].responses.row(response.op);
  }

 private:
  struct Plane {
    Channel channel;
    cv::Mat_<float> pixels;
  };
  /// All operators that are asked of one channel at one scale.
  struct Filter {
    std::size_t plane;
    double t;
    ResponseFilter responses;
  };

  std::size_t planeOf(Channel channel);
  std::size_t filterOf(Channel channel, double t);

  DerivativeMethod method_;
  double half_width_;
  int margin_ = 0;
  std::vector<Plane> planes_;
  std::vector<Filter> filters_;
  int next_row_ = 0;  ///< of the picture, to be taken into the planes
};

}  // namespace place_recognition
