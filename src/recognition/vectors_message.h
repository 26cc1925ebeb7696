#pragma once

#include <string>
#include <vector>

#include "model.pb.h"
#include "place_recognition/feature.h"
#include "place_recognition/feature_options.h"

namespace place_recognition {

/// What the vectors of an extractor look like.
struct VectorForm {
  proto::Vectors::Kind kind = proto::Vectors::SPARSE;
  std::size_t dimension = 0;  ///< of dense vectors
};
VectorForm vectorForm(const FeatureOptions& options);

/// The support vectors of one classifier as a message; all of the given kind.
proto::Vectors toMessage(const std::vector<Feature>& features, proto::Vectors::Kind kind);

/// The support vectors in `message`. Throws Error, a phrase without a source, if its sizes, indices
/// or values are not those of vectors of the given form.
std::vector<Feature> fromMessage(const proto::Vectors& message, const VectorForm& form);

}  // namespace place_recognition
