// Saving a model under kill -9, on full and read-only disks, and with concurrent writers.

#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <functional>
#include <limits>
#include <random>
#include <thread>

#include "base/atomic_file.h"
#include "place_recognition/error.h"
#include "place_recognition/model_file.h"
#include "recognition/drawn_recording.h"
#include "rounds.h"
#include "scratch_folder.h"

namespace place_recognition {
namespace {

namespace fs = std::filesystem;

/// Models that differ in their number of rooms, 2 to 5.
const Model& modelOf(int rooms) {
  static const std::vector<Training> trainings = [] {
    std::vector<Training> all;
    for (int i = 2; i <= 5; ++i) all.push_back(train({opener(drawFrames(i, 8))}, quickOptions()));
    return all;
  }();
  return trainings[static_cast<std::size_t>(rooms - 2)].model;
}

class Saving : public testing::Test {
 protected:
  std::size_t roomsIn(const std::string& path) const { return loadModel(path).places.size(); }

  std::size_t filesInFolder(const std::string& folder) const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
  }

  /// Expects that the model and all its existing backups can be loaded.
  void expectAllWhole() const {
    EXPECT_NO_THROW(loadModel(path_));
    for (int age = 1; age <= kModelBackups; ++age) {
      const std::string backup = backupPath(path_, age);
      if (!fs::exists(backup)) continue;
      EXPECT_NO_THROW(loadModel(backup)) << backup;
    }
  }

  /// A process that alternately saves models of 2 and 3 rooms, `times` times.
  pid_t startSaving(int times) const {
    const Model& first = modelOf(2);
    const Model& second = modelOf(3);
    const pid_t child = fork();
    if (child != 0) return child;
    for (int i = 0; i < times; ++i) saveModel(i % 2 == 0 ? first : second, path_);
    _exit(0);
  }

  ScratchFolder scratch_;
  const std::string path_ = scratch_ / "home.places";
};

TEST_F(Saving, LeavesTheOldOrTheNewModelWhenKilled) {
  saveModel(modelOf(2), path_);
  std::mt19937 random(1);
  for (int i = 0, count = rounds(30, 500); i < count; ++i) {
    const pid_t child = startSaving(std::numeric_limits<int>::max());
    std::this_thread::sleep_for(std::chrono::microseconds(500 + random() % 20000));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    expectAllWhole();
  }
  saveModel(modelOf(4), path_);
  EXPECT_EQ(roomsIn(path_), 4u);
  EXPECT_LE(filesInFolder(scratch_ / ""), 1u + kModelBackups)
      << "what was killed left files behind";
}

TEST_F(Saving, WritersOfOneNameWaitForEachOther) {
  constexpr int kTimes = 30;
  const pid_t writers[] = {startSaving(kTimes), startSaving(kTimes), startSaving(kTimes)};
  for (const pid_t writer : writers) {
    int status = -1;
    waitpid(writer, &status, 0);
    EXPECT_EQ(status, 0);
  }
  EXPECT_EQ(filesInFolder(scratch_ / ""), 1u + kModelBackups);
  expectAllWhole();
}

TEST_F(Saving, ThatFailsChangesNothing) {
  for (int rooms = 2; rooms <= 4; ++rooms) saveModel(modelOf(rooms), path_);
  // Writing beyond a limit fails part way, as on a full disk.
  rlimit before;
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{1000, before.rlim_max};
  signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &small);
  EXPECT_THROW(saveModel(modelOf(5), path_), Error);
  setrlimit(RLIMIT_FSIZE, &before);
  signal(SIGXFSZ, SIG_DFL);
  EXPECT_EQ(roomsIn(path_), 4u);
  EXPECT_EQ(roomsIn(backupPath(path_, 1)), 3u);
  EXPECT_EQ(roomsIn(backupPath(path_, 2)), 2u);
  EXPECT_EQ(filesInFolder(scratch_ / ""), 3u);
}

/// A small separate disk, which only root can create.
class SmallDisk {
 public:
  explicit SmallDisk(const std::string& folder) : folder_(folder) {
    fs::create_directories(folder);
    mounted_ = mount("tmpfs", folder.c_str(), "tmpfs", 0, "size=256k") == 0;
  }
  ~SmallDisk() {
    if (mounted_) umount2(folder_.c_str(), MNT_DETACH);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

  bool mounted() const { return mounted_; }
  bool makeReadOnly() const {
    return mount("tmpfs", folder_.c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, "size=256k") == 0;
  }

 private:
  std::string folder_;
  bool mounted_ = false;
};

TEST_F(Saving, OnAFullDiskKeepsTheOldModel) {
  const SmallDisk disk(scratch_ / "disk");
  if (!disk.mounted()) GTEST_SKIP() << "a small disk can be made by root only";
  const std::string path = scratch_ / "disk/home.places";
  saveModel(modelOf(2), path);
  scratch_.write("disk/filler", std::string(1 << 20, 'x'));
  EXPECT_THROW(saveModel(modelOf(3), path), Error);
  EXPECT_EQ(roomsIn(path), 2u);
  EXPECT_EQ(filesInFolder(scratch_ / "disk"), 2u);
  fs::remove(scratch_ / "disk/filler");
  saveModel(modelOf(3), path);
  EXPECT_EQ(roomsIn(path), 3u);
  EXPECT_EQ(roomsIn(backupPath(path, 1)), 2u);
}

TEST_F(Saving, OnAReadOnlyDiskKeepsTheOldModel) {
  const SmallDisk disk(scratch_ / "disk");
  const std::string path = scratch_ / "disk/home.places";
  saveModel(modelOf(2), path);
  const bool read_only = disk.mounted() ? disk.makeReadOnly() : geteuid() != 0;
  if (!read_only) GTEST_SKIP() << "root may write anywhere here";
  if (!disk.mounted())
    fs::permissions(scratch_ / "disk", fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_THROW(saveModel(modelOf(3), path), Error);
  EXPECT_EQ(roomsIn(path), 2u);
  if (!disk.mounted()) fs::permissions(scratch_ / "disk", fs::perms::owner_all);
}

TEST_F(Saving, EveryBackupCanBeRestored) {
  for (int rooms = 2; rooms <= 5; ++rooms) saveModel(modelOf(rooms), path_);
  restoreModel(path_, 3);
  EXPECT_EQ(roomsIn(path_), 2u);
  EXPECT_EQ(roomsIn(backupPath(path_, 1)), 5u);
  restoreModel(path_, 1);  // and back
  EXPECT_EQ(roomsIn(path_), 5u);
  EXPECT_EQ(roomsIn(backupPath(path_, 1)), 2u);
}

TEST_F(Saving, ABackupThatIsMissingOrDamagedIsNotRestored) {
  saveModel(modelOf(2), path_);
  EXPECT_THROW(restoreModel(path_, 1), Error);
  scratch_.write("home.places.1", "not a model");
  EXPECT_THROW(restoreModel(path_, 1), Error);
  EXPECT_EQ(roomsIn(path_), 2u);
  EXPECT_EQ(readFile(backupPath(path_, 1), 100), "not a model");
}

TEST_F(Saving, AModelThatIsReplacedWhileItIsReadIsReadWhole) {
  saveModel(modelOf(2), path_);
  const pid_t writer = startSaving(std::numeric_limits<int>::max());
  for (int i = 0, count = rounds(200, 5000); i < count; ++i) {
    const std::size_t rooms = roomsIn(path_);
    EXPECT_TRUE(rooms == 2 || rooms == 3);
  }
  kill(writer, SIGKILL);
  waitpid(writer, nullptr, 0);
}

}  // namespace
}  // namespace place_recognition
