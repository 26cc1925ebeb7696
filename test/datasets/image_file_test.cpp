// Image files: formats, damage, and files that only resemble images.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "datasets/image_file.h"
#include "datasets/jpeg_check.h"
#include "recognition/drawn_recording.h"
#include "scratch_folder.h"

namespace place_recognition {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Returns an image with detail in each of its blocks.
cv::Mat noisyRoom() {
  cv::Mat image = drawRoom(1, 1), noise(image.size(), image.type());
  cv::resize(image, image, {}, 2, 2);
  cv::RNG random(3);
  noise.create(image.size(), image.type());
  random.fill(noise, cv::RNG::UNIFORM, 0, 40);
  return image + noise;
}

Bytes encoded(const std::string& extension, const std::vector<int>& parameters = {}) {
  Bytes bytes;
  cv::imencode(extension, noisyRoom(), bytes, parameters);
  return bytes;
}

std::string problemOf(const Bytes& bytes) {
  const DecodedImage decoded = decodeImage(bytes.data(), bytes.size());
  EXPECT_EQ(decoded.image.empty(), !decoded.problem.empty());
  return decoded.problem;
}

struct JpegKind {
  const char* name;
  std::vector<int> parameters;
};

class Jpegs : public testing::TestWithParam<JpegKind> {
 protected:
  const Bytes whole_ = encoded(".jpg", GetParam().parameters);

