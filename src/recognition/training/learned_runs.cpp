#include "recognition/training/learned_runs.h"

#include <filesystem>

#include "base/sha256.h"

namespace place_recognition {
namespace {

namespace fs = std::filesystem;

fs::path normalized(const std::string& path) {
  const fs::path normal = fs::absolute(path).lexically_normal();
  return normal.has_filename() ? normal : normal.parent_path();
}

}  // namespace

std::string fingerprintOf(const Frame& first) {
  const cv::Mat image = first.image.isContinuous() ? first.image : first.image.clone();
  const std::string pixels(reinterpret_cast<const char*>(image.data),
                           image.total() * image.elemSize());
  return sha256(std::to_string(image.cols) + "x" + std::to_string(image.type()) + "@" +
                std::to_string(first.stamp) + ":" + pixels);
}

bool isTrainedOn(const Provenance& provenance, const std::string& input,
                 const std::string& fingerprint) {
  for (std::size_t i = 0; i < provenance.inputs.size(); ++i) {
    const std::string learned =
        i < provenance.fingerprints.size() ? provenance.fingerprints[i] : "";
    const bool same = learned.empty() || fingerprint.empty()
                          ? normalized(provenance.inputs[i]) == normalized(input)
                          : learned == fingerprint;
    if (same) return true;
  }
  return false;
}

bool isTrainedOn(const Model& model, Recording& recording) {
  recording.setLevelRange(model.images.levels);
  Frame frame;
  while (frame.image.empty() && recording.next(frame)) continue;
  return isTrainedOn(model.provenance, recording.name(),
                     frame.image.empty() ? "" : fingerprintOf(frame));
}

}  // namespace place_recognition
