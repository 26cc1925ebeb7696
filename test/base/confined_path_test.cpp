// Every attempt of an attacker to leave the folders of bags.

#include "base/confined_path.h"

#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/stat.h>

#include <filesystem>
#include <string>

#include "error_of.h"
#include "place_recognition/error.h"
#include "scratch_folder.h"

namespace place_recognition {
namespace {

namespace fs = std::filesystem;

class ConfinedPaths : public testing::Test {
 protected:
  ConfinedPaths() {
    for (const char* folder : {"bags/deep", "bags2", "elsewhere"}) {
      fs::create_directories(scratch_ / folder);
    }
    for (const char* bag : {"bags/a.bag", "bags/deep/b.bag", "bags2/c.bag", "elsewhere/d.bag"}) {
      scratch_.write(bag, "");
    }
    scratch_.write("bags/notes.txt", "");
  }

  std::string confined(const std::string& path) { return confinedBagPath(path, {root_}); }

  std::string errorIn(const std::string& path) {
    return errorOf([&] { confined(path); });
  }

  void expectSays(const std::string& path, const std::vector<std::string>& parts) {
    const std::string error = errorIn(path);
    EXPECT_NE(error, "") << path;
    for (const std::string& part : parts) {
      EXPECT_NE(error.find(part), std::string::npos) << part << " in: " << error;
    }
  }

