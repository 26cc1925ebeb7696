#pragma once

#include <string>
#include <vector>

#include "place_recognition/learning_options.h"

namespace place_recognition {

/// The features of chapter 7, and MR8 without a dictionary.
constexpr const char* kMaterialFeatures[] = {"mr8", "lbp", "mr8-joint"};

/// The machines of section 7.2 that share a kernel: C = 1, 10, 100, 1000, both ways of many
/// classes.
std::vector<SvmOptions> materialSvms();

/// The kernels of section 7.2: chi-squared and Gaussian of gamma 10^-3 ... 10^3, polynomial of p =
/// 0, 1 and d = 1 ... 5.
std::vector<KernelOptions> materialKernels();

/// Which samples are trained on, by number; the other ones are tested on.
using TrainingSamples = std::vector<int>;

/// As many splits of each size as there are samples (four in the thesis): one sample, two, and all
/// but one. A split holds neighbours in a circle, so that each sample is trained on equally often.
std::vector<TrainingSamples> materialSplits(int sample_count);

/// The kernel's name and the parameters it has, as in "polynomial p=0 d=4".
std::string describe(const KernelOptions& kernel);

}  // namespace place_recognition
