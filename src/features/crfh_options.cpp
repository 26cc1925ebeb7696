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
void checkIndexFits(const CrfhOptions& options, const std::string& key) {
  std::uint64_t room = std::numeric_limits<std::uint64_t>::max();
  for (std::size_t scale = 0; scale < options.variances().size(); ++scale) {
    for (std::size_t i = 0; i < options.descriptors.size(); ++i) {
      room /= options.bins[options.bins.size() > 1 ? i : 0];
    }
  }
  require(room > 0, "The product of '" + key +
                        ".bins' over all descriptors and scales exceeds 64 bits; use fewer bins, "
                        "descriptors or scales.");
}

/// Throws Error unless every descriptor exists.
void checkDescriptors(const std::vector<std::string>& descriptors, const std::string& key) {
  requireSome(descriptors, key, "at least one descriptor");
  for (const std::string& name : descriptors) {
    try {
      parseDescriptor(name);
    } catch (const Error& e) {
      throw Error("Option '" + key + "': " + e.what());
    }
  }
}

}  // namespace

std::vector<double> CrfhOptions::variances() const {
  if (sigmas.empty()) return scales;
  std::vector<double> variances;
  for (double sigma : sigmas) variances.push_back(sigma * sigma);
  return variances;
}

void CrfhOptions::check(const std::string& key) const {
  checkDescriptors(descriptors, key + ".descriptors");
  require(!variances().empty(),
          "Options '" + key + ".scales' and '" + key + ".sigmas' are empty; give a scale.");
  for (const double sigma : sigmas) {
    requireOption(sigma > 0 && sigma * sigma >= kSmallestScale && sigma * sigma <= kLargestScale,
                  key + ".sigmas", sigma, "0.1 to 20 pixels");
  }
  for (const double t : scales) {
    requireOption(t >= kSmallestScale && t <= kLargestScale, key + ".scales", t,
                  "0.01 to 400 pixels^2");
  }
  require(bins.size() == 1 || bins.size() == descriptors.size(),
          "Option '" + key + ".bins' has " + std::to_string(bins.size()) + " numbers for " +
              std::to_string(descriptors.size()) +
              " descriptors; give one for all or one for each.");
  for (const int n : bins) {
    requireOption(n >= 1 && n <= kMaxBins, key + ".bins", n, "1 to 65536");
  }
  checkIndexFits(*this, key);

  requireOption(levels == "linear" || levels == "logarithmic", key + ".levels", levels,
                "linear or logarithmic");
  requireOption(derivatives == "central-difference" || derivatives == "gaussian",
                key + ".derivatives", derivatives, "central-difference or gaussian");
  requireOption(derivative_range > 0 && std::isfinite(derivative_range), key + ".derivative_range",
                derivative_range, "a number above 0");
  requireOption(half_width > 0 && half_width <= 10, key + ".half_width", half_width,
                "above 0, up to 10");
  requireOption(border >= 0 && border <= 10000, key + ".border", border, "0 to 10000 pixels");
}

}  // namespace place_recognition
