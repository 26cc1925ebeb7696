#pragma once

#include <cstdint>
#include <string>

#include "place_recognition/model.h"

namespace place_recognition {

/// A model as the bytes of a `.places` file: magic, format version, lengths and checksums, then the
/// protobuf message of src/recognition/model.proto, then the classifiers' numbers as they are used
/// and the networks of its embeddings. Equal models give equal bytes.
std::string serializeModel(const Model& model);

/// The model in `bytes`; `where` names their source in messages. Throws Error, saying what is
/// wrong, for anything that serializeModel() did not write: foreign, cut or changed bytes, counts
/// and ranges that do not agree, numbers that are not finite. Sets version.
Model parseModel(const std::string& bytes, const std::string& where);

/// Saves atomically, also beside others that save to the same path; creates the folder if it is
/// missing. The models that were there before stay as backups. Sets nothing in `model`. Returns the
/// number of bytes written.
std::uint64_t saveModel(const Model& model, const std::string& path);

/// Loads and checks a model file; sets name and version.
Model loadModel(const std::string& path);

/// Whether the file at `path` starts as a model does, whatever its name.
bool startsAsModel(const std::string& path);

/// How many models that were saved to the same path before are kept.
constexpr int kModelBackups = 3;

/// Where the backup of the model at `path` is; `age` 1: the newest, to kModelBackups: the oldest.
std::string backupPath(const std::string& path, int age);

/// Puts a backup in the place of the model at `path`, which becomes the newest backup itself.
/// Throws Error, changing nothing, if there is no such backup or it cannot be used.
void restoreModel(const std::string& path, int age);

/// The path of a model by name: NAME itself, without "file://", if it has a slash or ends in
/// `.places`, else modelFolder()/NAME.places. Throws Error for a name that is not
/// [A-Za-z0-9_-]{1,64}.
std::string modelPath(const std::string& name);

/// Like modelPath(), for names from the network: only [A-Za-z0-9_-]{1,64}, only in modelFolder().
std::string namedModelPath(const std::string& name);

/// $ROS_HOME/place_recognition/models, or ~/.ros/place_recognition/models.
std::string modelFolder();

}  // namespace place_recognition
