#pragma once

#include <memory>
#include <mutex>
#include <string>

#include "place_recognition/model.h"

namespace place_recognition {

/// The model in use, exchanged as a whole while others recognize with it. Thread-safe: loading
/// happens in the thread that asks for it, and nobody waits for that to take the model in use.
class ModelSlot {
 public:
  /// Loads the model `name` from modelFolder() in place of the one in use. Throws Error, saying why
  /// and leaving the one in use, if it cannot be loaded.
  void load(const std::string& name);

  /// Loads the model in use once more or, if there is none yet, that which could not be loaded.
  /// Throws Error like load().
  void reload();

  /// The model in use; null: none yet.
  std::shared_ptr<const Model> model() const;

  /// Why the last load() or reload() has failed; empty: it has not.
  std::string problem() const;

 private:
  mutable std::mutex mutex_;  // of the three below
  std::shared_ptr<const Model> model_;
  std::string name_;  // what reload() loads
  std::string problem_;
  std::mutex loading_;  // one at a time
};

}  // namespace place_recognition
