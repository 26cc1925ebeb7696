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

/// Responses of CRFH descriptors, not normalized by scale, a few rows of an image after the other.
/// A channel is taken from the image once, and what is asked of one channel at one scale shares a
/// filter. Keeps its buffers: one per thread.
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

  /// Has computeRows() compute these responses.
  Response request(const CrfhDescriptor& descriptor, double t);
  /// Pixels at each side of the image where there are no responses.
  int margin() const { return margin_; }

  /// Begins an image of this size, of which the pixels `border` >= margin() or farther from the
  /// edges are asked. There must be at least one.
  void start(cv::Size size, int border);
  /// Computes the responses in the first of those rows of that image (CV_8UC3 BGR or CV_8UC1), or
  /// in the next ones. Returns how many; at the end 0.
  int computeRows(const cv::Mat& image);
  /// Requested responses in row r of these, in lanes(), of which only the first pixels count: as
  /// many as there are columns `border` or farther from the edges.
  const float* row(const Response& response, int r) const {
    return planes_[response.plane].filters[response.filter].responses.row(response.op, r);
  }
  const StripedRows& lanes() const { return lanes_; }

 private:
  /// All operators that are asked of one channel at one scale.
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
  int next_row_ = 0;        ///< of the image, whose responses are the next
  int next_taken_ = 0;      ///< row of the image into the planes
  StripedRows lanes_;       ///< of all columns that the responses rest on
  std::vector<float> row_;  ///< of these, as they stand in the image
};

}  // namespace place_recognition
