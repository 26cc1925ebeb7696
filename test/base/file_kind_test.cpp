#include "base/file_kind.h"

#include <gtest/gtest.h>

#include <string>

namespace place_recognition {
namespace {

using namespace std::string_view_literals;

TEST(FileKind, IsToldByTheFirstBytes) {
  const auto name = [](std::string_view start) {
    const FileKind* kind = foreignFile(start);
    return std::string(kind ? kind->name : "");
  };
  EXPECT_NE(name("version https://git-lfs.github.com/spec/v1\noid sha256:0").find("Git LFS"),
            std::string::npos);
  EXPECT_NE(name("<!DOCTYPE HTML>").find("web page"), std::string::npos);
  EXPECT_NE(name("SQLite format 3\0"sv).find("ROS 2"), std::string::npos);
  EXPECT_NE(name("\x89MCAP0\r\n"sv).find("ROS 2"), std::string::npos);
  EXPECT_NE(name("\x1f\x8b\x08"sv).find("gzip"), std::string::npos);
  EXPECT_NE(name("PK\x03\x04..."sv).find("zip"), std::string::npos);
  EXPECT_NE(name("\0\x05\x16\x07\0\x02"sv).find("macOS"), std::string::npos);
  EXPECT_NE(name("#ROSRECORD V1.1\n").find("version 1"), std::string::npos);
  EXPECT_NE(name("RIFF\x10\0\0\0AVI LIST"sv).find("video"), std::string::npos);
  EXPECT_EQ(name("#ROSBAG V2.0\n"), "");
  EXPECT_EQ(name("\xff\xd8\xff\xe0"sv), "");
  EXPECT_EQ(name(""), "");
  EXPECT_EQ(name("v"), "");
}

}  // namespace
}  // namespace place_recognition
