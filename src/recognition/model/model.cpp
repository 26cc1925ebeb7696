#include "place_recognition/model.h"

namespace place_recognition {

std::size_t Model::supportVectorCount() const {
  std::size_t count = 0;
  for (const Classifier& classifier : classifiers) count += classifier.supportVectorCount();
  return count;
}

}  // namespace place_recognition
