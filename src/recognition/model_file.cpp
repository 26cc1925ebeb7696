#include "place_recognition/model_file.h"

#include <filesystem>
#include <limits>
#include <system_error>

#include "base/atomic_file.h"
#include "place_recognition/error.h"
#include "recognition/model_container.h"
#include "recognition/model_message.h"

namespace place_recognition {
namespace {

namespace fs = std::filesystem;

constexpr int kBackups = 3;
constexpr std::size_t kMaxFileSize = std::numeric_limits<int>::max();  // protobuf's own limit

fs::path backupPath(const std::string& path, int age) { return path + "." + std::to_string(age); }

/// Makes the file at `path` also its newest backup, NAME.1, and the backups one older. Renames and
/// a hard link only: whenever this is cut off, `path` itself has not been touched. Where it is its
/// own newest backup already, because saving failed after this, there is nothing to do. What fails
/// here is not worth losing a training for.
void keepBackup(const std::string& path) {
  std::error_code ignored;
  if (!fs::exists(path, ignored) || fs::equivalent(path, backupPath(path, 1), ignored)) return;
  for (int age = kBackups; age > 1; --age) {
    fs::rename(backupPath(path, age - 1), backupPath(path, age), ignored);
  }
  std::error_code no_link;
  fs::create_hard_link(path, backupPath(path, 1), no_link);
  if (no_link) fs::copy_file(path, backupPath(path, 1), ignored);
}

}  // namespace

std::string serializeModel(const Model& model) {
  const proto::Model message = toMessage(model);
  if (message.ByteSizeLong() >= kMaxFileSize) {
    throw Error("The model would be larger than 2 GB; train on fewer images or reduce it.");
  }
  return packContainer(message.SerializeAsString());
}

Model parseModel(const std::string& bytes, const std::string& where) {
  const std::string_view payload = unpackContainer(bytes, where);
  proto::Model message;
  if (payload.size() >= kMaxFileSize ||
      !message.ParseFromArray(payload.data(), static_cast<int>(payload.size()))) {
    throw Error("The model " + where +
                " is not of the form that this program writes; restore a "
                "backup or train the model again.");
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
  keepBackup(path);
  writeFileAtomically(path, bytes);
  return bytes.size();
}

Model loadModel(const std::string& path) {
  const std::string bytes = readFile(path, kMaxFileSize);
  Model model = parseModel(bytes, path);
  model.name = fs::path(path).stem().string();
  model.version = containerVersion(bytes);
  return model;
}

}  // namespace place_recognition
