#include "base/cell_store.h"

#include <filesystem>

#include "base/atomic_file.h"
#include "base/sha256.h"
#include "place_recognition/error.h"

namespace place_recognition {
namespace {

constexpr std::size_t kMaxCellBytes = 64 << 20;

}  // namespace

CellStore::CellStore(const std::string& folder) : folder_(folder) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) {
    throw Error("Cannot make the folder " + folder + ": " + failure.message() +
                "; choose one that can be written.");
  }
}

std::string CellStore::pathOf(const Json& key) const {
  return folder_ + "/" + sha256(key.dump()) + ".json";
}

std::optional<Json> CellStore::find(const Json& key) const {
  const std::string path = pathOf(key);
  if (!std::filesystem::exists(path)) return std::nullopt;
  const Json cell = Json::parse(readFile(path, kMaxCellBytes), nullptr, false);
  // Another key with the same hash, or a damaged file, counts as a missing result.
  const bool is_it = cell.is_object() && cell.contains("key") && cell["key"] == key;
  if (!is_it || !cell.contains("result")) return std::nullopt;
  return cell["result"];
}

void CellStore::save(const Json& key, const Json& result) const {
  writeFileAtomically(pathOf(key), Json{{"key", key}, {"result", result}}.dump(1) + "\n");
}

}  // namespace place_recognition
