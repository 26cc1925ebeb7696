#include "recognition/recognizer/model_slot.h"

#include "place_recognition/error.h"
#include "place_recognition/model_file.h"

namespace place_recognition {

void ModelSlot::load(const std::string& name) {
  const std::lock_guard<std::mutex> one_at_a_time(loading_);
  try {
    auto loaded = std::make_shared<const Model>(loadModel(namedModelPath(name)));
    const std::lock_guard<std::mutex> lock(mutex_);
    model_ = std::move(loaded);
    name_ = name;
    problem_.clear();
  } catch (const std::exception& e) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!model_) name_ = name;
    problem_ = e.what();
    throw Error(problem_);
  }
}

void ModelSlot::reload() {
  std::string name;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    name = name_;
  }
  if (name.empty()) {
    throw Error("No model has been named yet; set the parameter ~model or call ~load_model.");
  }
  load(name);
}

std::shared_ptr<const Model> ModelSlot::model() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return model_;
}

std::string ModelSlot::problem() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return problem_;
}

}  // namespace place_recognition
