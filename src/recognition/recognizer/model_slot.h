#pragma once

#include <memory>
#include <mutex>
#include <string>

#include "place_recognition/model.h"

namespace place_recognition {

/// The model in use, which can be replaced while others recognize with it. Thread-safe: a model is
/// loaded in the calling thread, and getting the model in use never waits for that.
class ModelSlot {
 public:
  /// Replaces the model in use by `name` from modelFolder(). Throws Error, saying why and keeping
  /// the model in use, if it cannot be loaded.
  void load(const std::string& name);

  /// Loads the model in use again or, if there is none yet, the one that could not be loaded.
  /// Throws Error like load().
  void reload();

  /// The model in use; null: none yet.
  std::shared_ptr<const Model> model() const;

  /// Why the last load() or reload() failed; empty if it did not.
  std::string problem() const;

 private:
  mutable std::mutex mutex_;  // guards the three below
  std::shared_ptr<const Model> model_;
  std::string name_;  // what reload() loads
  std::string problem_;
  std::mutex loading_;  // one at a time
};

}  // namespace place_recognition
