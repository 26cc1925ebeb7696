// Which files of a folder are images of which room, and the warnings about the others.

#include "datasets/image_folder.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "place_recognition/error.h"
#include "scratch_folder.h"

namespace place_recognition {
namespace {

namespace fs = std::filesystem;

class ImageFolders : public testing::Test {
 protected:
  void touch(const std::string& path) {
    fs::create_directories(fs::path(scratch_ / path).parent_path());
    scratch_.write(path, "x");
  }

  FoundImages found() { return findRoomImages(scratch_ / "run"); }

  /// Returns "place: path below the run" for each image.
  std::vector<std::string> images() {
    std::vector<std::string> texts;
    for (const PlacedImage& image : found().images) {
      texts.push_back(image.place + ": " +
                      fs::path(image.path).lexically_relative(scratch_ / "run").string());
    }
    return texts;
  }

  /// Returns whether a warning contains all of `words`.
  bool warnsOf(const std::vector<std::string>& words) {
    const auto warnings = found().warnings;
    return std::any_of(warnings.begin(), warnings.end(), [&words](const std::string& warning) {
      return std::all_of(words.begin(), words.end(), [&warning](const std::string& word) {
        return warning.find(word) != std::string::npos;
      });
    });
  }

  ScratchFolder scratch_;
};

TEST_F(ImageFolders, AllEndingsInAnyCase) {
  for (const char* name : {"1.png", "2.JPG", "3.Jpeg", "4.webp", "5.BMP", "6.tif", "7.TIFF",
                           "8.pgm", "9.ppm", "10.jp2", "11.jpe", "12.jfif", "13.dib", "14.ras"}) {
    touch(std::string("run/hall/") + name);
  }
  touch("run/hall/notes.txt");
  EXPECT_EQ(found().images.size(), 14u);
  EXPECT_EQ(images().back(), "hall: hall/14.ras");
  EXPECT_TRUE(found().warnings.empty());
}

TEST_F(ImageFolders, WhatCameAlongIsPassedOverInSilence) {
  touch("run/hall/1.jpg");
  for (const char* path : {"run/hall/._1.jpg",
                           "run/._hall",
                           "run/__MACOSX/hall/._1.jpg",
                           "run/__MACOSX/hall/1.jpg",
                           "run/.DS_Store",
                           "run/hall/Thumbs.db",
                           "run/hall/desktop.ini",
                           "run/@eaDir/1.jpg/x.jpg",
                           "run/hall/@eaDir/1.jpg",
                           "run/.git/objects/1.jpg",
                           "run/.thumbnails/1.png",
                           "run/lost+found/1.jpg",
                           "run/$RECYCLE.BIN/1.jpg",
                           "run/hall/.cache/2.jpg",
                           "run/System Volume Information/1.jpg",
                           "run/#recycle/1.jpg",
                           "run/found.000/1.jpg",
                           "run/CVS/1.jpg",
                           "run/__pycache__/1.jpg",
                           "run/Network Trash Folder/1.jpg"}) {
    touch(path);
  }
  EXPECT_EQ(images(), std::vector<std::string>{"hall: hall/1.jpg"});
  EXPECT_TRUE(found().warnings.empty());
}

TEST_F(ImageFolders, ImagesOfARoomMayLieDeeper) {
  touch("run/hall/2024-05-31/1.jpg");
  touch("run/hall/2024-06-01/morning/1.jpg");
  touch("run/kitchen/2.jpg");
  EXPECT_EQ(images(), (std::vector<std::string>{"hall: hall/2024-05-31/1.jpg",
                                                "hall: hall/2024-06-01/morning/1.jpg",
                                                "kitchen: kitchen/2.jpg"}));
}

TEST_F(ImageFolders, FoldersThatGiveNothingAreNamedWithTheReason) {
  touch("run/hall/1.jpg");
  touch("run/office/1.HEIC");
  touch("run/office/2.heic");
  fs::create_directories(scratch_ / "run/attic");
  fs::create_symlink("nowhere", scratch_ / "run/cellar");
  touch("run/lab/notes.txt");
  EXPECT_EQ(found().images.size(), 1u);
  EXPECT_TRUE(warnsOf({"office", "2 .heic files"}));
  EXPECT_TRUE(warnsOf({"attic", "empty"}));
  EXPECT_TRUE(warnsOf({"cellar", "a broken link"}));
  EXPECT_TRUE(warnsOf({"lab", "1 .txt file"}));
}

TEST_F(ImageFolders, UnreadFormatsAmongOthersAreTold) {
  touch("run/hall/1.jpg");
  touch("run/hall/2.gif");
  touch("run/hall/3.dng");
  EXPECT_TRUE(warnsOf({"hall", "1 .gif file", "1 .dng file"}));
}

TEST_F(ImageFolders, LinksAreFollowedAndLoopsAreNot) {
  touch("store/hall/1.jpg");
  touch("store/2.jpg");
  fs::create_directories(scratch_ / "run/kitchen");
  fs::create_symlink(scratch_ / "store/hall", scratch_ / "run/hall");
  fs::create_symlink(scratch_ / "store/2.jpg", scratch_ / "run/kitchen/2.jpg");
  fs::create_symlink(scratch_ / "run", scratch_ / "run/kitchen/again");
  fs::create_symlink("self", scratch_ / "run/self");
  EXPECT_EQ(images(), (std::vector<std::string>{"hall: hall/1.jpg", "kitchen: kitchen/2.jpg"}));
  EXPECT_TRUE(warnsOf({"again", "leads back"}));
  EXPECT_TRUE(warnsOf({"self", "a broken link"}));
}

TEST_F(ImageFolders, OneRoomWrittenInTwoWaysIsOne) {
  touch(
      "run/K\xc3\xbc"
      "che/1.jpg");  // composed
  touch(
      "run/Ku\xcc\x88"
      "che /2.jpg");  // decomposed, with a blank
  for (const PlacedImage& image : found().images) {
    EXPECT_EQ(image.place,
              "K\xc3\xbc"
              "che");
  }
  EXPECT_EQ(found().images.size(), 2u);
}

TEST_F(ImageFolders, ARunIsToldFromAFolderOfRuns) {
  touch("runs/monday/hall/1.jpg");
  touch("dated/hall/2024-05-31/1.jpg");
  touch("dated/office/20240531_1200/1.jpg");
  touch("days/2024-05-31/hall/1.jpg");
  EXPECT_FALSE(holdsRoomImages(scratch_ / "runs"));
  EXPECT_TRUE(holdsRoomImages(scratch_ / "runs/monday"));
  EXPECT_TRUE(holdsRoomImages(scratch_ / "dated"));
  EXPECT_FALSE(holdsRoomImages(scratch_ / "days"));
  EXPECT_FALSE(holdsRoomImages(scratch_ / "nowhere"));
  touch("runs/map.png");  // among runs
  EXPECT_FALSE(holdsRoomImages(scratch_ / "runs"));
  touch("days/map.png");
  EXPECT_FALSE(holdsRoomImages(scratch_ / "days"));
  touch("runs/monday/1.jpg");  // among rooms
  EXPECT_TRUE(holdsRoomImages(scratch_ / "runs/monday"));
  EXPECT_TRUE(holdsRoomImages(scratch_ / "runs/monday/hall"));  // of one room
}

TEST_F(ImageFolders, NothingThereIsAnError) {
  EXPECT_THROW(findRoomImages(scratch_ / "nowhere"), Error);
  EXPECT_THROW(findImagesBelow(scratch_ / "nowhere"), Error);
}

TEST(NaturalLess, ComparesBytesWhateverTheMachine) {
  EXPECT_TRUE(naturalLess("zoo", "\u00c4mter"));
  EXPECT_FALSE(naturalLess("\u00c4mter", "zoo"));
}

}  // namespace
}  // namespace place_recognition
