#pragma once

#include <cstdint>
#include <string>

#include "place_recognition/model_file.h"
#include "recognition/drawn_recording.h"

namespace place_recognition {

/// Saves a model of drawn rooms in the models folder.
inline void saveRooms(const std::string& name, int rooms, const TrainingOptions& options) {
  saveModel(train({opener(drawFrames(rooms, 20))}, options).model, namedModelPath(name));
}

inline void saveRooms(const std::string& name, int rooms, std::uint64_t seed = 1) {
  TrainingOptions options = quickOptions();
  options.seed = seed;
  saveRooms(name, rooms, options);
}

}  // namespace place_recognition
