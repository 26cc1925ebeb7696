#pragma once

#include <string>

#include "features/response_filter.h"

namespace place_recognition {

/// What a descriptor looks at: intensity L = (R + G + B) / 3, a colour channel, or a chromatic cue
/// C1 = (R - G) / 2 and C2 = (R + G) / 2 - B (thesis section 4.2).
enum class Channel { kL, kR, kG, kB, kC1, kC2 };
constexpr int kChannels = 6;

/// One dimension of a composed receptive field histogram, but for its scale.
struct CrfhDescriptor {
  Channel channel;
  Operator op;
};

/// Responses, in grey levels, that fall in the first and past the last bin.
struct ResponseRange {
  double low;
  double high;
};

/// Parses a name such as "Lxx", "C1" or "det(R)". Throws Error if there is no such descriptor.
CrfhDescriptor parseDescriptor(const std::string& name);

/// The range of a descriptor. That of derivatives is `derivative_range`, whatever the channel; that
/// of the determinant is a quarter of it, in grey levels squared.
ResponseRange responseRange(const CrfhDescriptor& descriptor, double derivative_range);

/// The factor that makes a response of this operator independent of scale: t^(order/2), eq. 4.14
/// with gamma = 1; t^2 for the determinant.
double scaleNormalization(Operator op, double t);

}  // namespace place_recognition
