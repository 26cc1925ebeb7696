// Labels from files, and what is refused.

#include "ros/labels.h"

#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <vector>

#include "place_recognition/error.h"
#include "scratch_folder.h"

namespace place_recognition {
namespace {

class LabelFiles : public testing::Test {
 protected:
  /// Labels of a bag that lasts from 1000 to 1100 s.
  Labels read(const std::string& name, const std::string& text) {
    return Labels::fromFile(scratch_.write(name, text), 1000, 1100);
  }

  std::string errorOf(const std::string& name, const std::string& text) {
    try {
      read(name, text);
    } catch (const Error& e) {
      return e.what();
    }
    return "";
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

TEST_F(LabelFiles, ColdLinesHoldUntilTheNext) {
  const Labels labels = read("labels.dat",
                             "# timestamp label\n"
                             "1000.5 corridor\n\n"
                             "1010.25\tmeeting room \r\n"
                             "1010.25 kitchen\n");
  EXPECT_EQ(labels.at(1000.4), "");
  EXPECT_EQ(labels.at(1000.5), "corridor");
  EXPECT_EQ(labels.at(1010.2), "corridor");
  EXPECT_EQ(labels.at(1010.25), "kitchen");  // of two at one time the later
  EXPECT_EQ(labels.at(1099), "kitchen");
}

TEST_F(LabelFiles, FaultsAreNamed) {
  EXPECT_NE(errorOf("labels.dat", "1000 a\n999 b\n").find("line 2: time runs backwards"),
            std::string::npos);
  EXPECT_NE(errorOf("labels.dat", "1000 a\nkitchen\n").find("line 2"), std::string::npos);
  EXPECT_NE(errorOf("labels.dat", "1000\n").find("line 1"), std::string::npos);
  EXPECT_NE(errorOf("labels.dat", "1000 a\x80\n").find("no place name"), std::string::npos);
  EXPECT_NE(errorOf("labels.dat", "").find("no label falls into the bag"), std::string::npos);
  EXPECT_NE(errorOf("labels.dat", "990 a\n").find("no label falls"), std::string::npos);
  EXPECT_NE(errorOf("labels.dat", "1101 a\n").find("no label falls"), std::string::npos);

  const auto yaml = [this](const std::string& text) { return errorOf("run.labels.yaml", text); };
  EXPECT_NE(yaml("labels: [{from: 0, to: 9, place: a}, {from: 8, place: b}]").find("overlap"),
            std::string::npos);
  EXPECT_NE(yaml("labels: [{from: 9, to: 8, place: a}]").find("labels[0]: from must lie before"),
            std::string::npos);
  EXPECT_NE(yaml("labels: [{from: .nan, to: 8, place: a}]"), "");
  EXPECT_NE(yaml("labels: [{from: 1, to: 8, place: \"a\\nb\"}]").find("'a?b'"), std::string::npos);
  EXPECT_NE(yaml("labels: [{from: 1, to: 8}]").find("no place name"), std::string::npos);
  EXPECT_NE(yaml("labels: [{from: 1, until: 8, place: a}]").find("until"), std::string::npos);
  EXPECT_NE(yaml("times: bag\nlabels: [{from: 1, place: a}]").find("'bag'"), std::string::npos);
  EXPECT_NE(yaml("labels: [{from: 101, place: a}]").find("no label falls"), std::string::npos);
  EXPECT_NE(yaml("labels: ["), "");
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
