#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace place_recognition {

using Json = nlohmann::json;

/// A folder of finished results. Each is a small file, named by a hash of what determines the
/// result. Files are written atomically, so several processes and machines may share a folder.
class CellStore {
 public:
  /// Creates the folder; throws Error if that fails.
  explicit CellStore(const std::string& folder);

  /// The result stored for `key`, unless it is missing or damaged.
  std::optional<Json> find(const Json& key) const;

  /// Throws Error if the file cannot be written.
  void save(const Json& key, const Json& result) const;

 private:
  std::string pathOf(const Json& key) const;

  std::string folder_;
};

}  // namespace place_recognition