  ScratchFolder scratch_;
  const std::string root_ = scratch_ / "bags";
};

TEST_F(ConfinedPaths, BagsBelowTheRootArePassed) {
  EXPECT_EQ(confined(root_ + "/a.bag"), root_ + "/a.bag");
  EXPECT_EQ(confined("a.bag"), root_ + "/a.bag");
  EXPECT_EQ(confined("deep/../deep//b.bag"), root_ + "/deep/b.bag");
  EXPECT_EQ(confined(root_ + "/../bags/a.bag"), root_ + "/a.bag");
}

TEST_F(ConfinedPaths, EveryOtherRootIsTried) {
  EXPECT_EQ(confinedBagPath("c.bag", {scratch_ / "none", root_, scratch_ / "bags2"}),
            scratch_ / "bags2/c.bag");
}

TEST_F(ConfinedPaths, WaysOutAreClosed) {
  fs::create_symlink(scratch_ / "elsewhere/d.bag", root_ + "/link.bag");
  fs::create_directory_symlink(scratch_ / "elsewhere", root_ + "/linked");
  for (const std::string& path :
       {scratch_ / "elsewhere/d.bag", scratch_ / "bags2/c.bag", std::string("../elsewhere/d.bag"),
        root_ + "/../elsewhere/d.bag", std::string("link.bag"), std::string("linked/d.bag"),
        std::string("/etc/passwd"), std::string("notes.txt"), std::string("deep"), std::string(),
        std::string("."), std::string("a.bag\0", 6), std::string("../elsewhere/d.bag\0.bag", 23),
        std::string(1 << 20, 'a'), std::string("--help.bag")}) {
    EXPECT_THROW(confined(path), Error) << path.substr(0, 80);
  }
}

TEST_F(ConfinedPaths, LinksThatStayInsideAreFollowed) {
  fs::create_symlink(root_ + "/deep/b.bag", root_ + "/link.bag");
  EXPECT_EQ(confined("link.bag"), root_ + "/deep/b.bag");
}

TEST_F(ConfinedPaths, ARootMayBeALink) {
  fs::create_directory_symlink(root_, scratch_ / "disk");
  EXPECT_EQ(confinedBagPath(scratch_ / "disk/a.bag", {scratch_ / "disk"}), root_ + "/a.bag");
}

TEST_F(ConfinedPaths, MessagesTellNothingOfOtherFiles) {
  const std::string there = scratch_ / "elsewhere/d.bag";
  const std::string missing = scratch_ / "elsewhere/e.bag";
  std::string message = errorIn(there);
  message.replace(message.find(there), there.size(), missing);
  EXPECT_EQ(message, errorIn(missing));
}

TEST_F(ConfinedPaths, TheRefusalSaysWhatLiesBelowTheRootInstead) {
  expectSays("deep", {"'deep' is a folder; name the bags in it"});
  expectSays(root_ + "/notes.txt", {"notes.txt' does not end in .bag"});
  ASSERT_EQ(mkfifo((root_ + "/pipe.bag").c_str(), 0666), 0);
  expectSays("pipe.bag", {"is a pipe or a device"});
  for (const std::string& bag : {std::string("missing.bag"), root_ + "/deep/missing.bag"}) {
    expectSays(bag, {"'" + bag + "' does not exist below " + root_ + "; check the path."});
  }
  expectSays("/etc", {"is not a bag (*.bag) below " + root_});  // nothing about files elsewhere
  expectSays("..", {"is not a bag (*.bag) below " + root_});
}

TEST_F(ConfinedPaths, TheRefusalNamesTheBagThatIsMeant) {
  scratch_.write("bags/killed.bag.active", "");
  scratch_.write("elsewhere/killed.bag.active", "");
  fs::create_symlink("gone.bag", root_ + "/broken.bag");
  for (const std::string& bag : {std::string("killed.bag"), root_ + "/killed.bag"}) {
    const std::string active = root_ + "/killed.bag.active";
    expectSays(bag,
               {"'" + bag + "' does not exist; " + active + " lies beside it: ",
                "run: rosbag reindex " + active + ", and rename it to " + root_ + "/killed.bag"});
  }
  expectSays("killed", {root_ + "/killed.bag.active lies beside it: "});
  expectSays("deep/b", {"; give " + root_ + "/deep/b.bag, which lies beside it."});
  expectSays("broken.bag", {"'broken.bag' is a broken link; check " + root_ + "/gone.bag."});
  const std::string secret = scratch_ / "elsewhere/killed.bag";
  expectSays(secret, {"'" + secret + "' is not a bag (*.bag) below " + root_ + "; move it there"});
}

TEST_F(ConfinedPaths, TheRefusalSaysWhereALinkLeads) {
  const std::string elsewhere = scratch_ / "elsewhere";
  fs::create_directory_symlink(elsewhere, root_ + "/linked");
  fs::create_directory_symlink("linked", root_ + "/twice");
  fs::create_directory_symlink("../../elsewhere", root_ + "/deep/relative");
  fs::create_symlink(elsewhere + "/d.bag", root_ + "/link.bag");
  fs::create_symlink(scratch_ / "gone/d.bag", root_ + "/dangling.bag");
  const std::string remedy = "add " + elsewhere + " to ~bag_roots";
  // The same message whether the bag exists or not.
  for (const std::string bag : {"d.bag", "missing.bag", "sub/d.bag"}) {
    expectSays("linked/" + bag, {root_ + "/linked, which leads to " + elsewhere + ",", remedy});
    expectSays(root_ + "/linked/" + bag, {root_ + "/linked", remedy});
  }
  expectSays("twice/d.bag", {root_ + "/twice", "leads to " + elsewhere + ",", remedy});
  expectSays("deep/relative/d.bag", {root_ + "/deep/relative, which leads to " + elsewhere});
  expectSays("link.bag", {root_ + "/link.bag", "leads to " + elsewhere + "/d.bag", remedy});
  expectSays("dangling.bag", {root_ + "/dangling.bag", "leads to " + (scratch_ / "gone/d.bag")});
  const std::string around = "deep/../dangling.bag";
  expectSays(around, {"'" + around + "' is not a bag (*.bag) below " + root_});
  // Leaving by "..", or a path outside, is not explained.
  expectSays("linked/../../elsewhere/d.bag", {"is not a bag (*.bag) below " + root_});
  expectSays(elsewhere + "/d.bag", {"is not a bag (*.bag) below " + root_});
}

TEST_F(ConfinedPaths, ALinkBetweenRootsIsFollowed) {
  fs::create_directory_symlink(scratch_ / "bags2", root_ + "/linked");
  EXPECT_EQ(confinedBagPath("linked/c.bag", {root_, scratch_ / "bags2"}), scratch_ / "bags2/c.bag");
}

TEST_F(ConfinedPaths, ATildeIsTheHomeFolder) {
  setenv("HOME", root_.c_str(), 1);
  EXPECT_EQ(confined("~/a.bag"), root_ + "/a.bag");
  EXPECT_EQ(confined("$HOME/a.bag"), root_ + "/a.bag");
  EXPECT_EQ(confined("${HOME}/a.bag"), root_ + "/a.bag");
  EXPECT_EQ(defaultBagRoots().front(), root_);
}

}  // namespace
}  // namespace place_recognition
