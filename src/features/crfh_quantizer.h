#pragma once

#include <cstdint>

#include "features/crfh_descriptor.h"
#include "features/row_kernels.h"

namespace place_recognition {

/// The digit floor((v - low) * bins / (high - low)) of the normalized response v of a descriptor at
/// scale t, from responses as ResponseFilter has them, times `weight`.
Quantizer crfhQuantizer(const CrfhDescriptor& descriptor, double t, double derivative_range,
                        int bins, std::uint64_t weight);

}  // namespace place_recognition
