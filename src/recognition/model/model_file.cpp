#include "place_recognition/model_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>
#include <vector>

#include "base/atomic_file.h"
#include "base/bag_name.h"
#include "base/nearest_name.h"
#include "base/text.h"
#include "features/feature_extractor.h"
#include "place_recognition/error.h"
#include "recognition/model/classifier_numbers.h"
#include "recognition/model/embeddings.h"
#include "recognition/model/model_backups.h"
#include "recognition/model/model_container.h"
#include "recognition/model/model_message.h"

namespace place_recognition {

namespace fs = std::filesystem;

namespace {

/// A network of no bytes is that of the embedding before it.
void readNetworks(ContainerReader& reader, Model& model) {
  std::shared_ptr<const Network> before;
  for (EmbeddingOptions* embedding : embeddingsOf(model.options)) {
    Network network = *embedding->loaded;
    std::vector<char> onnx;
    reader(onnx);
    network.onnx.assign(onnx.begin(), onnx.end());
    if (onnx.empty() && before && before->sha256 == network.sha256) {
      embedding->loaded = before;
    } else {
      embedding->loaded = std::make_shared<const Network>(std::move(network));
    }
    before = embedding->loaded;
  }
}

/// Throws Error saying what is wrong, but not where.
Model readModel(std::istream& file) {
  ContainerReader reader(file);
  proto::Model message;
  if (!message.ParseFromString(reader.message())) {
    throw Error("it does not have the form that this program writes");
  }
  Model model = fromMessage(message);
  std::vector<ClassifierNumbers> numbers(model.options.cues.size());
  for (ClassifierNumbers& classifier : numbers) classifier.visit(reader);
  readNetworks(reader, model);
  reader.finish();
  for (std::size_t c = 0; c < numbers.size(); ++c) {
    model.classifiers.push_back(classifierOf(std::move(numbers[c]), model, c));
  }
  for (const EmbeddingOptions* embedding : embeddingsOf(model.options)) {
    makeFeatureExtractor(*embedding);  // throws if this machine cannot run the network
  }
  model.version = reader.version();
  return model;
}

Model readModel(std::istream& file, const std::string& where) {
  try {
    return readModel(file);
  } catch (const Error& e) {
    throw Error("The model " + where + " cannot be used (" + e.what() +
                "); restore a backup (place_tool restore) or train the model again.");
  }
}

/// Anything other than a file, such as a named pipe, must not even be opened.
bool isOther(const std::string& path) {
  std::error_code ignored;
  return fs::exists(path, ignored) && !fs::is_regular_file(path, ignored);
}

/// What to do if there is no model at `path`; a phrase that ends a sentence.
std::string remedyForMissing(const std::string& path) {
  const fs::path file(path), folder = file.parent_path();
  const bool is_named = folder == modelFolder();
  std::error_code ignored;
  if (is_named && fs::exists(file.filename(), ignored)) {
    return "for the file in this folder, give ./" + file.filename().string() + ".";
  }
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, ignored)) {
    const fs::path& other = entry.path();
    if (other.extension() == file.extension()) names.push_back(other.stem().string());
  }
  const std::string nearest = nearestName(file.stem().string(), names);
  if (nearest.empty()) return "check the name.";
  const fs::path meant = (folder / nearest).concat(file.extension().string());
  return "did you mean " + (is_named ? nearest : meant.string()) + "?";
}

std::ifstream openFile(const std::string& path) {
  if (isOther(path)) throw Error("Cannot read " + path + ": not a file; check the name.");
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    const int failure = errno;
    const std::string remedy = failure == ENOENT ? remedyForMissing(path) : "check the name.";
    throw Error("Cannot read " + path + ": " + std::strerror(failure) + "; " + remedy);
  }
  return file;
}

/// Throws Error, saying what there is instead, unless the model at `path` has such a backup.
void requireBackup(const std::string& path, int age) {
  std::error_code ignored;
  if (fs::exists(backupPath(path, age), ignored)) return;
  for (int other = 1; other <= kModelBackups; ++other) {
    if (!fs::exists(backupPath(path, other), ignored)) continue;
    throw Error("The model " + path + " has no backup " + std::to_string(age) +
                "; place_tool restore --list shows those that it has.");
  }
  if (fs::exists(path, ignored)) {
    throw Error("The model " + path +
                " has no earlier version to restore, because it has not been replaced yet.");
  }
  throw Error("There is no model " + path + ", nor a backup of it; " + remedyForMissing(path));
}

/// A model that cannot be loaded must not replace one that can.
void requireLoadable(const std::string& bytes, const std::string& path) {
  try {
    std::istringstream file(bytes);
    readModel(file);
  } catch (const Error& e) {
    throw Error("The model was not saved to " + path + " because it could not be used (" +
                e.what() + "); check its options, especially those of the kernels.");
  }
}

}  // namespace

std::string serializeModel(const Model& model) {
  NumberWriter writer;
  for (const Classifier& classifier : model.classifiers) numbersOf(classifier).visit(writer);
  std::shared_ptr<const Network> before;
  for (const EmbeddingOptions* embedding : embeddingsOf(model.options)) {
    writer(embedding->loaded == before ? std::string() : embedding->loaded->onnx);
    before = embedding->loaded;
  }
  return packContainer(toMessage(model).SerializeAsString(), writer.bytes());
}

Model parseModel(const std::string& bytes, const std::string& where) {
  std::istringstream file(bytes);
  return readModel(file, where);
}

std::uint64_t saveModel(const Model& model, const std::string& path) {
  const std::string bytes = serializeModel(model);
  requireLoadable(bytes, path);
  const fs::path folder = fs::path(behindLinks(path)).parent_path();
  std::error_code failure;
  if (!folder.empty()) fs::create_directories(folder, failure);
  if (failure) {
    throw Error("Cannot create the folder " + folder.string() + ": " + failure.message() +
                "; choose a writable one.");
  }
  replaceKeepingBackups(path, bytes);
  return bytes.size();
}

Model loadModel(const std::string& path) {
  if (hasBagName(path) && !startsAsModel(path)) {
    throw Error(inQuotes(path) + " is a bag, not a model; give the name of a model.");
  }
  std::ifstream file = openFile(path);
  Model model = readModel(file, path);
  model.name = fs::path(path).stem().string();
  return model;
}

bool startsAsModel(const std::string& path) {
  if (isOther(path)) return false;
  std::ifstream file(path, std::ios::binary);
  return startsAsContainer(file);
}

void restoreModel(const std::string& path, int age) {
  requireBackup(path, age);
  restoreBackup(path, age);
}

}  // namespace place_recognition
