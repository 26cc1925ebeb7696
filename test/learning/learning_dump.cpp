// Prints synthetic problems and the learning layer's results as JSON, for learning_check.py.
#include <iostream>
#include <limits>

#include "learning/binary_svms.h"
#include "learning/gram.h"
#include "learning/random_features.h"
#include "learning/reduction.h"
#include "place_recognition/calibration.h"

namespace place_recognition {
namespace {

template <typename Sequence>
void printList(const Sequence& values) {
  const char* separator = "[";
  for (const auto& value : values) {
    std::cout << separator << +value;
    separator = ",";
  }
  std::cout << (values.empty() ? "[]" : "]");
}

void print(const Eigen::MatrixXd& matrix) {
  std::cout << "[";
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    std::cout << (i > 0 ? ",[" : "[");
    for (Eigen::Index j = 0; j < matrix.cols(); ++j)
      std::cout << (j > 0 ? "," : "") << matrix(i, j);
    std::cout << "]";
  }
  std::cout << "]";
}

void print(const Feature& feature) {
  if (const auto* sparse = std::get_if<SparseVector>(&feature)) {
    std::cout << "{\"indices\":";
    printList(sparse->indices);
    std::cout << ",\"values\":";
    printList(sparse->values);
    std::cout << "}";
  } else if (const auto* dense = std::get_if<DenseVector>(&feature)) {
    printList(dense->values);
  } else {
    printList(std::get<DescriptorSet>(feature).descriptors);
  }
}

/// Prints one JSON object per line.
void printKernel(const KernelOptions& options, const std::vector<Feature>& features) {
  const Kernel kernel(options);
  std::cout << "{\"check\":\"kernel\",\"type\":\"" << options.type
            << "\",\"gamma\":" << options.gamma << ",\"p\":" << options.p << ",\"d\":" << options.d
            << ",\"kappa\":" << options.kappa << ",\"theta\":" << options.theta
            << ",\"features\":[";
  for (std::size_t i = 0; i < features.size(); ++i) {
    if (i > 0) std::cout << ",";
    print(features[i]);
  }
  std::cout << "],\"gram\":";
  print(gramMatrix(kernel, measureMatrix(kernel, features, 1, {})));
  std::cout << "}\n";
}

void printKernels() {
  RandomFeatures random(20);
  std::vector<Feature> histograms;
  std::vector<Feature> vectors;
  std::vector<Feature> sets;
  for (std::size_t i = 0; i < 12; ++i) {
    histograms.push_back(random.histogram(60));
    vectors.push_back(random.dense(9));
    sets.push_back(random.descriptors(1 + i % 5));
  }
  KernelOptions options;
  options.p = 0.5;
  options.d = 2;
  options.kappa = 1.5;
  options.theta = -0.25;
  options.gamma = 0.75;
  for (const char* type :
       {"linear", "polynomial", "gaussian", "sigmoid", "chi-squared", "intersection"}) {
    options.type = type;
    printKernel(options, histograms);
    printKernel(options, vectors);
  }
  options.type = "local-match";
  printKernel(options, sets);
}

void printReductions() {
  RandomFeatures random(21);
  std::vector<Feature> features;
  std::vector<int> labels;
  for (int i = 0; i < 60; ++i) {
    features.push_back(random.dense(3));
    labels.push_back(static_cast<int>(random.uniform(0, 3)));
  }
  const Kernel kernel(kernelOptions("gaussian", 2));
  const Eigen::MatrixXd gram = gramMatrix(kernel, measureMatrix(kernel, features, 1, {}));
  SvmOptions svm;
  const BinarySvms machines = trainMachines(gram, labels, 3, svm);
  std::cout << "{\"check\":\"machines\",\"c\":" << svm.c << ",\"labels\":";
  printList(labels);
  std::cout << ",\"gram\":";
  print(gram);
  std::cout << ",\"weights\":";
  print(machines.weights);
  std::cout << ",\"biases\":";
  print(machines.biases);
  std::cout << "}\n";

  for (const char* method : {"qr", "shared-qr", "shared-greedy"}) {
    for (const bool normalize : {true, false}) {
      for (const double tau : {1e-3, 0.03}) {
        ReductionOptions options;
        options.method = method;
        options.normalize = normalize;
        options.tau = tau;
        std::cout << "{\"check\":\"reduction\",\"method\":\"" << method
                  << "\",\"normalize\":" << normalize << ",\"tau\":" << tau << ",\"gram\":";
        print(gram);
        std::cout << ",\"weights\":";
        print(machines.weights);
        std::cout << ",\"reduced\":";
        print(reduce(machines, gram, options).weights);
        std::cout << "}\n";
      }
    }
  }
}

void printCalibration() {
  RandomFeatures random(22);
  Eigen::MatrixXd decision_values(50, 4);
  std::vector<int> labels;
  for (Eigen::Index i = 0; i < 50; ++i) {
    labels.push_back(static_cast<int>(random.uniform(0, 4)));
    for (Eigen::Index k = 0; k < 4; ++k) {
      decision_values(i, k) = random.uniform(-2, 1) + (labels.back() == k ? 1.2 : 0);
    }
  }
  std::cout << "{\"check\":\"calibration\",\"labels\":";
  printList(labels);
  std::cout << ",\"decision_values\":";
  print(decision_values);
  std::cout << ",\"slope\":" << fitCalibration(decision_values, labels).slope << "}\n";
}

}  // namespace
}  // namespace place_recognition

int main() {
  std::cout.precision(std::numeric_limits<double>::max_digits10);
  place_recognition::printKernels();
  place_recognition::printReductions();
  place_recognition::printCalibration();
}
