#include "tool/command_line.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace place_recognition::tool {
namespace {

using Words = std::vector<std::string>;

/// A tool with one verb and options of every kind.
class CommandLineTest : public testing::Test {
 protected:
  CommandLineTest() : tool_("tool", "Does things.", "1.2") {
    Verb& verb = tool_.verb("bake", "Bakes a cake");
    verb.argument("FLOUR", flour_, "The first word");
    verb.argument("REST", rest_, "All other words", false);
    verb.option("--minutes", "N", minutes_, "How long").range(1, 90);
    verb.option("--heat", "T", heat_, "How hot").positive();
    verb.option("--seed", "N", seed_, "Of the poppy");
    verb.option("--shape", "NAME", shape_, "round or square").oneOf({"round", "square"});
    verb.option("--with", "THING", with_, "May be repeated");
    verb.option("--guests", "NAME", guests_, "All that follow").many();
    verb.option("--colours", "LIST", colours_, "a,b,c").commaSeparated();
    verb.option("--icing", "TASTE", icing_, "On top").needs("--shape").excludes("--plain");
    verb.flag("--plain", plain_, "No icing");
    verb.run([this] { ++runs_; });
    for (const char* name : {"shelf add", "shelf list"}) {
      tool_.verb(name, "Two words").run([this] { ++runs_; });
    }
  }

  void run(const Words& words) { tool_.run(words); }

  /// Returns the error for `words`.
  std::string problem(const Words& words) {
    try {
      tool_.run(words);
    } catch (const UsageError& e) {
      EXPECT_EQ(runs_, 0) << "nothing is done by half";
      return e.what();
    }
    return "";
  }

  static bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  }

  CommandLine tool_;
  std::string flour_;
  Words rest_;
  int minutes_ = 30;
  double heat_ = 180;
  std::uint64_t seed_ = 7;
  std::string shape_ = "round";
  Words with_;
  Words guests_;
  Words colours_ = {"white"};
  std::string icing_;
  bool plain_ = false;
  int runs_ = 0;
};

TEST_F(CommandLineTest, WhatIsNotGivenKeepsItsDefault) {
  run({"bake", "rye"});
  EXPECT_EQ(flour_, "rye");
  EXPECT_TRUE(rest_.empty());
  EXPECT_EQ(minutes_, 30);
  EXPECT_EQ(colours_, Words{"white"});
  EXPECT_FALSE(plain_);
  EXPECT_EQ(runs_, 1);
  EXPECT_EQ(tool_.name(), "tool bake");
}

TEST_F(CommandLineTest, OptionsAndArgumentsMix) {
  run({"bake", "--minutes", "45", "rye", "--heat=1e2", "salt", "--seed", "18446744073709551615",
       "--with", "nuts", "water", "--with=figs", "--plain", "--colours", "red,green", "--guests",
       "Ada", "Bo"});
  EXPECT_EQ(flour_, "rye");
  EXPECT_EQ(rest_, (Words{"salt", "water"}));
  EXPECT_EQ(minutes_, 45);
  EXPECT_EQ(heat_, 100);
  EXPECT_EQ(seed_, UINT64_MAX);
  EXPECT_EQ(with_, (Words{"nuts", "figs"}));
  EXPECT_EQ(colours_, (Words{"red", "green"}));
  EXPECT_EQ(guests_, (Words{"Ada", "Bo"}));
  EXPECT_TRUE(plain_);
}

TEST_F(CommandLineTest, BehindTwoDashesEveryWordIsAnArgument) {
  run({"bake", "--", "--plain", "--help"});
  EXPECT_EQ(flour_, "--plain");
  EXPECT_EQ(rest_, Words{"--help"});
  EXPECT_FALSE(plain_);
}

TEST_F(CommandLineTest, OneDashIsAnOrdinaryWord) {
  run({"bake", "-", "--icing", "-", "--shape", "round"});
  EXPECT_EQ(flour_, "-");
  EXPECT_EQ(icing_, "-");
}

