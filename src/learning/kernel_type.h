#pragma once

#include <string>

namespace place_recognition {

/// The measure between two features ...
enum class Measure { kDot, kSquaredDistance, kChiSquared, kIntersection, kLocalMatch };

/// ... and the function that maps it to the value of the kernel.
enum class Response { kIdentity, kPolynomial, kSigmoid, kExponential };

/// One line of the table in kernel.h.
struct KernelType {
  const char* name;
  Measure measure;
  Response response;
};

/// Throws Error, listing the existing types, if none has this name, which is the value of the
/// option `key`.
const KernelType& kernelType(const std::string& name, const std::string& key = "kernel.type");

/// Whether the measure or the response has a parameter gamma.
bool hasGamma(const KernelType& type);

/// Throws Error, listing the suitable types, if `type` is not defined for such features.
void requireMeaning(const KernelType& type, bool for_descriptors);

/// Throws Error, listing the suitable types, if `type` is not defined for vectors with negative
/// elements because it compares histograms bin by bin.
void requireSignedMeaning(const KernelType& type);

}  // namespace place_recognition
