#include "datasets/image_header.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "datasets/format_headers.h"

namespace place_recognition {
namespace {

using namespace std::literals;

struct Signature {
  std::string_view start;
  ImageHeader (*read)(const FileBytes&);
};

constexpr std::array<Signature, 15> kSignatures{{
    {"\x89PNG\r\n\x1a\n"sv, readPngHeader},
    {"\xff\xd8"sv, readJpegHeader},
    {"RIFF"sv, readWebpHeader},
    {"BM"sv, readBmpHeader},
    {"II*\0"sv, readTiffHeader},
    {"MM\0*"sv, readTiffHeader},
    {"P1"sv, readPnmHeader},
    {"P2"sv, readPnmHeader},
    {"P3"sv, readPnmHeader},
    {"P4"sv, readPnmHeader},
    {"P5"sv, readPnmHeader},
    {"P6"sv, readPnmHeader},
    {"\x59\xa6\x6a\x95"sv, readSunRasterHeader},
    {"\xff\x4f\xff\x51"sv, readJpeg2000Header},
    {"\0\0\0\x0cjP  \r\n\x87\n"sv, readJpeg2000Header},
}};

}  // namespace

ImageHeader readImageHeader(const std::uint8_t* bytes, std::size_t size) {
  const FileBytes file(bytes, size);
  const auto found =
      std::find_if(kSignatures.begin(), kSignatures.end(),
                   [&file](const Signature& kind) { return file.startsWith(kind.start); });
  if (found == kSignatures.end()) return {};
  if (found->read == readWebpHeader && !file.startsWith("WEBP", 8)) return {};
  return found->read(file);
}

}  // namespace place_recognition
