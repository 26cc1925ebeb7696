#pragma once

#include <memory>
#include <mutex>
#include <string>

#include "place_recognition/model.h"

namespace place_recognition {

/// The model in use, which can be replaced while others recognize with it. Thread-safe: a model is
/// read in the calling thread, and getting the model in use never waits for that.
class ModelSlot {
 public:
  /// A model that has been read.
  struct Loaded {
    std::string name;
    std::shared_ptr<const Model> model;
  };

  /// Reads the model `name` from modelFolder(). Throws Error, saying why, if it cannot be loaded.
  Loaded read(const std::string& name);

  /// Reads the model in use again or, if there is none yet, the one that could not be loaded.
  /// Throws Error like read().
  Loaded readAgain();

  /// Replaces the model in use. One of the same version stays, so that recognizers keep what they
  /// have learned of the light and the evidence of their stream.
  void use(Loaded loaded);

  /// Throws Error like read(), keeping the model in use.
  void load(const std::string& name) { use(read(name)); }
  void reload() { use(readAgain()); }

  /// The model in use; null: none yet.
  std::shared_ptr<const Model> model() const;

  /// Why no model could be read since the last one was put into use; empty if none failed.
  std::string problem() const;

 private:
  mutable std::mutex mutex_;  // guards the three below
  std::shared_ptr<const Model> model_;
  std::string name_;  // what readAgain() reads
  std::string problem_;
};

}  // namespace place_recognition
