#include "experiments/material_grid.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/text.h"

namespace place_recognition {

std::vector<SvmOptions> materialSvms() {
  std::vector<SvmOptions> svms;
  for (const char* multiclass : {"one-against-one", "one-against-all"}) {
    for (const double c : {1, 10, 100, 1000}) svms.push_back({c, multiclass});
  }
  return svms;
}

std::vector<KernelOptions> materialKernels() {
  std::vector<KernelOptions> kernels;
  KernelOptions kernel;
  for (const char* type : {"chi-squared", "gaussian"}) {
    kernel.type = type;
    for (int power = -3; power <= 3; ++power) {
      kernel.gamma = std::pow(10, power);
      kernels.push_back(kernel);
    }
  }
  kernel = KernelOptions();
  kernel.type = "polynomial";
  for (const double p : {0, 1}) {
    kernel.p = p;
    for (kernel.d = 1; kernel.d <= 5; ++kernel.d) kernels.push_back(kernel);
  }
  return kernels;
}

std::vector<TrainingSamples> materialSplits(int sample_count) {
  std::vector<TrainingSamples> splits;
  for (const int size : std::set<int>{1, 2, sample_count - 1}) {
    for (int first = 0; first < sample_count; ++first) {
      TrainingSamples& split = splits.emplace_back();
      for (int i = 0; i < size; ++i) split.push_back((first + i) % sample_count);
      std::sort(split.begin(), split.end());
    }
  }
  return splits;
}

std::string describe(const KernelOptions& kernel) {
  if (kernel.type == "polynomial") {
    return "polynomial p=" + significant(kernel.p) + " d=" + std::to_string(kernel.d);
  }
  return kernel.type + " gamma=" + significant(kernel.gamma);
}

}  // namespace place_recognition
