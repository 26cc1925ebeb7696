// Labels from files, and files that are refused.

#include "labels/labels.h"

#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <vector>

#include "error_of.h"
#include "place_recognition/error.h"
#include "scratch_folder.h"

namespace place_recognition {
namespace {

class LabelFiles : public testing::Test {
 protected:
  /// Labels of a bag that extends from 1000 to 1100 s.
  Labels read(const std::string& name, const std::string& text) {
    return Labels::fromFile(scratch_.write(name, text), 1000, 1100);
  }

  std::string errorIn(const std::string& name, const std::string& text) {
    return errorOf([&] { read(name, text); });
  }

  ScratchFolder scratch_;
};

TEST_F(LabelFiles, RelativeIntervals) {
  const Labels labels = read("run.labels.yaml",
                             "labels:\n"
                             "  - {from: 10, to: 20, place: kitchen}\n"
                             "  - {from: 30, place: Elin's office}\n"
                             "  - {from: 40, to: 50, place: 廊下}\n");
  EXPECT_EQ(labels.at(1009.9), "");
  EXPECT_EQ(labels.at(1010), "kitchen");
  EXPECT_EQ(labels.at(1019.9), "kitchen");
  EXPECT_EQ(labels.at(1020), "");
  EXPECT_EQ(labels.at(1039), "Elin's office");
  EXPECT_EQ(labels.at(1040), "廊下");
  EXPECT_EQ(labels.at(1050), "");
}

TEST_F(LabelFiles, AbsoluteIntervalsInAnyOrder) {
  const Labels labels = read("run.labels.yaml",
                             "times: absolute\n"
                             "labels:\n"
                             "  - {from: 1050, to: 1060, place: b}\n"
                             "  - {from: 900, to: 1050, place: a}\n");
  std::vector<std::tuple<double, double, std::string>> stretches;
  labels.forEach(1000, 1100, [&](double from, double to, const std::string& place) {
    stretches.emplace_back(from, to, place);
  });
  EXPECT_EQ(stretches, (decltype(stretches){{1000, 1050, "a"}, {1050, 1060, "b"}}));
}

TEST_F(LabelFiles, IntervalsOutsideTheBagAreTold) {
  EXPECT_EQ(read("run.labels.yaml", "labels: [{from: 0, to: 100, place: a}]").note(), "");
  const std::string one = "times: absolute\nlabels: [{from: 900, to: 1000, place: a}, ";
  EXPECT_EQ(read("run.labels.yaml", one + "{from: 1050, place: b}]").note(),
            (scratch_ / "run.labels.yaml") +
                ": 1 interval lies outside the bag, which extends from 1000 to 1100 s ('a', 900 to "
                "1000 s); left out.");
  const std::string note =
      read("run.labels.yaml", one + "{from: 1050, to: 1090, place: b}, {from: 1101, place: c}]")
          .note();
  EXPECT_NE(note.find(": 2 intervals lie outside the bag"), std::string::npos) << note;
  EXPECT_NE(note.find("(the first: 'a', 900 to 1000 s); left out"), std::string::npos);
}

TEST_F(LabelFiles, AnEmptyListMeansNoLabels) {
  EXPECT_EQ(read("run.labels.yaml", "labels: []\n").at(1050), "");
  EXPECT_NE(errorIn("run.labels.yaml", "times: relative\n"), "");
  for (const char* text : {"labels:\n", "labels: {}\n"}) {  // possibly unintended
    EXPECT_NE(errorIn("run.labels.yaml", text).find("write 'labels: []'"), std::string::npos);
  }
  EXPECT_NE(errorIn("run.labels.yaml", "times: bag\nlabels: []\n").find("'bag'"),
            std::string::npos);
}

TEST_F(LabelFiles, ColdLinesHoldUntilTheNext) {
  const Labels labels = read("labels.dat",
                             "# timestamp label\n"
                             "1000.5 corridor\n\n"
                             "1010.25\tmeeting room \r\n"
                             "1010.25 kitchen\n");
  EXPECT_EQ(labels.at(1000.4), "");
  EXPECT_EQ(labels.at(1000.5), "corridor");
  EXPECT_EQ(labels.at(1010.2), "corridor");
  EXPECT_EQ(labels.at(1010.25), "kitchen");  // the later of two labels at one time
  EXPECT_EQ(labels.at(1099), "kitchen");
}

TEST_F(LabelFiles, FaultsAreNamed) {
  EXPECT_NE(errorIn("labels.dat", "1000 a\n999 b\n").find("line 2: time runs backwards"),
            std::string::npos);
  EXPECT_NE(errorIn("labels.dat", "1000 a\nkitchen\n").find("line 2"), std::string::npos);
  EXPECT_NE(errorIn("labels.dat", "1000\n").find("line 1"), std::string::npos);
  EXPECT_NE(errorIn("labels.dat", "1000 a\x80\n").find("not a place name"), std::string::npos);
  EXPECT_NE(errorIn("labels.dat", "1000 a\n1001 Unknown\n")
                .find("line 2: the label 'Unknown' is reserved for unknown places"),
            std::string::npos);
  EXPECT_NE(errorIn("labels.dat", "").find("no label falls into the bag"), std::string::npos);
  EXPECT_NE(errorIn("labels.dat", "990 a\n").find("no label falls"), std::string::npos);
  EXPECT_NE(errorIn("labels.dat", "1101 a\n").find("no label falls"), std::string::npos);

  const auto yaml = [this](const std::string& text) { return errorIn("run.labels.yaml", text); };
  EXPECT_NE(yaml("labels: [{from: 0, to: 9, place: a}, {from: 8, place: b}]").find("overlap"),
            std::string::npos);
  EXPECT_NE(yaml("labels: [{from: 8, place: a}, {from: 8, place: b}]").find("'a' and 'b' overlap"),
            std::string::npos);
  EXPECT_NE(yaml("labels: [{place: a}]").find("labels[0]: 'from' is missing"), std::string::npos);
  EXPECT_NE(yaml("labels: [{from: 1, place: a}]\n---\nlabels: [{from: 2, place: b}]").find("---"),
            std::string::npos);
  EXPECT_NE(
      yaml("labels: [{from: 9, to: 8, place: a}]").find("labels[0]: 'from' must be less than 'to'"),
      std::string::npos);
  EXPECT_NE(yaml("labels: [{from: .nan, to: 8, place: a}]"), "");
  EXPECT_NE(yaml("labels: [{from: 1, to: 8, place: \"a\\nb\"}]").find("'a?b'"), std::string::npos);
  EXPECT_NE(yaml("labels: [{from: 1, to: 8}]").find("not a place name"), std::string::npos);
  EXPECT_NE(yaml("labels: [{from: 1, place: unknown}]").find("is reserved for unknown places"),
            std::string::npos);
  EXPECT_NE(yaml("labels: [{from: 1, until: 8, place: a}]").find("until"), std::string::npos);
  EXPECT_NE(yaml("times: bag\nlabels: [{from: 1, place: a}]").find("'bag'"), std::string::npos);
  EXPECT_NE(yaml("labels: [{from: 101, place: a}]").find("no label falls"), std::string::npos);
  EXPECT_NE(yaml("labels: ["), "");
}

/// Reads lines with the times 1000 and 1010, as in each of the files in the tests below.
void expectKitchenThenMeetingRoom(const Labels& labels) {
  EXPECT_EQ(labels.at(999), "");
  EXPECT_EQ(labels.at(1000.5), "kitchen");
  EXPECT_EQ(labels.at(1010), "kitchen");
  EXPECT_EQ(labels.at(1010.5), "meeting room");
}

TEST_F(LabelFiles, ColumnsMayBeSeparatedInSeveralWays) {
  for (const char* text :
       {"1000.5 kitchen\n1010.5 meeting room\n", "1000.5\tkitchen\n1010.5\tmeeting room\n",
        "1000.5,kitchen\n1010.5,meeting room\n", "1000.5, kitchen \n1010.5 ,meeting room\n",
        "1000.5;kitchen\n1010.5;meeting room\n", "1000,5;kitchen\n1010,5;meeting room\n",
        "1000,5\tkitchen\n1010,5\tmeeting room\n",
        "\"1000.5\",\"kitchen\"\n1010.5,\"meeting room\"\n",
        "1000.5 \"kitchen\"\n1010.5 \"meeting room\"\n", "1000.5,kitchen,\n1010.5,meeting room,,\n",
        "sep=;\n1000,5;kitchen\n1010,5;meeting room\n", "1000.5 kitchen\r1010.5 meeting room\r",
        "timestamp label\n1000.5 kitchen\n1010.5 meeting room\n",
        "\"time [s]\";\"room\"\n1000,5;kitchen\n1010,5;meeting room\n",
        "# made by hand\n\nstamp,label\n1000.5,kitchen\n1010.5,meeting room\n",
        "\xef\xbb\xbf"
        "1000.5 kitchen \r\n1010.5  meeting  room\r\n"}) {
    SCOPED_TRACE(text);
    expectKitchenThenMeetingRoom(read("labels.dat", text));
  }
}

TEST_F(LabelFiles, MayBeUtf16) {
  const std::string text = "1000.5 kitchen\r\n1010.5 meeting room\r\n";
  std::string little, big;
  for (const char c : text) {
    little += std::string{c, '\0'};
    big += std::string{'\0', c};
  }
  for (const std::string& bytes : {"\xff\xfe" + little, "\xfe\xff" + big, little, big}) {
    expectKitchenThenMeetingRoom(read("labels.dat", bytes));
  }
}

TEST_F(LabelFiles, NamesMayHoldSeparatorsInQuotes) {
  EXPECT_EQ(read("labels.dat", "1000,\"kitchen, the small one\"\n").at(1001),
            "kitchen, the small one");
  EXPECT_EQ(read("labels.dat", "1000;\"the \"\"lab\"\"\"\n").at(1001), "the \"lab\"");
  EXPECT_EQ(read("labels.dat", "1000 kitchen, the small one\n").at(1001), "kitchen, the small one");
  EXPECT_EQ(read("labels.dat", "1000,101\n").at(1001), "101");
}

TEST_F(LabelFiles, AnEmptyColumnEndsTheLabel) {
  const Labels labels = read("labels.dat", "1000,kitchen\n1010,\n");
  EXPECT_EQ(labels.at(1009), "kitchen");
  EXPECT_EQ(labels.at(1011), "");
}

TEST_F(LabelFiles, TimestampsMayBeInSmallerUnits) {
  const auto labels = [this](const std::string& text) {
    return Labels::fromFile(scratch_.write("labels.dat", text), 1700000000, 1700000100);
  };
  for (const char* zeros : {"", "000", "000000", "000000000"}) {
    const std::string tail = std::string(zeros);
    const Labels read =
        labels("%time,field.data\n1700000000" + tail + ",hall\n1700000010" + tail + ",lab\n");
    EXPECT_EQ(read.at(1700000009), "hall") << zeros;
    EXPECT_EQ(read.at(1700000011), "lab") << zeros;
  }
}

TEST_F(LabelFiles, UnusualWaysAreSaid) {
  EXPECT_EQ(read("labels.dat", "1000 kitchen\n").note(), "");
  EXPECT_NE(read("labels.dat", "1000,kitchen\n").note().find("separated by commas"),
            std::string::npos);
}

TEST_F(LabelFiles, WhatCouldBeMisreadIsRefusedByItsLine) {
  const auto refused = [this](const std::string& text, const std::string& line) {
    const std::string error = errorIn("labels.dat", text);
    EXPECT_NE(error.find("labels.dat, line " + line), std::string::npos) << text << error;
  };
  refused("1000 a\n1010,b\n", "2");                // another separator
  refused("1000,5 kitchen\n", "1");                // a decimal comma, or a name
  refused("1000,5,kitchen\n", "1");                // three columns
  refused("1000.0,kitchen,0.9\n", "1");            // three columns
  refused("1000.0 1700000004.8 kitchen\n", "1");   // start, end, label
  refused("1700000000 500000000 kitchen\n", "1");  // s, ns, label
  refused("2023-11-14 22:13:20,kitchen\n", "1");   // a date
  refused("12:30 kitchen\n", "1");                 // a time of the day
  refused("kitchen 1000.0\n", "1");                // swapped
  refused("kitchen,1000.0\n", "1");
  refused("label,timestamp\nkitchen,1000.0\n", "1");
  refused("1000.0kitchen\n", "1");
  refused("1000,\"kitchen\n", "1");  // an unterminated quote
  refused("1000,\"kitchen\" small\n", "1");
  refused("0x3e8 kitchen\n", "1");
  refused("1000 a\ntimestamp label\n", "2");  // a header in the middle
  refused(std::string(1 << 20, 'k') + "\n", "1");
}

TEST_F(LabelFiles, NamesAreWrittenInOneWay) {
  const Labels labels = read("labels.dat",
                             "1000 Ku\xcc\x88"
                             "che \n1010 K\xc3\xbc"
                             "che\n");
  EXPECT_EQ(labels.at(1005), labels.at(1015));
  EXPECT_EQ(labels.at(1005),
            "K\xc3\xbc"
            "che");
}

TEST(Labels, WholeBag) {
  EXPECT_EQ(Labels::wholeBag("lab").at(0), "lab");
  EXPECT_EQ(Labels::wholeBag("lab").at(1e10), "lab");
  EXPECT_THROW(Labels::wholeBag(std::string(1 << 20, 'x')), Error);
}

TEST(Labels, AnEmptyLabelEndsTheOneBefore) {
  Labels labels;
  labels.add(1, "a");
  labels.add(2, "");
  labels.add(3, "b");
  EXPECT_EQ(labels.at(0.9), "");
  EXPECT_EQ(labels.at(1.5), "a");
  EXPECT_EQ(labels.at(2.5), "");
  EXPECT_EQ(labels.at(3), "b");
}

}  // namespace
}  // namespace place_recognition
