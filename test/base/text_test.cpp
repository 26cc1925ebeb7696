#include "base/text.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace place_recognition {
namespace {

/// Encodes ASCII and one other letter in UTF-16.
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
  EXPECT_EQ(toUtf8("K\xfc\n"), "K\xfc\n");  // Latin-1 is left unchanged, for callers to refuse
  EXPECT_EQ(toUtf8(""), "");
  EXPECT_EQ(toUtf8("\xff\xfe"), "");
}

TEST(Text, LinesEndInAnyWay) {
  EXPECT_EQ(linesOf("a\nb\r\nc\rd"), (std::vector<std::string>{"a", "b", "c", "d"}));
  EXPECT_EQ(linesOf("a\n\nb\n"), (std::vector<std::string>{"a", "", "b"}));
  EXPECT_TRUE(linesOf("").empty());
}

TEST(Text, IsTidiedToOneWayOfWritingIt) {
  EXPECT_EQ(tidied("Ku\u0308che "), "K\u00fcche");
  EXPECT_EQ(tidied("\u00a0 living \u3000 room\t\n"), "living room");
  EXPECT_EQ(tidied("\ufeffkit\u200bch\u00aden\u200e"), "kitchen");
  EXPECT_EQ(tidied("\u202akitchen\u202c"), "kitchen");
  EXPECT_EQ(tidied("u\u200b\u0308"), "\u00fc");  // composed across the removed character
  EXPECT_EQ(tidied("kit\u200b chen"), "kit chen");
  EXPECT_EQ(tidied("\u2060 \u200b"), "");
}

TEST(Text, KeepsWhatJoinsLetters) {
  for (const char* text :
       {"\U0001f469\u200d\U0001f373", "\u2615\ufe0f", "\u0646\u0645\u200c\u06cc"}) {
    EXPECT_EQ(tidied(text), text);
  }
}

TEST(Text, CountsInSingularAndPlural) {
  EXPECT_EQ(counted(0, "image"), "0 images");
  EXPECT_EQ(counted(1, "image"), "1 image");
  EXPECT_EQ(counted(2, "image"), "2 images");
}

TEST(Listed, PutsSeparatorsBetweenWords) {
  EXPECT_EQ(listed({}), "");
  EXPECT_EQ(listed({"a"}), "a");
  EXPECT_EQ(listed({"a", "b", "c"}), "a, b, c");
  EXPECT_EQ(listed({"a", "b"}, "-"), "a-b");
}

TEST(InQuotes, IsPrintableAndShort) {
  EXPECT_EQ(inQuotes("K\u00fcche\n2"), "'K\u00fcche?2'");
  EXPECT_EQ(inQuotes("K\xfc"
                     "che"),
            "'K?che'");  // Latin-1
  EXPECT_EQ(inQuotes("abcd", 4), "'abcd'");
  EXPECT_EQ(inQuotes("abcde", 4), "'abcd...'");
  EXPECT_EQ(inQuotes("ab\u00fcd", 3), "'ab...'");  // a letter of two bytes is not cut in two
  EXPECT_EQ(inQuotes(std::string("a\0b", 3)), "'a?b'");
}

TEST(Significant, LeavesOutZerosBehindThePoint) {
  EXPECT_EQ(significant(100), "100");
  EXPECT_EQ(significant(0.05), "0.05");
  EXPECT_EQ(significant(1e-6), "1e-06");
  EXPECT_EQ(significant(2.0 / 3, 3), "0.667");
}

TEST(FormatDouble, ReadsBackAsTheSameNumber) {
  EXPECT_EQ(shortest(0.1), "0.1");
  for (const double number : {1.0 / 3, 0.1 + 0.2, 1e300 / 7}) {
    EXPECT_EQ(std::stod(shortest(number)), number);
  }
}

TEST(EndsWith, ComparesTheEnd) {
  EXPECT_TRUE(endsWith("run.bag", ".bag"));
  EXPECT_FALSE(endsWith("bag", ".bag"));
  EXPECT_TRUE(endsWith("bag", ""));
}

}  // namespace
}  // namespace place_recognition
