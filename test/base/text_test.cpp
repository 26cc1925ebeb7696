#include "base/text.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace place_recognition {
namespace {

/// ASCII and one other letter in UTF-16.
std::string utf16(const std::string& ascii, bool big_endian, const std::string& mark) {
  std::string bytes = mark;
  for (const char c : ascii) bytes += big_endian ? std::string{'\0', c} : std::string{c, '\0'};
  return bytes;
}

TEST(Text, IsUtf8WhateverItWas) {
  const std::string text = "1700000000.5 kitchen\r\n";
  EXPECT_EQ(toUtf8(text), text);
  EXPECT_EQ(toUtf8("\xef\xbb\xbf" + text), text);
  EXPECT_EQ(toUtf8(utf16(text, false, "\xff\xfe")), text);
  EXPECT_EQ(toUtf8(utf16(text, true, "\xfe\xff")), text);
  EXPECT_EQ(toUtf8(utf16(text, false, "")), text);
  EXPECT_EQ(toUtf8(utf16(text, true, "")), text);
  EXPECT_EQ(toUtf8("K\xc3\xbc\n"), "K\xc3\xbc\n");
  EXPECT_EQ(toUtf8("K\xfc\n"), "K\xfc\n");  // Latin-1 is left for who refuses it
  EXPECT_EQ(toUtf8(""), "");
  EXPECT_EQ(toUtf8("\xff\xfe"), "");
}

TEST(Text, LinesEndInAnyWay) {
  EXPECT_EQ(linesOf("a\nb\r\nc\rd"), (std::vector<std::string>{"a", "b", "c", "d"}));
  EXPECT_EQ(linesOf("a\n\nb\n"), (std::vector<std::string>{"a", "", "b"}));
  EXPECT_TRUE(linesOf("").empty());
}

}  // namespace
}  // namespace place_recognition