TEST_F(CommandLineTest, ValuesThatDoNotFitAreRefused) {
  for (const Words& words :
       {Words{"--minutes", "0"}, Words{"--minutes", "91"}, Words{"--minutes", "-3"},
        Words{"--minutes", "1.5"}, Words{"--minutes", "ten"}, Words{"--minutes", ""},
        Words{"--minutes", "5 "}, Words{"--heat", "0"}, Words{"--heat", "-1"},
        Words{"--heat", "nan"}, Words{"--heat", "inf"}, Words{"--seed", "-1"},
        Words{"--seed", "18446744073709551616"}, Words{"--shape", "oval"}, Words{"--shape", ""}}) {
    const std::string message = problem({"bake", "rye", words[0], words[1]});
    EXPECT_TRUE(has(message, words[0] + ": '" + words[1] + "' is n")) << message;
  }
}

TEST_F(CommandLineTest, RulesBetweenOptions) {
  EXPECT_EQ(problem({"bake", "rye", "--icing", "lemon"}), "--icing needs --shape");
  EXPECT_EQ(problem({"bake", "rye", "--icing", "lemon", "--shape", "round", "--plain"}),
            "--icing cannot be combined with --plain");
  EXPECT_EQ(problem({"bake", "rye", "--heat", "1", "--heat", "2"}), "--heat is given twice");
  EXPECT_EQ(problem({"bake"}), "FLOUR is required");
}

TEST_F(CommandLineTest, ValuesThatAreMissingOrTooMany) {
  EXPECT_TRUE(has(problem({"bake", "rye", "--heat"}), "--heat"));
  EXPECT_TRUE(has(problem({"bake", "rye", "--heat", "--plain"}), "--heat"));
  EXPECT_TRUE(has(problem({"bake", "rye", "--heat="}), "--heat"));
  EXPECT_TRUE(has(problem({"bake", "rye", "--plain=yes"}), "--plain"));
  EXPECT_TRUE(has(problem({"shelf", "add", "rye"}), "'rye'"));
}

TEST_F(CommandLineTest, AMisspeltNameIsRefusedWithTheOneMeant) {
  EXPECT_EQ(problem({"bake", "rye", "--minuets", "4"}),
            "there is no option --minuets (did you mean --minutes?)");
  EXPECT_EQ(problem({"bake", "rye", "--minute", "4"}),  // a prefix is not the name
            "there is no option --minute (did you mean --minutes?)");
  EXPECT_EQ(problem({"bake", "rye", "--temperature", "4"}), "there is no option --temperature");
  EXPECT_EQ(problem({"bake", "rye", "-x"}), "there is no option -x");
  EXPECT_TRUE(has(problem({"bake", "rye", "--FLOUR", "4"}), "--FLOUR"));
  EXPECT_EQ(problem({"bkae"}), "there is no verb bkae (did you mean bake?)");
  EXPECT_EQ(problem({"dance"}), "there is no verb dance");
}

TEST_F(CommandLineTest, VerbsOfTwoWords) {
  run({"shelf", "list"});
  EXPECT_EQ(tool_.name(), "tool shelf list");
}

TEST_F(CommandLineTest, HalfAVerbIsRefusedWithItsOtherHalves) {
  EXPECT_EQ(problem({"shelf"}), "shelf is followed by add or list");
  EXPECT_EQ(problem({"shelf", "lits"}), "shelf is followed by add or list");
  EXPECT_EQ(problem({}), "a verb is required");
}

TEST_F(CommandLineTest, HelpNamesEverythingAndNeedsNothing) {
  testing::internal::CaptureStdout();
  run({"bake", "--help"});
  const std::string help = testing::internal::GetCapturedStdout();
  for (const char* part : {"Bakes a cake", "Usage: tool bake [OPTIONS] FLOUR REST...",
                           "--minutes N", "--guests NAME...", "--plain", "The first word",
                           "round or square", "On top (needs --shape; not with --plain)"}) {
    EXPECT_TRUE(has(help, part)) << part << "\n" << help;
  }
  EXPECT_EQ(runs_, 0);
}

TEST_F(CommandLineTest, HelpOfHalfAVerbListsItsOtherHalves) {
  testing::internal::CaptureStdout();
  run({"shelf", "--help"});
  const std::string help = testing::internal::GetCapturedStdout();
  EXPECT_TRUE(has(help, "shelf add"));
  EXPECT_FALSE(has(help, "bake"));
}

}  // namespace
}  // namespace place_recognition::tool
