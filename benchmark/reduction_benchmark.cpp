// Reduces the machines of five rooms, trained on 1000 real images, each machine by itself (`qr`),
// and compares it with Eigen's ColPivHouseholderQR of each machine. One core. Columns are not
// normalized, because then the first pivot would be a tie, which rounding errors would decide.

#include <benchmark/benchmark.h>

#include <opencv2/core.hpp>

#include "learning/gram.h"
#include "learning/reduction.h"
#include "learning/thesis_reduction.h"
#include "views.h"

namespace place_recognition {
namespace {

constexpr std::size_t kImages = 1000;
constexpr double kTolerance = 1e-6;  // of the largest decision value

struct Setup {
  Eigen::MatrixXd gram;
  BinarySvms machines;

  Setup() {
    const ViewFeatures views = extractViews(CrfhOptions(), kImages);
    KernelOptions options;
    options.gamma = 2;  // so that few vectors depend on others
    const Kernel kernel(options);
    gram = gramMatrix(kernel, measureMatrix(kernel, views.features, 1, {}));
    machines = trainMachines(gram, views.labels, Views::kPlaces, SvmOptions());
  }
};

const Setup& setup() {
  static const Setup setup;
  return setup;
}

ReductionOptions options(double tau) {
  ReductionOptions options;
  options.method = "qr";
  options.tau = tau;
  options.normalize = false;
  return options;
}

BinarySvms reduceWithEigen(double tau) {
  BinarySvms reduced = setup().machines;
  for (Eigen::Index m = 0; m < reduced.weights.cols(); ++m) {
    reduced.weights.col(m) = thesisReduction(setup().gram, reduced.weights.col(m), tau, false);
  }
  return reduced;
}

double countWeights(const BinarySvms& machines) {
  return static_cast<double>((machines.weights.array() != 0).count());
}

void qr(benchmark::State& state, double tau) {
  setup();  // preparation, which is not timed
  BinarySvms reduced;
  for (auto _ : state) reduced = reduce(setup().machines, setup().gram, options(tau));
  const BinarySvms expected = reduceWithEigen(tau);
  state.counters["before"] = countWeights(setup().machines);
  state.counters["after"] = countWeights(reduced);
  const Eigen::MatrixXd decision_values = expected.decisionValues(setup().gram);
  const double change =
      (reduced.decisionValues(setup().gram) - decision_values).cwiseAbs().maxCoeff();
  if (countWeights(reduced) != countWeights(expected) ||
      change > kTolerance * decision_values.cwiseAbs().maxCoeff()) {
    state.SkipWithError("The reduced machines differ from the peer's.");
  }
}

void qrOfEigen(benchmark::State& state, double tau) {
  setup();
  for (auto _ : state) benchmark::DoNotOptimize(reduceWithEigen(tau));
}

void registerAll(const std::string& name, double tau) {
  const auto add = [&](const char* who, auto function) {
    benchmark::RegisterBenchmark(("reduction/" + name + "/" + who).c_str(), function, tau)
        ->Unit(benchmark::kMillisecond);
  };
  add("ours", qr);
  add("eigen", qrOfEigen);
}

}  // namespace
}  // namespace place_recognition

int main(int argc, char** argv) {
  cv::setNumThreads(1);
  place_recognition::registerAll("none_dropped", 1e-4);
  place_recognition::registerAll("default_tau", 0.01);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
