#include <cmath>
#include <cstdint>
#include <limits>

#include "base/require.h"
#include "features/crfh_descriptor.h"
#include "place_recognition/error.h"
#include "place_recognition/feature_options.h"

namespace place_recognition {
namespace {

constexpr double kSmallestScale = 0.01;  // a sampled Gaussian of less is a single sample
constexpr double kLargestScale = 400;
constexpr int kMaxBins = 65536;

/// Throws unless the total number of bins, the product over all dimensions, fits into 64 bits.
void checkIndexFits(const CrfhOptions& options) {
  std::uint64_t room = std::numeric_limits<std::uint64_t>::max();
  for (std::size_t scale = 0; scale < options.variances().size(); ++scale) {
    for (std::size_t i = 0; i < options.descriptors.size(); ++i) {
      room /= options.bins[options.bins.size() > 1 ? i : 0];
    }
  }
  require(room > 0,
          "The product of the CRFH 'bins' over all descriptors and scales exceeds 64 "
          "bits; use fewer bins, descriptors or scales.");
}

}  // namespace

std::vector<double> CrfhOptions::variances() const {
  if (sigmas.empty()) return scales;
  std::vector<double> variances;
  for (double sigma : sigmas) variances.push_back(sigma * sigma);
  return variances;
}

void CrfhOptions::check() const {
  require(!descriptors.empty(), "CRFH option 'descriptors' is empty; name at least one.");
  for (const std::string& name : descriptors) parseDescriptor(name);

  require(!variances().empty(), "CRFH options 'scales' and 'sigmas' are empty; give a scale.");
  for (double sigma : sigmas) {
    require(sigma > 0 && sigma * sigma >= kSmallestScale && sigma * sigma <= kLargestScale,
            "CRFH option 'sigmas' must be from 0.1 to 20.");
  }
  for (double t : scales) {
    require(t >= kSmallestScale && t <= kLargestScale,
            "CRFH option 'scales' must be from 0.01 to 400.");
  }
  require(bins.size() == 1 || bins.size() == descriptors.size(),
          "CRFH option 'bins' has " + std::to_string(bins.size()) + " numbers for " +
              std::to_string(descriptors.size()) +
              " descriptors; give one for all or one for each.");
  for (int n : bins) {
    require(n >= 1 && n <= kMaxBins,
            "CRFH option 'bins' is " + std::to_string(n) + "; give numbers from 1 to 65536.");
  }
  checkIndexFits(*this);

  require(levels == "linear" || levels == "logarithmic",
          "CRFH option 'levels' is '" + levels + "'; give linear or logarithmic.");
  require(
      derivatives == "central-difference" || derivatives == "gaussian",
      "CRFH option 'derivatives' is '" + derivatives + "'; give central-difference or gaussian.");
  require(derivative_range > 0 && std::isfinite(derivative_range),
          "CRFH option 'derivative_range' must be positive.");
  require(half_width > 0 && half_width <= 10, "CRFH option 'half_width' must be > 0 and <= 10.");
  require(border >= 0 && border <= 10000, "CRFH option 'border' must be from 0 to 10000.");
}

}  // namespace place_recognition
