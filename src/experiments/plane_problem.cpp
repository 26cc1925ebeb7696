#include "experiments/plane_problem.h"

#include <cmath>
#include <random>

#include "learning/gram.h"
#include "learning/reduction.h"

namespace place_recognition {
namespace {

constexpr int kPoints = 160;
constexpr double kOverlap = 0.4;  ///< about the largest distance of a point from its own side
constexpr std::uint64_t kSeed = 5;

Feature point(double x, double y) {
  return DenseVector{{static_cast<float>(x), static_cast<float>(y)}};
}

double heightOf(PlaneBorder border, double x) {
  constexpr double kHalf = kPlaneSide / 2;
  if (border == PlaneBorder::kLine) return kHalf + 0.6 * (x - kHalf);
  return kHalf + 0.25 * std::sin(2 * M_PI * x / kPlaneSide);
}

Eigen::MatrixXd gramOf(const PlanePoints& points, const KernelOptions& options) {
  const Kernel kernel(options);
  return gramMatrix(kernel, measureMatrix(kernel, points.points, 1, {}));
}

}  // namespace

PlanePoints planePoints(PlaneBorder border) {
  std::mt19937_64 random(kSeed);
  const auto uniform = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  PlanePoints made;
  for (int i = 0; i < kPoints; ++i) {
    const double x = kPlaneSide * uniform();
    const double y = kPlaneSide * uniform();
    const double noise = kOverlap * (uniform() + uniform() - 1);
    made.points.push_back(point(x, y));
    made.classes.push_back(y + noise > heightOf(border, x) ? 0 : 1);
  }
  return made;
}

PlaneMachine trainInPlane(const PlanePoints& points, const KernelOptions& kernel, double c) {
  const SvmOptions svm{c, "one-against-one"};  // one machine for the two classes
  BinarySvms svms = trainMachines(gramOf(points, kernel), points.classes, 2, svm);
  return {supportVectors(svms), svms, kernel};
}

PlaneMachine reduceInPlane(const PlanePoints& points, const PlaneMachine& machine, double tau) {
  ReductionOptions options;
  options.method = "qr";
  options.tau = tau;
  BinarySvms reduced = reduce(machine.svms, gramOf(points, machine.kernel), options);
  return {supportVectors(reduced), reduced, machine.kernel};
}

cv::Mat planeValues(const PlanePoints& points, const PlaneMachine& machine, int size) {
  const Kernel kernel(machine.kernel);
  cv::Mat values(size, size, CV_64FC1);
  for (int row = 0; row < size; ++row) {
    for (int column = 0; column < size; ++column) {
      const Feature here =
          point(kPlaneSide * (column + 0.5) / size, kPlaneSide * (size - row - 0.5) / size);
      double value = machine.svms.biases[0];
      for (const int i : machine.vectors) {
        value +=
            machine.svms.weights(i, 0) * kernel(points.points[static_cast<std::size_t>(i)], here);
      }
      values.at<double>(row, column) = value;
    }
  }
  return values;
}

}  // namespace place_recognition
