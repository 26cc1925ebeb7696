#include "place_recognition/model_file.h"

#include <filesystem>
#include <system_error>

#include "base/atomic_file.h"
#include "place_recognition/error.h"
#include "recognition/message_entries.h"
#include "recognition/model_backups.h"
#include "recognition/model_container.h"
#include "recognition/model_message.h"

namespace place_recognition {

namespace fs = std::filesystem;

std::string serializeModel(const Model& model) {
  const proto::Model message = toMessage(model);
  if (message.ByteSizeLong() >= kMaxModelBytes) {
    throw Error("The model would be larger than 2 GB; train on fewer images or reduce it.");
  }
  return packContainer(message.SerializeAsString());
}

Model parseModel(const std::string& bytes, const std::string& where) {
  const std::string_view payload = unpackContainer(bytes, where);
  proto::Model message;
  if (payload.size() >= kMaxModelBytes || !hasFewEntries(payload) ||
      !message.ParseFromArray(payload.data(), static_cast<int>(payload.size()))) {
    throw Error("The model " + where +
                " is not of the form that this program writes; restore a backup (place_tool "
                "restore) or train the model again.");
  }
  return fromMessage(message, where);
}

std::uint64_t saveModel(const Model& model, const std::string& path) {
  const std::string bytes = serializeModel(model);
  const fs::path folder = fs::path(path).parent_path();
  std::error_code failure;
  if (!folder.empty()) fs::create_directories(folder, failure);
  if (failure) {
    throw Error("Cannot make the folder " + folder.string() + ": " + failure.message() +
                "; choose one that can be written.");
  }
  replaceKeepingBackups(path, bytes);
  return bytes.size();
}

Model loadModel(const std::string& path) {
  const std::string bytes = readFile(path, kMaxModelBytes);
  Model model = parseModel(bytes, path);
  model.name = fs::path(path).stem().string();
  model.version = containerVersion(bytes);
  return model;
}

void restoreModel(const std::string& path, int age) {
  const std::string backup = backupPath(path, age);
  const std::string bytes = readFile(backup, kMaxModelBytes);
  parseModel(bytes, backup);
  replaceKeepingBackups(path, bytes);
}

}  // namespace place_recognition
