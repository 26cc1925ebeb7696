#include "base/cell_store.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "scratch_folder.h"

namespace place_recognition {
namespace {

TEST(CellStore, FindsWhatWasSavedAndNothingElse) {
  const ScratchFolder folder;
  const CellStore store(folder / "cells");
  store.save({{"gamma", 0.1}}, {{"rate", 0.75}});
  EXPECT_EQ(CellStore(folder / "cells").find({{"gamma", 0.1}}), Json({{"rate", 0.75}}));
  EXPECT_FALSE(store.find({{"gamma", 0.2}}).has_value());
}

TEST(CellStore, DamagedCellIsAsIfAbsent) {
  const ScratchFolder folder;
  const CellStore store(folder / "cells");
  const Json key = {{"gamma", 0.1}};
  store.save(key, 1);
  const auto file = std::filesystem::directory_iterator(folder / "cells")->path();
  for (const char* content : {"", "{\"key\": {\"gamma\": 0.1}, \"res", "[1, 2]",
                              "{\"key\": {\"gamma\": 0.2}, \"result\": 1}"}) {
    std::ofstream(file) << content;
    EXPECT_FALSE(store.find(key).has_value()) << content;
  }
  store.save(key, 2);
  EXPECT_EQ(store.find(key), Json(2));
}

}  // namespace
}  // namespace place_recognition
