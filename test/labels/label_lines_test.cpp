// Files of lines `timestamp label`: valid labels, and lines that are ambiguous.

#include "labels/label_lines.h"

#include <gtest/gtest.h>

#include <string>

#include "error_of.h"
#include "labels/labels.h"
#include "scratch_folder.h"

namespace place_recognition {
namespace {

class LabelLinesFile : public testing::Test {
 protected:
  Labels labels(const std::string& text, double start = 1000) {
    return Labels::fromFile(scratch_.write("labels.dat", text), start, start + 100);
  }

  std::string errorIn(const std::string& text, double start = 1000) {
    return errorOf([&] { labels(text, start); });
  }

  void expectError(const std::string& text, const std::string& words, double start = 1000) {
    const std::string error = errorIn(text, start);
    EXPECT_NE(error.find(words), std::string::npos) << text << "-> " << error;
  }

  ScratchFolder scratch_;
};

constexpr double kToday = 1700000000;

TEST_F(LabelLinesFile, SpansAreRefused) {
  for (const char* text :
       {"1000 1005 kitchen\n", "1000 1005.5 kitchen\n", "0.0 5.0 kitchen\n5.0 10.0 office\n",
        "1000 kitchen 1005.5\n", "1000 1700000005 kitchen\n"}) {
    expectError(text, "line 1 may also contain an end time");
    expectError(text, "{from: ..., to: ..., place: ...}");
  }
  for (const char* text :
       {"1700000000 1700000005 kitchen\n", "1700000000 kitchen 1700000005\n",
        "1700000000 1700000005\n", "1700000000,1700000005\n", "1700000000;1700000005\n"}) {
    expectError(text, "line 1 may also contain an end time", kToday);
  }
  for (const char* text : {"1000\t1005\tkitchen\n", "1000\tkitchen\t1005\n", "1000,1005,kitchen\n",
                           "1000;1005;kitchen\n", "1000, 1005, kitchen\n"}) {
    expectError(text, "line 1 has more than two columns");
  }
}

TEST_F(LabelLinesFile, NanosecondsApartAreRefused) {
  for (const char* text : {"1000 0 kitchen\n", "1000 000000000 kitchen\n"}) {
    expectError(text, "line 1 may have the nanoseconds of its timestamp");
  }
  EXPECT_EQ(labels("1000 \"0 kitchen\"\n").at(1001), "0 kitchen");
  EXPECT_EQ(labels("1000 0\n").at(1001), "0");
  EXPECT_EQ(labels("1000 007 lab\n").at(1001), "007 lab");
}

TEST_F(LabelLinesFile, RoomNumbersAreNotTimes) {
  EXPECT_EQ(labels("1000 101 lab\n").at(1001), "101 lab");
  EXPECT_EQ(labels("1000 2.14 seminar\n").at(1001), "2.14 seminar");
  EXPECT_EQ(labels("1000 seminar 2.14\n").at(1001), "seminar 2.14");
  EXPECT_EQ(labels("1000 101\n").at(1001), "101");
  EXPECT_EQ(labels("0.5 101\n", 0).at(1), "101");
  EXPECT_EQ(labels("0.5 office 2\n", 0).at(1), "office 2");
  EXPECT_EQ(labels("1700000000 5012 lab\n", kToday).at(kToday + 1), "5012 lab");
  EXPECT_EQ(labels("1000 \"1005 kitchen\"\n").at(1001), "1005 kitchen");
  EXPECT_EQ(labels("1000,\"1700000005\"\n").at(1001), "1700000005");
}

TEST_F(LabelLinesFile, WhatStandsBesideALabelIsRefused) {
  for (const char* text :
       {"1000 | kitchen\n", "1000 - kitchen\n", "1000 - 1005 kitchen\n", "1000 = kitchen\n",
        "1000 -> kitchen\n", "1000 kitchen,\n", "1000 kitchen;\n", "1000 kitchen # the small one\n",
        "1000 kitchen // the small one\n", "1000 -\n"}) {
    expectError(text, "line 1 may contain more than a label");
  }
  EXPECT_EQ(labels("1000 lab #3\n").at(1001), "lab #3");
  EXPECT_EQ(labels("1000 kitchen, small\n").at(1001), "kitchen, small");
  EXPECT_EQ(labels("1000 (kitchen)\n").at(1001), "(kitchen)");
  EXPECT_EQ(labels("1000 \"| kitchen\"\n").at(1001), "| kitchen");
}

TEST_F(LabelLinesFile, SingleQuotesAreQuotes) {
  EXPECT_EQ(labels("1000 'kitchen'\n").at(1001), "kitchen");
  EXPECT_EQ(labels("1000,'meeting room'\n").at(1001), "meeting room");
  EXPECT_EQ(labels("1000 'Elin's office'\n").at(1001), "Elin's office");
  EXPECT_EQ(labels("1000 Elin's\n").at(1001), "Elin's");
}

TEST_F(LabelLinesFile, BlanksOfAllKindsSeparate) {
  EXPECT_EQ(labels("1000\u00a0kitchen\n").at(1001), "kitchen");
  EXPECT_EQ(labels("1000\u2003kitchen\n").at(1001), "kitchen");
  EXPECT_EQ(labels("\u200b1000 kitchen\u200b\n").at(1001), "kitchen");
  EXPECT_EQ(labels("  1000\t \tkitchen \t\n").at(1001), "kitchen");
  expectError("1000\t\n", "line 1 has no label");
}

TEST_F(LabelLinesFile, TimestampsAreOfOneUnitAndCountFrom1970) {
  expectError("1700000000 kitchen\n1700000005000 office\n",
              "line 2 has its timestamp in another unit", kToday);
  expectError("1700000000000 kitchen\n1700000005 office\n",
              "line 2 has its timestamp in another unit", kToday);
  expectError("-1 kitchen\n1000 office\n", "line 1 has a negative timestamp");
  for (const char* text : {"nan kitchen\n", "inf kitchen\n", "NaT,kitchen\n", ",kitchen\n"}) {
    expectError(text, "line 1 is not 'timestamp label'");
  }
  expectError("0 kitchen\n5 office\n", "relative to the bag's start into RUN.labels.yaml", kToday);
}

TEST_F(LabelLinesFile, ALabelThatIsReplacedIsTold) {
  const std::string note = labels("1000 kitchen\n1000 office\n").note();
  EXPECT_NE(note.find("line 2 has the same timestamp"), std::string::npos) << note;
  EXPECT_NE(note.find("'kitchen' has no effect"), std::string::npos) << note;
  EXPECT_EQ(labels("1000 kitchen\n1000 kitchen\n").note(), "");
}

TEST_F(LabelLinesFile, FilesOfOtherKindsAreNamed) {
  expectError("version https://git-lfs.github.com/spec/v1\n", "git lfs pull");
  expectError("PK\x03\x04xlsx", "zip archive");
  expectError("<!DOCTYPE html>\n", "web page");
  expectError(
      "1000 K\xfc"
      "che\n",
      "save it as UTF-8");
}

}  // namespace
}  // namespace place_recognition
