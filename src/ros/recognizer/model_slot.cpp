#include "ros/recognizer/model_slot.h"

#include <utility>

#include "place_recognition/error.h"
#include "place_recognition/model_file.h"

namespace place_recognition {

ModelSlot::Loaded ModelSlot::read(const std::string& name) {
  try {
    return {name, std::make_shared<const Model>(loadModel(namedModelPath(name)))};
  } catch (const std::exception& e) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!model_) name_ = name;
    problem_ = e.what();
    throw Error(problem_);
  }
}

ModelSlot::Loaded ModelSlot::readAgain() {
  std::string name;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    name = name_;
  }
  if (name.empty()) {
    throw Error("No model has been named yet; set the parameter ~model or call ~load_model.");
  }
  return read(name);
}

void ModelSlot::use(Loaded loaded) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool is_same = model_ && name_ == loaded.name && !model_->version.empty() &&
                       model_->version == loaded.model->version;
  if (!is_same) model_ = std::move(loaded.model);
  name_ = std::move(loaded.name);
  problem_.clear();
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
