#include "base/file_kind.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>

namespace place_recognition {
namespace {

using namespace std::literals;

constexpr std::string_view kConvertBag =
    "convert it to a ROS 1 bag, for instance with rosbags-convert";
constexpr std::string_view kConvertImage = "convert it to PNG or JPEG";

struct Signature {
  std::size_t offset;
  std::string_view bytes;  // letters in upper or lower case
  FileKind kind;
};

constexpr std::array<Signature, 32> kSignatures{{
    {0,
     "version https://git-lfs"sv,
     {"a Git LFS pointer, not the file itself", "run: git lfs pull"}},
    {0, "/annex/objects/"sv, {"a git-annex pointer, not the file itself", "run: git annex get"}},
    {0, "<!doctype html"sv, {"a web page", "download the file itself"}},
    {0, "<html"sv, {"a web page", "download the file itself"}},
    {0, "<?xml"sv, {"an XML document", "download the file itself"}},
    {0, "\x1f\x8b"sv, {"compressed with gzip", "unpack it with gunzip or tar xzf"}},
    {0, "BZh"sv, {"compressed with bzip2", "unpack it with bunzip2 or tar xjf"}},
    {0, "\xfd\x37zXZ\0"sv, {"compressed with xz", "unpack it with unxz or tar xJf"}},
    {0, "\x28\xb5\x2f\xfd"sv, {"compressed with zstd", "unpack it with unzstd"}},
    {0, "\x04\x22\x4d\x18"sv, {"compressed with lz4", "unpack it with unlz4"}},
    {0, "PK\x03\x04"sv, {"a zip archive", "unpack it with unzip"}},
    {0, "PK\x05\x06"sv, {"an empty zip archive", "create it again"}},
    {0, "7z\xbc\xaf\x27\x1c"sv, {"a 7-Zip archive", "unpack it with 7z x"}},
    {0, "Rar!"sv, {"a RAR archive", "unpack it with unrar x"}},
    {257, "ustar"sv, {"a tar archive", "unpack it with tar xf"}},
    {0, "\x89MCAP"sv, {"a recording in MCAP, the format of ROS 2", kConvertBag}},
    {0, "SQLite format 3"sv, {"an SQLite database, such as ROS 2 records", kConvertBag}},
    {0, "rosbag2_bagfile_information"sv, {"the metadata of a ROS 2 bag", kConvertBag}},
    {0, "#ROSBAG V1"sv, {"a bag of version 1", "convert it with: rosbag fix"}},
    {0, "#ROSRECORD V1"sv, {"a bag of version 1", "convert it with: rosbag fix"}},
    {0,
     "\0\x05\x16\x07"sv,
     {"a macOS metadata file", "give the file whose name does not start with ._"}},
    {0, "\x89HDF"sv, {"an HDF5 file", "export its images as PNG or JPEG"}},
    {8, "AVI "sv, {"a video", "extract its frames, for example with: ffmpeg -i IN frame_%05d.jpg"}},
    {0, "GIF8"sv, {"a GIF image", kConvertImage}},
    {0, "\xff\x0a"sv, {"a JPEG XL image", kConvertImage}},
    {4, "JXL "sv, {"a JPEG XL image", kConvertImage}},
    {4, "ftypavi"sv, {"an AVIF image", kConvertImage}},
    {4, "ftyphe"sv, {"a HEIC image", kConvertImage}},
    {4, "ftypm"sv, {"a HEIC image or a video", kConvertImage}},
    {4, "ftyp"sv, {"a video", "extract its frames, for example with: ffmpeg -i IN frame_%05d.jpg"}},
    {0,
     "\x1a\x45\xdf\xa3"sv,
     {"a video", "extract its frames, for example with: ffmpeg -i IN frame_%05d.jpg"}},
    {0, "%PDF"sv, {"a PDF document", kConvertImage}},
}};

bool sameLetter(char a, char b) {
  return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

bool matches(std::string_view start, const Signature& signature) {
  if (start.size() < signature.offset + signature.bytes.size()) return false;
  return std::equal(signature.bytes.begin(), signature.bytes.end(),
                    start.begin() + static_cast<std::ptrdiff_t>(signature.offset), sameLetter);
}

}  // namespace

std::string startOfFile(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return "";
  std::string start(512, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return start;
}

const FileKind* foreignFile(std::string_view start) {
  const auto found =
      std::find_if(kSignatures.begin(), kSignatures.end(),
                   [start](const Signature& signature) { return matches(start, signature); });
  return found == kSignatures.end() ? nullptr : &found->kind;
}

}  // namespace place_recognition
