#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace place_recognition {

using Json = nlohmann::json;

/// A folder of finished results, one small file each, named after a hash of what determines the
/// result. Files appear whole or not at all, so several processes and machines may share a folder.
class CellStore {
 public:
  /// Makes the folder. Throws Error if it cannot.
  explicit CellStore(const std::string& folder);

  /// The result of the cell that `key` describes, if it is there and undamaged.
  std::optional<Json> find(const Json& key) const;

  /// Throws Error if the disk refuses.
  void save(const Json& key, const Json& result) const;

 private:
  std::string pathOf(const Json& key) const;

  std::string folder_;
};

}  // namespace place_recognition
