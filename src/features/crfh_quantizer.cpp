#include "features/crfh_quantizer.h"

#include <cmath>

#include "features/channel_rows.h"

namespace place_recognition {

Quantizer crfhQuantizer(const CrfhDescriptor& descriptor, double t, double derivative_range,
                        int bins, std::uint64_t weight) {
  const auto [unit, middle] = channelScale(descriptor.channel);
  const bool quadratic = descriptor.op == Operator::kDeterminant;
  const double normalization =
      scaleNormalization(descriptor.op, t) * (quadratic ? unit * unit : unit);
  const double shift = descriptor.op == Operator::kValue ? unit * middle : 0;

  const ResponseRange range = responseRange(descriptor, derivative_range);
  const double bins_per_unit = bins / (range.high - range.low);
  const double offset = (shift - range.low) * bins_per_unit;
  const double whole = std::floor(offset);
  return {static_cast<float>(normalization * bins_per_unit), static_cast<float>(offset - whole),
          static_cast<float>(-whole), static_cast<float>(bins - 1 - whole),
          static_cast<std::uint32_t>(weight)};
}

}  // namespace place_recognition
