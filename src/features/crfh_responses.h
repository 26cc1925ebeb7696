#pragma once

#include <cstddef>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "features/crfh_descriptor.h"
#include "features/response_filter.h"
#include "features/row_ring.h"
#include "features/striped_rows.h"
#include "place_recognition/feature_options.h"

namespace place_recognition {

/// Responses of CRFH descriptors, not normalized by scale, a few rows of an image at a time. Each
/// channel is extracted from the image once, and all responses of one channel at one scale share a
/// filter. Keeps its buffers: use one per thread.
class CrfhResponses {
 public:
  /// The responses of one descriptor at one scale.
  struct Response {
    std::size_t plane, filter;
    Operator op;

    bool operator==(const Response& other) const {
      return plane == other.plane && filter == other.filter && op == other.op;
    }
  };

  /// Takes `derivatives` and `half_width` from the options.
  explicit CrfhResponses(const CrfhOptions& options);

  /// Makes computeRows() compute these responses.
  Response request(const CrfhDescriptor& descriptor, double t);
  /// Pixels at each side of the image where there are no responses.
  int margin() const { return margin_; }

  /// Begins an image of this size. Responses are needed for the pixels at least `border` >=
  /// margin() from the edges; there must be at least one.
  void start(cv::Size size, int border);
  /// Computes the responses in the first of those rows of that image (CV_8UC3 BGR or CV_8UC1), or
  /// in the next ones. Returns the number of rows; 0 at the end.
  int computeRows(const cv::Mat& image);
  /// Requested responses in row r of these, in lanes(). Only the first pixels are valid: as many as
  /// there are columns at least `border` from the edges.
  const float* row(const Response& response, int r) const {
    return planes_[response.plane].filters[response.filter].responses.row(response.op, r);
  }
  const StripedRows& lanes() const { return lanes_; }

 private:
  /// All operators on one channel at one scale.
  struct Filter {
    double t;
    ResponseFilter responses;
  };
  struct Plane {
    Channel channel;
    std::vector<Filter> filters;
    RowRing rows;
  };

  std::size_t planeOf(Channel channel);
  std::size_t filterOf(Plane& plane, double t);
  void takeRow(const cv::Mat& image, int y);

  DerivativeMethod method_;
  double half_width_;
  int margin_ = 0;
  std::vector<Plane> planes_;

  int border_ = 0;
  int next_row_ = 0;        ///< of the image, for the next responses
  int next_taken_ = 0;      ///< next row of the image to copy to the planes
  StripedRows lanes_;       ///< of all columns that contribute to the responses
  std::vector<float> row_;  ///< of these, in the order of the image
};

}  // namespace place_recognition
