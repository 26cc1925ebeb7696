#include <gtest/gtest.h>

#include <filesystem>
#include <opencv2/imgcodecs.hpp>

#include "datasets/image_file.h"
#include "error_of.h"
#include "place_recognition/recording.h"
#include "recognition/drawn_recording.h"
#include "scratch_folder.h"

namespace place_recognition {
namespace {

namespace fs = std::filesystem;

void writeImage(const std::string& path) {
  fs::create_directories(fs::path(path).parent_path());
  cv::imwrite(path, drawRoom(0, 0));
}

std::vector<Frame> framesOf(const std::string& folder) {
  std::vector<Frame> frames;
  const std::unique_ptr<Recording> recording = openFolderRecording(folder);
  for (Frame frame; recording->next(frame);) frames.push_back(frame);
  EXPECT_EQ(recording->fraction(), 1);
  return frames;
}

std::string complaint(const std::string& folder) {
  return errorOf([&] { openFolderRecording(folder); });
}

TEST(FolderRecording, ReadsRoomsInNaturalOrder) {
  const ScratchFolder folder;
  for (const char* name : {"kitchen/a10.png", "kitchen/a9.JPG", "kitchen/a09b.jpeg",
                           "Elin's office/1.png", "kitchen/.hidden.png", "kitchen/notes.txt"}) {
    writeImage(folder / "picture.png");
    fs::create_directories(fs::path(folder / name).parent_path());
    fs::copy_file(folder / "picture.png", folder / name);
  }
  fs::remove(folder / "picture.png");
  const std::vector<Frame> frames = framesOf(folder / "");
  ASSERT_EQ(frames.size(), 4u);
  EXPECT_EQ(frames[0].place, "Elin's office");
  EXPECT_EQ(fs::path(frames[1].name).filename(), "a9.JPG");
  EXPECT_EQ(fs::path(frames[2].name).filename(), "a09b.jpeg");
  EXPECT_EQ(fs::path(frames[3].name).filename(), "a10.png");
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_EQ(frames[i].stamp, static_cast<double>(i));
    EXPECT_EQ(frames[i].image.size(), cv::Size(96, 72));
    EXPECT_EQ(frames[i].problem, "");
  }
}

TEST(FolderRecording, LeavesImagesOutsideRoomsUnlabelled) {
  const ScratchFolder folder;
  writeImage(folder / "1.png");
  const std::vector<Frame> frames = framesOf(folder / "");
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_EQ(frames[0].place, "");
}

TEST(FolderRecording, GoesOnBehindADamagedImage) {
  const ScratchFolder folder;
  writeImage(folder / "kitchen/2.png");
  folder.write("kitchen/1.png", "no image");
  const std::vector<Frame> frames = framesOf(folder / "");
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_TRUE(frames[0].image.empty());
  EXPECT_EQ(frames[0].problem, "it is not an image in a readable format");
  EXPECT_FALSE(frames[1].image.empty());
  EXPECT_EQ(frames[1].problem, "");
}

TEST(FolderRecording, SaysWhatIsMissing) {
  const ScratchFolder folder;
  EXPECT_NE(complaint(folder / "nowhere").find("Cannot read"), std::string::npos);
  EXPECT_NE(complaint(folder / "").find("contains no images"), std::string::npos);
  writeImage(folder / "kitchen/monday/1.png");  // a room may have sub-folders
  EXPECT_EQ(complaint(folder / ""), "");
}

std::vector<std::uint8_t> encoded(const char* extension) {
  std::vector<std::uint8_t> bytes;
  cv::imencode(extension, drawRoom(1, 1), bytes);
  return bytes;
}

std::string problemOf(const std::vector<std::uint8_t>& bytes) {
  const DecodedImage decoded = decodeImage(bytes.data(), bytes.size());
  EXPECT_EQ(decoded.image.empty(), !decoded.problem.empty());
  return decoded.problem;
}

TEST(DecodeImage, AcceptsOnlyWhatCamerasSend) {
  EXPECT_EQ(problemOf(encoded(".png")), "");
  EXPECT_EQ(problemOf(encoded(".jpg")), "");
  EXPECT_EQ(problemOf(encoded(".webp")), "");
  EXPECT_EQ(problemOf(encoded(".bmp")), "it is not a PNG, JPEG or WebP image");
  EXPECT_EQ(problemOf({}), "it is empty");
}

TEST(DecodeImage, RefusesBombsUndecoded) {
  std::vector<std::uint8_t> png = encoded(".png");
  for (std::size_t i = 16; i < 24; ++i) png[i] = 0x7f;  // width and height in IHDR
  EXPECT_NE(problemOf(png).find("64 million"), std::string::npos);

  std::vector<std::uint8_t> jpeg = encoded(".jpg");
  for (std::size_t i = 0; i + 9 < jpeg.size(); ++i) {
    const bool start_of_frame = jpeg[i] == 0xff && jpeg[i + 1] == 0xc0;
    if (!start_of_frame) continue;
    for (std::size_t k = 5; k < 9; ++k) jpeg[i + k] = 0xff;
    break;
  }
  EXPECT_NE(problemOf(jpeg).find("65535 x 65535"), std::string::npos);
}

TEST(DecodeImage, SurvivesEveryCut) {
  for (const char* extension : {".png", ".jpg"}) {
    const std::vector<std::uint8_t> whole = encoded(extension);
    for (std::size_t length = 0; length < whole.size(); length += 7) {
      decodeImage(whole.data(), length);
    }
    EXPECT_NE(problemOf({whole.begin(), whole.begin() + 30}), "");
  }
}

}  // namespace
}  // namespace place_recognition
