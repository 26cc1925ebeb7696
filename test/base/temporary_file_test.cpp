// A file until it gets its name.

#include "base/temporary_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "base/atomic_file.h"
#include "base/text.h"
#include "error_of.h"
#include "scratch_folder.h"

namespace place_recognition {
namespace {

TEST(TemporaryFile, HasANameOfItsOwnAndIsRemoved) {
  const ScratchFolder scratch;
  {
    TemporaryFile one(scratch / ".net-", ".onnx", "net");
    TemporaryFile other(scratch / ".net-", ".onnx", "net");
    one.write("one");
    other.write("other");
    EXPECT_NE(one.path(), other.path());
    EXPECT_TRUE(endsWith(one.path(), ".onnx"));
    EXPECT_EQ(readFile(one.path(), 10), "one");
  }
  EXPECT_TRUE(std::filesystem::is_empty(scratch / "."));
}

TEST(TemporaryFile, ReplacesTheFileWhoseNameItIsGiven) {
  const ScratchFolder scratch;
  writeFileAtomically(scratch / "net", "old");
  {
    TemporaryFile file(scratch / ".net-", "", "net");
    file.write("new");
    file.rename(scratch / "net");
  }
  EXPECT_EQ(readFile(scratch / "net", 10), "new");
}

TEST(TemporaryFile, NamesItsTargetIfItCannotBeMade) {
  const ScratchFolder scratch;
  EXPECT_EQ(errorOf([&] { TemporaryFile(scratch / "no/.net-", "", "net"); }),
            "Cannot write net: No such file or directory; make room, or choose a writable folder.");
}

}  // namespace
}  // namespace place_recognition
