#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "learning/binary_svms.h"
#include "place_recognition/feature.h"
#include "place_recognition/learning_options.h"

namespace place_recognition {

/// Side length of the square that contains the points; it starts at 0.
constexpr double kPlaneSide = 1;

/// An artificial problem of two classes in the plane, which overlap near their border.
struct PlanePoints {
  std::vector<Feature> points;  ///< DenseVector of x and y
  std::vector<int> classes;     ///< 0 or 1
};

/// The border between the classes, apart from the overlap.
enum class PlaneBorder { kLine, kWave };

/// Returns the same points at each call.
PlanePoints planePoints(PlaneBorder border);

/// One machine on points of the plane, positive for class 0, before or after reduction.
struct PlaneMachine {
  std::vector<int> vectors;  ///< points with a weight
  BinarySvms svms;           ///< over all points
  KernelOptions kernel;
};

PlaneMachine trainInPlane(const PlanePoints& points, const KernelOptions& kernel, double c);

/// Reduces with the thesis' method and normalization (section 6.3).
PlaneMachine reduceInPlane(const PlanePoints& points, const PlaneMachine& machine, double tau);

/// Values of the discriminant function (eq. 5.32) at the centres of size x size pixels, the first
/// row at the largest y. CV_64FC1.
cv::Mat planeValues(const PlanePoints& points, const PlaneMachine& machine, int size);

}  // namespace place_recognition
