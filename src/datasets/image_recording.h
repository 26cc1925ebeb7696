#pragma once

#include <memory>
#include <string>
#include <vector>

#include "datasets/image_set.h"
#include "place_recognition/recording.h"

namespace place_recognition {

/// The images as a recording of one camera, in their order. `warnings`: see Recording::warnings().
std::unique_ptr<Recording> recordingOf(std::string name, std::vector<LabelledImage> images,
                                       std::vector<std::string> warnings = {});

}  // namespace place_recognition
