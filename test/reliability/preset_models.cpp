#include "reliability/preset_models.h"

#include <algorithm>
#include <filesystem>

#include "base/options.h"
#include "features/small_network.h"
#include "place_recognition/model_file.h"
#include "recognition/drawn_recording.h"
#include "recognition/model/embeddings.h"

namespace place_recognition {
namespace {

std::vector<std::string> presetFiles() {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(PLACE_RECOGNITION_PRESETS)) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

TrainingOptions crfh() {
  const std::string file = PLACE_RECOGNITION_PRESETS "/crfh.yaml";
  TrainingOptions options;
  readOptions(readYamlFile(file), file, options);
  return options;
}

}  // namespace

std::vector<TrainingOptions> presets() {
  std::vector<TrainingOptions> all;
  for (const std::string& file : presetFiles()) {
    readOptions(readYamlFile(file), file, all.emplace_back());
    for (EmbeddingOptions* embedding : embeddingsOf(all.back())) {
      embedding->loaded = SmallNetwork::network();
      if (embedding->stride > 0) embedding->stride = 2;
      embedding->dimension =
          embedding->stride > 0 ? SmallNetwork::kEarlyDimension : SmallNetwork::kDimension;
    }
  }
  for (const char* kernel : {"gaussian", "intersection", "linear", "polynomial", "sigmoid"}) {
    all.push_back(crfh());
    all.back().cues[0].kernel.type = kernel;
  }
  all.push_back(crfh());
  all.back().svm.multiclass = "one-against-one";
  return all;
}

std::vector<std::string> trainPresets(const std::vector<Frame>& frames) {
  std::vector<std::string> models;
  for (const TrainingOptions& options : presets()) {
    models.push_back(serializeModel(train({opener(frames)}, options).model));
  }
  return models;
}

const std::vector<std::string>& presetModels() {
  static const std::vector<std::string> models = trainPresets(drawFrames(3, 8));
  return models;
}

}  // namespace place_recognition
