// Names of places from people, folders and files.

#include "base/place_name.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace place_recognition {
namespace {

constexpr const char* kComposed =
    "K\xc3\xbc"
    "che";
constexpr const char* kDecomposed =
    "Ku\xcc\x88"
    "che";

TEST(PlaceName, IsComposed) {
  EXPECT_EQ(placeName(kDecomposed), kComposed);
  EXPECT_EQ(placeName(kComposed), kComposed);
  EXPECT_EQ(placeName("\xe1\x84\x92\xe1\x85\xa1\xe1\x86\xab"), "\xed\x95\x9c");  // Hangul
}

TEST(PlaceName, HasNoBlanksAtItsEndsAndSingleOnesInside) {
  for (const char* text :
       {" meeting room", "meeting room ", "meeting  room", "\tmeeting room\r\n",
        "meeting\xc2\xa0room", "meeting \xc2\xa0 room\xc2\xa0", "\xef\xbb\xbfmeeting room",
        "meeting\xe3\x80\x80room", "meeting room\xe2\x80\x8b"}) {
    EXPECT_EQ(placeName(text), "meeting room") << text;
  }
  EXPECT_EQ(placeName("  "), "");
  EXPECT_EQ(placeName(""), "");
}

TEST(PlaceName, KeepsWhatNamesAreMadeOf) {
  for (const char* text : {"Elin's office", "\xe5\xbb\x8a\xe4\xb8\x8b", "101", "a/b",
                           "\xf0\x9f\x91\xa9\xe2\x80\x8d\xf0\x9f\x8d\xb3", "Office_A"}) {
    EXPECT_EQ(placeName(text), text);
  }
}

TEST(PlaceName, LeavesBadOnesForTheCallerToRefuse) {
  EXPECT_EQ(placeName("a\nb"), "a\nb");
  EXPECT_EQ(placeName("\xff "), "\xff ");
}

TEST(Names, ThatLookAlikeAreTold) {
  for (const std::vector<std::string>& pair :
       {std::vector<std::string>{"lab", "\uff2c\uff41\uff42"},
        {"\ufb01ling", "filing"},
        {"IV", "\u2163"},
        {"office a", "office_a"},
        {"office-a", "Office A"},
        {"lab", "lab."},
        {"lab", "lab "},
        {"K\u00fcche", "k\u00fcche,"},
        {"Stra\u00dfe", "STRASSE"}}) {
    const std::vector<std::string> warnings = warnOfLikeNames(pair);
    ASSERT_EQ(warnings.size(), 1u) << pair[0];
    EXPECT_NE(warnings[0].find("'" + pair[0] + "' and '" + pair[1] + "'"), std::string::npos);
  }
  EXPECT_TRUE(warnOfLikeNames({"2.14", "214", "lab", "lab1", "lab 1", "lab 2", "Kuche",
                               "K\u00fcche", "office", "offices"})
                  .empty());
}

TEST(Names, ThatDifferInCaseOnlyAreTold) {
  EXPECT_TRUE(warnOfLikeNames({"kitchen", "office_a", "office_b"}).empty());
  const std::vector<std::string> warnings =
      warnOfLikeNames({"K\xc3\x9c"
                       "CHE",
                       kComposed, "Office_A", "office_a"});
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_NE(warnings[1].find("'Office_A' and 'office_a'"), std::string::npos);
}

}  // namespace
}  // namespace place_recognition
