#pragma once

#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "model.pb.h"
#include "place_recognition/error.h"
#include "recognition/model/classifier_numbers.h"
#include "recognition/model/model_container.h"

namespace place_recognition {

/// The contents of a model file.
struct ModelContents {
  proto::Model message;
  std::vector<ClassifierNumbers> classifiers;
  std::vector<std::vector<char>> networks;  // one per `embedding` cue
};

/// Returns the model file `bytes` with changed contents and a matching header.
inline std::string tampered(const std::string& bytes,
                            const std::function<void(ModelContents&)>& change) {
  std::istringstream file(bytes);
  ContainerReader reader(file);
  ModelContents contents;
  if (!contents.message.ParseFromString(reader.message())) throw Error("no model");
  contents.classifiers.resize(static_cast<std::size_t>(contents.message.cue_weights_size()));
  for (ClassifierNumbers& classifier : contents.classifiers) classifier.visit(reader);
  contents.networks.resize(static_cast<std::size_t>(contents.message.embedding_dimensions_size()));
  for (std::vector<char>& network : contents.networks) reader(network);
  reader.finish();

  change(contents);

  NumberWriter numbers;
  for (ClassifierNumbers& classifier : contents.classifiers) classifier.visit(numbers);
  for (const std::vector<char>& network : contents.networks) numbers(network);
  return packContainer(contents.message.SerializeAsString(), numbers.bytes());
}

}  // namespace place_recognition
