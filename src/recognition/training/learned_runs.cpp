#include "recognition/training/learned_runs.h"

#include <algorithm>
#include <filesystem>

namespace place_recognition {
namespace {

namespace fs = std::filesystem;

fs::path normalized(const std::string& path) {
  const fs::path normal = fs::absolute(path).lexically_normal();
  return normal.has_filename() ? normal : normal.parent_path();
}

}  // namespace

bool isTrainedOn(const Provenance& provenance, const std::string& input) {
  return std::any_of(
      provenance.inputs.begin(), provenance.inputs.end(),
      [&](const std::string& trained) { return normalized(trained) == normalized(input); });
}

}  // namespace place_recognition
