#include "base/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include "place_recognition/error.h"

namespace place_recognition {
namespace {

namespace fs = std::filesystem;

class AtomicFile : public testing::Test {
 protected:
  AtomicFile() {
    std::string pattern = (fs::temp_directory_path() / "atomic_file_XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
    path_ = (folder_ / "file").string();
  }
  ~AtomicFile() override { fs::remove_all(folder_); }

  std::size_t filesInFolder() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  fs::path folder_;
  std::string path_;
};

TEST_F(AtomicFile, ReadsBackWhatWasWritten) {
  const std::string bytes("a\0b\xff", 4);
  writeFileAtomically(path_, "old");
  writeFileAtomically(path_, bytes);
  EXPECT_EQ(readFile(path_, 4), bytes);
  EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(AtomicFile, FollowsTheUmask) {
  const mode_t before = umask(027);
  writeFileAtomically(path_, "x");
  umask(before);
  struct stat status;
  ASSERT_EQ(stat(path_.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0640u);
}

TEST_F(AtomicFile, RefusesWhatCannotBeReadOrWritten) {
  EXPECT_THROW(readFile(path_, 10), Error);
  EXPECT_THROW(readFile(folder_.string(), 10), Error);
  writeFileAtomically(path_, "12345");
  EXPECT_THROW(readFile(path_, 4), Error);
  EXPECT_THROW(writeFileAtomically((folder_ / "no" / "such").string(), "x"), Error);
  EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(AtomicFile, LeavesNoTemporaryFileWhenTheLastStepFails) {
  // Renaming onto a folder fails after the bytes were written.
  fs::create_directories(fs::path(path_) / "inside");
  EXPECT_THROW(writeFileAtomically(path_, "x"), Error);
  EXPECT_EQ(filesInFolder(), 1u) << "the temporary file was left behind";
}

TEST_F(AtomicFile, IsWholeAfterKillAtAnyMoment) {
  const std::string versions[] = {std::string(300000, 'a'), std::string(200000, 'b')};
  writeFileAtomically(path_, versions[0]);
  for (int round = 0; round < 30; ++round) {
    const pid_t child = fork();
    if (child == 0) {
      for (int i = 0;; ++i) writeFileAtomically(path_, versions[i % 2]);
    }
    std::this_thread::sleep_for(std::chrono::microseconds(300 + 411 * round));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    const std::string bytes = readFile(path_, 1000000);
    EXPECT_TRUE(bytes == versions[0] || bytes == versions[1]) << "after round " << round;
  }
}

}  // namespace
}  // namespace place_recognition
