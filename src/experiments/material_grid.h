#pragma once

#include <string>
#include <vector>

#include "place_recognition/learning_options.h"

namespace place_recognition {

/// The features of chapter 7, and MR8 without a dictionary.
constexpr const char* kMaterialFeatures[] = {"mr8", "lbp", "mr8-joint"};

/// The machines of section 7.2 for one kernel: C = 1, 10, 100, 1000, and both multi-class methods.
std::vector<SvmOptions> materialSvms();

/// The kernels of section 7.2: chi-squared and Gaussian with gamma 10^-3 ... 10^3, polynomial with
/// p = 0, 1 and d = 1 ... 5.
std::vector<KernelOptions> materialKernels();

/// The samples to train on, by number; the others are tested on.
using TrainingSamples = std::vector<int>;

/// For each size (one sample, two, and all but one), as many splits as there are samples (four in
/// the thesis). A split consists of cyclic neighbours, so that each sample is trained on equally
/// often.
std::vector<TrainingSamples> materialSplits(int sample_count);

/// The kernel's name and its parameters, such as "polynomial p=0 d=4".
std::string describe(const KernelOptions& kernel);

}  // namespace place_recognition
