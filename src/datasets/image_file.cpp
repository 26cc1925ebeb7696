#include "datasets/image_file.h"

#include <filesystem>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <system_error>

#include "base/atomic_file.h"
#include "base/file_kind.h"
#include "base/text.h"
#include "datasets/image_header.h"
#include "datasets/image_sequence.h"
#include "datasets/jpeg_check.h"
#include "place_recognition/error.h"

namespace place_recognition {
namespace {

constexpr std::uint64_t kMaxPixels = 64'000'000;
constexpr std::size_t kMaxFileSize = 256'000'000;

/// Formats that cameras send.
bool isStreamed(ImageFormat format) {
  return format == ImageFormat::kPng || format == ImageFormat::kJpeg ||
         format == ImageFormat::kWebp;
}

std::string whyNoImage(const std::uint8_t* bytes, std::size_t size) {
  if (size == 0) return "it is empty";
  const FileKind* kind = foreignFile({reinterpret_cast<const char*>(bytes), size});
  if (!kind) return "it is not an image in a readable format";
  return "it is " + std::string(kind->name) + "; " + std::string(kind->remedy);
}

/// What is wrong with an image before it is decoded; empty if nothing is.
std::string problemOf(const ImageHeader& header, const std::uint8_t* bytes, std::size_t size) {
  if (header.format == ImageFormat::kNone) return whyNoImage(bytes, size);
  if (header.width == 0 || header.height == 0) return "its header is damaged";
  if (header.width > kMaxPixels || header.height > kMaxPixels ||
      header.width * header.height > kMaxPixels) {
    return "it declares " + sizeText(header.width, header.height) + " pixels, more than 64 million";
  }
  if (size > std::numeric_limits<int>::max()) return "it is larger than 2 GB";
  const bool is_jpeg = header.format == ImageFormat::kJpeg;
  if (!header.whole || (is_jpeg && !isWholeJpeg(bytes, size))) return "it is damaged or truncated";
  return "";
}

/// OpenCV rejects a progressive JPEG without an end marker, even if its data is complete.
bool lacksEnd(const ImageHeader& header, const std::uint8_t* bytes, std::size_t size) {
  return header.format == ImageFormat::kJpeg &&
         (bytes[size - 2] != 0xff || bytes[size - 1] != 0xd9);
}

ImageHeader headerOf(const std::string& file) {
  return readImageHeader(reinterpret_cast<const std::uint8_t*>(file.data()), file.size());
}

DecodedImage decode(const ImageHeader& header, const std::uint8_t* bytes, std::size_t size) {
  DecodedImage decoded{{}, problemOf(header, bytes, size)};
  if (!decoded.problem.empty()) return decoded;
  try {
    cv::Mat buffer(1, static_cast<int>(size), CV_8UC1, const_cast<std::uint8_t*>(bytes));
    if (lacksEnd(header, bytes, size)) {
      cv::hconcat(buffer, cv::Mat_<std::uint8_t>({1, 2}, {0xff, 0xd9}), buffer);
    }
    decoded.image = cv::imdecode(buffer, cv::IMREAD_ANYCOLOR | cv::IMREAD_ANYDEPTH);
  } catch (const cv::Exception&) {
    decoded.image.release();
  }
  if (decoded.image.empty()) {
    decoded.problem = "it is damaged and cannot be decoded";
  } else if (decoded.image.depth() != CV_8U && decoded.image.depth() != CV_16U) {
    decoded = {{}, "its pixels have neither 8 nor 16 bits per channel"};
  }
  return decoded;
}

}  // namespace

DecodedImage decodeImage(const std::uint8_t* bytes, std::size_t size) {
  const ImageHeader header = readImageHeader(bytes, size);
  if (header.format != ImageFormat::kNone && !isStreamed(header.format)) {
    return {{}, "it is not a PNG, JPEG or WebP image"};
  }
  return decode(header, bytes, size);
}

bool startsAsImage(const std::string& path) {
  return isStreamed(headerOf(startOfFile(path)).format);
}

DecodedImage readDeepImageFile(const std::string& path) {
  try {
    const std::string file = readFile(path, kMaxFileSize);
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(file.data());
    return decode(headerOf(file), bytes, file.size());
  } catch (const Error&) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) return {{}, "it is a folder, not an image"};
    return {{}, "it cannot be read or is larger than 256 MB"};
  }
}

DecodedImage readImageFile(const std::string& path) { return ImageSequence({path}).read(0); }

}  // namespace place_recognition
