#pragma once

#include <cstdint>
#include <string>

#include "features/response_filter.h"
#include "features/row_kernels.h"

namespace place_recognition {

/// The input of a descriptor: intensity L = (R + G + B) / 3, a colour channel, or one of the
/// chromatic cues C1 = (R - G) / 2 and C2 = (R + G) / 2 - B (thesis section 4.2).
enum class Channel { kL, kR, kG, kB, kC1, kC2 };
constexpr int kChannels = 6;

/// One dimension of a composed receptive field histogram, without its scale.
struct CrfhDescriptor {
  Channel channel;
  Operator op;
};

/// Parses a name such as "Lxx", "C1" or "det(R)". Throws Error if there is no such descriptor.
CrfhDescriptor parseDescriptor(const std::string& name);

/// Maps responses of ResponseFilter to digits: `weight` times floor((v - low) * bins / (high -
/// low)), where v is the normalized response of the descriptor at scale t.
Quantizer crfhQuantizer(const CrfhDescriptor& descriptor, double t, double derivative_range,
                        int bins, std::uint64_t weight);

}  // namespace place_recognition
