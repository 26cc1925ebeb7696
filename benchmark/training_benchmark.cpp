// Trains on histograms of real images of five rooms: Gram matrix, machines, and the slope of the
// probabilities on held-out blocks. One core, with the same features as training_peer.py.
//
//   training_benchmark write FOLDER COUNT   writes the features of COUNT images for both
//   training_benchmark run FOLDER           prints seconds; writes the decision values, which the
//                                           peer checks

#include <ctime>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

#include "learning/binary_svms.h"
#include "learning/gram.h"
#include "place_recognition/calibration.h"
#include "views.h"

namespace place_recognition {
namespace {

constexpr int kFolds = 5;
constexpr double kGamma = 1;

template <typename T>
void writeNumbers(const std::string& path, const std::vector<T>& numbers) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(numbers.data()),
             static_cast<std::streamsize>(numbers.size() * sizeof(T)));
}

template <typename T>
std::vector<T> readNumbers(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  const auto* numbers = reinterpret_cast<const T*>(bytes.data());
  return {numbers, numbers + bytes.size() / sizeof(T)};
}

void write(const std::string& folder, std::size_t count) {
  const ViewFeatures views = extractViews(CrfhOptions(), count);
  std::vector<std::uint64_t> indices, sizes;
  std::vector<float> values;
  for (const Feature& feature : views.features) {
    const auto& histogram = std::get<SparseVector>(feature);
    indices.insert(indices.end(), histogram.indices.begin(), histogram.indices.end());
    values.insert(values.end(), histogram.values.begin(), histogram.values.end());
    sizes.push_back(histogram.size());
  }
  writeNumbers(folder + "/indices", indices);
  writeNumbers(folder + "/sizes", sizes);
  writeNumbers(folder + "/values", values);
  writeNumbers(folder + "/labels", views.labels);
}

std::vector<Feature> readFeatures(const std::string& folder) {
  const auto indices = readNumbers<std::uint64_t>(folder + "/indices");
  const auto values = readNumbers<float>(folder + "/values");
  std::vector<Feature> features;
  std::ptrdiff_t begin = 0;
  for (const std::uint64_t size : readNumbers<std::uint64_t>(folder + "/sizes")) {
    const std::ptrdiff_t end = begin + static_cast<std::ptrdiff_t>(size);
    features.push_back(SparseVector{{indices.begin() + begin, indices.begin() + end},
                                    {values.begin() + begin, values.begin() + end}});
    begin = end;
  }
  return features;
}

std::vector<int> labelsOf(const std::vector<int>& vectors, const std::vector<int>& labels) {
  std::vector<int> chosen;
  for (const int vector : vectors) chosen.push_back(labels[static_cast<std::size_t>(vector)]);
  return chosen;
}

/// Decision values of every vector from machines that were trained without its block.
Eigen::MatrixXd crossValidate(const PackedGram& gram, const std::vector<int>& labels) {
  const int count = static_cast<int>(labels.size());
  Eigen::MatrixXd decision_values(count, static_cast<Eigen::Index>(Views::kPlaces));
  for (int fold = 0; fold < kFolds; ++fold) {
    const int begin = fold * count / kFolds, end = (fold + 1) * count / kFolds;
    std::vector<int> train, test;
    for (int i = 0; i < count; ++i) (begin <= i && i < end ? test : train).push_back(i);
    const BinarySvms machines =
        trainMachines(gram, train, labelsOf(train, labels), Views::kPlaces, SvmOptions());
    decision_values.middleRows(begin, end - begin) =
        machines.decisionValues(gram.values(test, train));
  }
  return decision_values;
}

void run(const std::string& folder) {
  const std::vector<Feature> features = readFeatures(folder);
  const std::vector<int> labels = readNumbers<int>(folder + "/labels");
  std::vector<int> all;
  for (std::size_t i = 0; i < labels.size(); ++i) all.push_back(static_cast<int>(i));

  const std::clock_t start = std::clock();
  KernelOptions options;
  options.gamma = kGamma;
  const Kernel kernel(options);
  const PackedGram gram(kernel, measureMatrix(kernel, features, 1, {}), 1);
  const Calibration calibration = fitCalibration(crossValidate(gram, labels), labels);
  const BinarySvms machines = trainMachines(gram, all, labels, Views::kPlaces, SvmOptions());
  const std::clock_t end = std::clock();

  const Eigen::MatrixXd decision_values = machines.decisionValues(gram.values(all, all));
  writeNumbers(
      folder + "/decision_values",
      std::vector<double>(decision_values.data(), decision_values.data() + decision_values.size()));
  writeNumbers(folder + "/slope", std::vector<double>{calibration.slope});
  std::cout << static_cast<double>(end - start) / CLOCKS_PER_SEC << "\n";
}

}  // namespace
}  // namespace place_recognition

int main(int argc, char** argv) {
  const std::string verb = argc > 1 ? argv[1] : "";
  if (verb == "write" && argc == 4) {
    place_recognition::write(argv[2], std::stoul(argv[3]));
  } else if (verb == "run" && argc == 3) {
    place_recognition::run(argv[2]);
  } else {
    std::cerr << "usage: training_benchmark write FOLDER COUNT | run FOLDER\n";
    return 2;
  }
}
