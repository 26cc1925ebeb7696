#pragma once

#include <string>

#include "model.pb.h"
#include "place_recognition/model.h"

namespace place_recognition {

/// The protobuf message of a model.
proto::Model toMessage(const Model& model);

/// The model in `message`; `where` names its source. Every count, range and number is checked
/// before it is used; throws Error saying what does not fit.
Model fromMessage(const proto::Model& message, const std::string& where);

}  // namespace place_recognition
