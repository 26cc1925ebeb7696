#pragma once

#include <cstdint>
#include <string>

#include "place_recognition/model.h"

namespace place_recognition {

/// A model as the bytes of a `.places` file: magic, format version, lengths and checksums, then the
/// protobuf message of src/recognition/model/model.proto, then the classifiers' numbers in the
/// layout that recognition uses, then the networks of its embeddings. Equal models give equal
/// bytes.
std::string serializeModel(const Model& model);

/// Reads the model in `bytes`; `where` names their source in messages. Throws Error, stating what
/// is wrong, for anything that serializeModel() cannot have written: foreign, truncated or altered
/// bytes, inconsistent counts and ranges, numbers that are not finite. Sets version.
Model parseModel(const std::string& bytes, const std::string& where);

/// Saves atomically, even if others save to the same path; creates the folder if it is missing.
/// Earlier models at the path stay as backups. Does not modify `model`. Returns the number of bytes
/// written.
std::uint64_t saveModel(const Model& model, const std::string& path);

/// Loads and checks a model file; sets name and version.
Model loadModel(const std::string& path);

/// Whether the file at `path` begins like a model, whatever its name.
bool startsAsModel(const std::string& path);

/// Number of backups kept for each path.
constexpr int kModelBackups = 3;

/// Path of a backup of the model at `path`; `age` is 1 for the newest, kModelBackups for the
/// oldest.
std::string backupPath(const std::string& path, int age);

/// Replaces the model at `path` by a backup; the replaced model becomes the newest backup. Throws
/// Error, changing nothing, if there is no such backup or it cannot be used.
void restoreModel(const std::string& path, int age);

/// The path of a model by name: NAME itself, without "file://", if it contains a slash or ends in
/// `.places`, else modelFolder()/NAME.places. Throws Error for a name that is not
/// [A-Za-z0-9_-]{1,64}.
std::string modelPath(const std::string& name);

/// Like modelPath(), but for names from the network: only [A-Za-z0-9_-]{1,64}, only in
/// modelFolder().
std::string namedModelPath(const std::string& name);

/// $ROS_HOME/place_recognition/models, or ~/.ros/place_recognition/models.
std::string modelFolder();

}  // namespace place_recognition
