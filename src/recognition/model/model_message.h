#pragma once

#include "model.pb.h"
#include "place_recognition/model.h"

namespace place_recognition {

/// The protobuf message of a model: everything except the classifiers and the networks.
proto::Model toMessage(const Model& model);

/// The model in `message`, without classifiers and with empty networks. Every count, range and
/// number is checked before use; throws Error, a phrase without a source, saying what is invalid.
Model fromMessage(const proto::Model& message);

}  // namespace place_recognition
