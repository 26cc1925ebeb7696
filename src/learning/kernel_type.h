#pragma once

#include <string>

namespace place_recognition {

/// What is measured between two features ...
enum class Measure { kDot, kSquaredDistance, kChiSquared, kIntersection, kLocalMatch };

/// ... and how that becomes the value of the kernel.
enum class Response { kIdentity, kPolynomial, kSigmoid, kExponential };

/// One line of the table in kernel.h.
struct KernelType {
  const char* name;
  Measure measure;
  Response response;
};

/// Throws Error, listing the types that exist, if none has this name.
const KernelType& kernelType(const std::string& name);

/// Throws Error, listing the types that have, if `type` has no meaning for such features.
void requireMeaning(const KernelType& type, bool for_descriptors);

/// Throws Error, listing the types that have, if `type` has no meaning for vectors with negative
/// elements: what compares histograms bin by bin.
void requireSignedMeaning(const KernelType& type);

}  // namespace place_recognition
