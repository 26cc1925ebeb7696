// Times the chi-squared kernel of one frame with 1000 histograms of real images, and the decision
// values of five rooms over them. The peer is libsvm's method: it merges sorted lists and calls
// svm_predict_values() for each room's machine with the result as precomputed kernel. One core.

#include <benchmark/benchmark.h>
#include <svm.h>

#include <cmath>

#include "learning/binary_svms.h"
#include "learning/support_set.h"
#include "views.h"

namespace place_recognition {
namespace {

constexpr std::size_t kVectors = 1000;
constexpr double kGamma = 1;
constexpr double kTolerance = 1e-6;  // of kernel values and decision values; elements are floats

/// A histogram in the format of libsvm's sparse kernels.
using Nodes = std::vector<svm_node>;

Nodes toNodes(const Feature& feature) {
  const auto& histogram = std::get<SparseVector>(feature);
  Nodes nodes;
  for (std::size_t i = 0; i < histogram.size(); ++i) {
    nodes.push_back({static_cast<int>(histogram.indices[i]), histogram.values[i]});
  }
  nodes.push_back({-1, 0});
  return nodes;
}

/// Written like libsvm's Kernel::k_function() for the Gaussian kernel.
double mergedKernel(const svm_node* x, const svm_node* y) {
  double sum = 0;
  while (x->index != -1 && y->index != -1) {
    if (x->index == y->index) {
      const double difference = x->value - y->value;
      sum += difference * difference / (x->value + y->value);
      ++x;
      ++y;
    } else if (x->index > y->index) {
      sum += y->value;
      ++y;
    } else {
      sum += x->value;
      ++x;
    }
  }
  for (; x->index != -1; ++x) sum += x->value;
  for (; y->index != -1; ++y) sum += y->value;
  return std::exp(-kGamma * sum);
}

struct Setup {
  KernelOptions kernel;
  std::vector<Feature> vectors = extractViews(CrfhOptions(), kVectors).features;
  Feature frame = extractViews(CrfhOptions(), 1, 4 * kVectors).features.front();
  BinarySvms machines;

  Setup() {
    kernel.gamma = kGamma;
    machines.places = Views::kPlaces;
    machines.weights.setZero(kVectors, Views::kPlaces);
    for (Eigen::Index i = 0; i < machines.weights.size(); ++i) {
      machines.weights(i) = std::cos(static_cast<double>(i));  // every vector in every machine
    }
    machines.biases.setConstant(Views::kPlaces, 0.25);
  }
};

const Setup& setup() {
  static const Setup setup;
  return setup;
}

/// The same with libsvm.
class Peer {
 public:
  Peer() : frame_(toNodes(setup().frame)), column_(kVectors + 1) {
    for (const Feature& vector : setup().vectors) vectors_.push_back(toNodes(vector));
    for (std::size_t i = 0; i < kVectors; ++i) {
      numbers_.push_back({0, static_cast<double>(i + 1)});
    }
    for (svm_node& number : numbers_) rows_.push_back(&number);
    for (std::size_t m = 0; m < Views::kPlaces; ++m) {
      weights_.push_back(setup().machines.weights.col(static_cast<Eigen::Index>(m)));
    }
  }

  const std::vector<svm_node>& column() {
    for (std::size_t i = 0; i < kVectors; ++i) {
      column_[i + 1].value = mergedKernel(frame_.data(), vectors_[i].data());
    }
    return column_;
  }

  const Eigen::RowVectorXd& decisionValues() {
    column();
    decision_values_.resize(Views::kPlaces);
    for (std::size_t m = 0; m < Views::kPlaces; ++m) decision_values_[m] = decisionValue(m);
    return decision_values_;
  }

 private:
  double decisionValue(std::size_t machine) {
    double* weights = weights_[machine].data();
    double rho = -setup().machines.biases[machine];
    int labels[] = {1, -1};
    int counts[] = {static_cast<int>(kVectors), 0};
    svm_model model = {};
    model.param.svm_type = C_SVC;
    model.param.kernel_type = PRECOMPUTED;
    model.nr_class = 2;
    model.l = static_cast<int>(kVectors);
    model.SV = rows_.data();
    model.sv_coef = &weights;
    model.rho = &rho;
    model.label = labels;
    model.nSV = counts;
    double decision_value = 0;
    svm_predict_values(&model, column_.data(), &decision_value);
    return decision_value;
  }

  Nodes frame_;
  std::vector<Nodes> vectors_;
  Nodes column_;
  Nodes numbers_;
  std::vector<svm_node*> rows_;
  std::vector<Eigen::VectorXd> weights_;
  Eigen::RowVectorXd decision_values_;
};

Peer& peer() {
  static Peer peer;
  return peer;
}

void columnOfKernel(benchmark::State& state) {
  const SupportSet set(Kernel(setup().kernel), setup().vectors);
  Eigen::VectorXd values(kVectors);
  for (auto _ : state) set.kernelValues(setup().frame, values);
  const std::vector<svm_node>& expected = peer().column();
  for (std::size_t i = 0; i < kVectors; ++i) {
    if (std::abs(values[i] - expected[i + 1].value) > kTolerance) {
      state.SkipWithError("The kernel values differ from the peer's.");
    }
  }
}

void columnByMerging(benchmark::State& state) {
  peer();  // preparation, which is not timed
  for (auto _ : state) benchmark::DoNotOptimize(peer().column().data());
}

void decision(benchmark::State& state) {
  const SupportSet set(Kernel(setup().kernel), setup().vectors);
  Eigen::VectorXd values(kVectors);
  Eigen::RowVectorXd decision_values;
  for (auto _ : state) {  // as Classifier::decisionValues() does
    set.kernelValues(setup().frame, values);
    decision_values =
        placeValues(setup().machines, setup().machines.decisionValues(values.transpose()));
  }
  if (!decision_values.isApprox(peer().decisionValues(), kTolerance)) {
    state.SkipWithError("The decision values differ from libsvm's.");
  }
}

void decisionOfLibsvm(benchmark::State& state) {
  peer();
  for (auto _ : state) benchmark::DoNotOptimize(peer().decisionValues().data());
}

BENCHMARK(columnOfKernel)->Unit(benchmark::kMillisecond);
BENCHMARK(columnByMerging)->Unit(benchmark::kMillisecond);
BENCHMARK(decision)->Unit(benchmark::kMillisecond);
BENCHMARK(decisionOfLibsvm)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace place_recognition