  Bytes cut(double fraction) const {
    const auto kept = static_cast<std::ptrdiff_t>(fraction * static_cast<double>(whole_.size()));
    return {whole_.begin(), whole_.begin() + kept};
  }
};

TEST_P(Jpegs, WholeOnesAreTaken) { EXPECT_EQ(problemOf(whole_), ""); }

TEST_P(Jpegs, CutOnesAreUnusable) {
  for (const double fraction : {0.1, 0.3333, 0.5, 0.8, 0.95, 0.99}) {
    EXPECT_NE(problemOf(cut(fraction)), "") << fraction;
  }
  for (std::ptrdiff_t lost = 5; lost < 100; lost += 3) {
    EXPECT_NE(problemOf({whole_.begin(), whole_.end() - lost}), "") << lost;
  }
}

TEST_P(Jpegs, CutOnesWithAnEndMarkerAreUnusable) {
  for (const double fraction : {0.3333, 0.5, 0.9}) {
    Bytes bytes = cut(fraction);
    if (bytes.back() == 0xff) bytes.pop_back();
    bytes.insert(bytes.end(), {0xff, 0xd9});
    EXPECT_NE(problemOf(bytes), "") << fraction;
  }
}

TEST_P(Jpegs, CutOnesInABufferOfZerosAreUnusable) {
  for (const double fraction : {0.3333, 0.5, 0.9}) {
    Bytes bytes = cut(fraction);
    bytes.resize(whole_.size() + 4096);
    EXPECT_NE(problemOf(bytes), "") << fraction;
  }
}

TEST_P(Jpegs, WithAPieceMissingAreUnusable) {
  Bytes bytes = whole_;
  const auto middle = bytes.begin() + static_cast<std::ptrdiff_t>(bytes.size() / 2);
  bytes.erase(middle, middle + static_cast<std::ptrdiff_t>(bytes.size() / 5));
  EXPECT_NE(problemOf(bytes), "");
}

TEST_P(Jpegs, AMissingEndMarkerDoesNoHarm) {
  const DecodedImage whole = decodeImage(whole_.data(), whole_.size());
  const DecodedImage endless = decodeImage(whole_.data(), whole_.size() - 2);
  ASSERT_EQ(endless.problem, "");
  EXPECT_EQ(cv::norm(whole.image, endless.image, cv::NORM_INF), 0);
}

TEST_P(Jpegs, BytesBehindTheEndDoNoHarm) {
  Bytes zeros = whole_, rubbish = whole_, second = whole_;
  zeros.resize(zeros.size() + 5000);
  rubbish.insert(rubbish.end(), {0x12, 0x34, 0xff, 0xd8, 0xff, 0x77});
  second.insert(second.end(), whole_.begin(), whole_.end());
  for (const Bytes& bytes : {zeros, rubbish, second}) EXPECT_EQ(problemOf(bytes), "");
}

INSTANTIATE_TEST_SUITE_P(All, Jpegs,
                         testing::Values(JpegKind{"baseline", {}},
                                         JpegKind{"progressive", {cv::IMWRITE_JPEG_PROGRESSIVE, 1}},
                                         JpegKind{"restart", {cv::IMWRITE_JPEG_RST_INTERVAL, 4}},
                                         JpegKind{"optimized", {cv::IMWRITE_JPEG_OPTIMIZE, 1}}),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(WebpInABufferOfZeros, IsUnusable) {
  for (const int quality : {80, 101}) {
    Bytes bytes = encoded(".webp", {cv::IMWRITE_WEBP_QUALITY, quality});
    EXPECT_EQ(problemOf(bytes), "");
    std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(bytes.size() / 2), bytes.end(), 0);
    EXPECT_NE(problemOf(bytes), "");
  }
  for (const int grey : {0, 128, 255}) {  // which end in many zeros
    Bytes bytes;
    cv::imencode(".webp", cv::Mat(480, 640, CV_8UC1, cv::Scalar(grey)), bytes,
                 {cv::IMWRITE_WEBP_QUALITY, 1});
    EXPECT_EQ(problemOf(bytes), "");
  }
}

TEST(JpegOfOneColour, IsWhole) {
  // Its blocks take a few bits each, many of which are zeros.
  for (const int grey : {0, 128, 255}) {
    Bytes bytes;
    cv::imencode(".jpg", cv::Mat(480, 640, CV_8UC1, cv::Scalar(grey)), bytes,
                 {cv::IMWRITE_JPEG_OPTIMIZE, 1});
    EXPECT_TRUE(isWholeJpeg(bytes.data(), bytes.size()));
    EXPECT_FALSE(isWholeJpeg(bytes.data(), bytes.size() * 3 / 4));
  }
}

/// File formats and the tolerance of a decoded image.
struct FileFormat {
  const char* extension;
  std::vector<int> parameters;
  double largest_error;
};

class ImageFiles : public testing::TestWithParam<FileFormat> {};

TEST_P(ImageFiles, AreReadAndCutOnesAreNot) {
  if (!cv::haveImageWriter(GetParam().extension)) {
    GTEST_SKIP() << "This OpenCV has no " << GetParam().extension << "; 4.2 has no JPEG 2000.";
  }
  const ScratchFolder scratch;
  const Bytes whole = encoded(GetParam().extension, GetParam().parameters);
  const auto read = [&](std::size_t size) {
    const std::string bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    return readImageFile(scratch.write(std::string("x") + GetParam().extension, bytes));
  };
  const DecodedImage decoded = read(whole.size());
  ASSERT_EQ(decoded.problem, "");
  ASSERT_EQ(decoded.image.type(), CV_8UC3);
  EXPECT_LE(cv::norm(decoded.image, noisyRoom(), cv::NORM_L2) /
                std::sqrt(static_cast<double>(decoded.image.total() * 3)),
            GetParam().largest_error);
  for (std::size_t size = 0; size + 40 < whole.size(); size += whole.size() / 23 + 1) {
    EXPECT_NE(read(size).problem, "") << size << " of " << whole.size();
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, ImageFiles,
    testing::Values(FileFormat{".png", {}, 0}, FileFormat{".jpg", {}, 12},
                    FileFormat{".webp", {cv::IMWRITE_WEBP_QUALITY, 101}, 0},
                    FileFormat{".webp", {cv::IMWRITE_WEBP_QUALITY, 90}, 20},
                    FileFormat{".bmp", {}, 0}, FileFormat{".tiff", {}, 0},
                    FileFormat{".tiff", {cv::IMWRITE_TIFF_COMPRESSION, 1}, 0},
                    FileFormat{".ppm", {}, 0}, FileFormat{".ppm", {cv::IMWRITE_PXM_BINARY, 0}, 0},
                    FileFormat{".ras", {}, 0},
                    FileFormat{".jp2", {cv::IMWRITE_JPEG2000_COMPRESSION_X1000, 1000}, 3}));

TEST(GreyImageFiles, AreRead) {
  const ScratchFolder scratch;
  const std::vector<int> text = {cv::IMWRITE_PXM_BINARY, 0};
  for (const auto& [name, parameters] :
       std::vector<std::pair<std::string, std::vector<int>>>{{"x.pgm", {}},
                                                             {"x.pgm", text},
                                                             {"x.pbm", {}},
                                                             {"x.pbm", text},
                                                             {"x.tif", {}},
                                                             {"x.bmp", {}},
                                                             {"x.dib", {}},
                                                             {"x.ras", {}},
                                                             {"x.png", {}}}) {
    cv::Mat grey(30, 41, CV_8UC1, cv::Scalar(255));
    grey.colRange(0, 17) = 0;
    ASSERT_TRUE(cv::imwrite(scratch / name, grey, parameters)) << name;
    const DecodedImage decoded = readImageFile(scratch / name);
    EXPECT_EQ(decoded.problem, "") << name;
    ASSERT_EQ(decoded.image.size(), grey.size());
    EXPECT_EQ(decoded.image.elemSize1(), 1u);
  }
}

TEST(ImageFilesThatAreNone, AreNamedForWhatTheyAre) {
  const ScratchFolder scratch;
  const auto problem = [&](const std::string& bytes) {
    return readImageFile(scratch.write("x.jpg", bytes)).problem;
  };
  using namespace std::string_literals;
  EXPECT_EQ(problem(""), "it is empty");
  EXPECT_NE(problem("GIF89a\1\0\1\0"s).find("GIF"), std::string::npos);
  EXPECT_NE(problem("\0\0\0\x18"s + "ftypheic").find("HEIC"), std::string::npos);
  EXPECT_NE(problem("\0\0\0\x18"s + "ftypavif").find("AVIF"), std::string::npos);
  EXPECT_NE(problem("version https://git-lfs.github.com/spec/v1\n").find("git lfs pull"),
            std::string::npos);
  EXPECT_NE(problem("<!DOCTYPE html><html>").find("web page"), std::string::npos);
  EXPECT_NE(problem("notes").find("not an image"), std::string::npos);
  EXPECT_EQ(readImageFile(scratch / ".").problem, "it is a folder, not an image");
}

TEST(ImageFilesThatAreBombs, AreRefusedByTheirHeader) {
  const ScratchFolder scratch;
  const auto problem = [&](std::string bytes, std::size_t offset, const std::string& patch) {
    bytes.replace(offset, patch.size(), patch);
    return readImageFile(scratch.write("x", bytes)).problem;
  };
  const auto file = [](const char* extension, const std::vector<int>& parameters = {}) {
    const Bytes bytes = encoded(extension, parameters);
    return std::string(bytes.begin(), bytes.end());
  };
  using namespace std::string_literals;
  EXPECT_NE(problem(file(".bmp"), 18, "\0\0\1\0\0\0\1\0"s).find("64 million"), std::string::npos);
  EXPECT_NE(problem("P6\n60000 60000\n255\nabc", 0, "P6").find("64 million"), std::string::npos);
  const std::string webp = file(".webp", {cv::IMWRITE_WEBP_QUALITY, 90});
  EXPECT_NE(problem(webp, 26, "\xff\x3f\xff\x3f"s).find("64 million"), std::string::npos);
}

}  // namespace
}  // namespace place_recognition
