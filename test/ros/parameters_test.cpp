// Parameters as passed by launch files, rosparam and rosrun's command line: XML-RPC values whose
// type depends on what the text looks like.

#include "ros/nodes/parameters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "error_of.h"

namespace place_recognition {
namespace {

using XmlRpc::XmlRpcValue;
using Texts = std::vector<std::string>;

Parameters with(const std::string& name, const XmlRpcValue& value) {
  XmlRpcValue values;
  values[name] = value;
  return Parameters("/node", values);
}

XmlRpcValue listOf(const std::vector<XmlRpcValue>& elements) {
  XmlRpcValue list;
  list.setSize(static_cast<int>(elements.size()));
  for (std::size_t i = 0; i < elements.size(); ++i) list[static_cast<int>(i)] = elements[i];
  return list;
}

XmlRpcValue mapping() {
  XmlRpcValue value;
  value["name"] = "kitchen";
  return value;
}

/// A date, as YAML parses 2024-11-28 10:00:00.
XmlRpcValue date() {
  std::tm time{};
  time.tm_year = 124;
  return XmlRpcValue(&time);
}

void expectSays(const std::string& message, const Texts& parts) {
  for (const std::string& part : parts) {
    EXPECT_NE(message.find(part), std::string::npos) << part << " in: " << message;
  }
}

TEST(Parameters, ThatAreNotSetHaveTheirDefaults) {
  Parameters none("/node", XmlRpcValue());
  EXPECT_TRUE(none.flag("lazy", true));
  EXPECT_EQ(none.integer("threads", 3), 3);
  EXPECT_EQ(none.real("margin", 0.3), 0.3);
  EXPECT_EQ(none.text("model", "rooms"), "rooms");
  EXPECT_EQ(none.texts("places"), Texts());
  EXPECT_EQ(none.integers("buttons"), std::vector<int>());
  EXPECT_TRUE(none.doubts().empty());
}

TEST(Parameters, AreFlagsInEveryWayThatOneIsWritten) {
  for (const XmlRpcValue& yes :
       std::vector<XmlRpcValue>{true, 1, "true", "True", "yes", "on", "1"}) {
    EXPECT_TRUE(with("lazy", yes).flag("lazy", false)) << yes;
  }
  for (const XmlRpcValue& no :
       std::vector<XmlRpcValue>{false, 0, "false", "FALSE", "no", "Off", "0"}) {
    EXPECT_FALSE(with("lazy", no).flag("lazy", true)) << no;
  }
  for (const XmlRpcValue& bad :
       {XmlRpcValue(2), XmlRpcValue(-1), XmlRpcValue(0.5), XmlRpcValue("maybe"), XmlRpcValue(""),
        listOf({true}), mapping(), date()}) {
    expectSays(errorOf([&] { with("lazy", bad).flag("lazy", true); }),
               {"~lazy is ", "give true or false"});
  }
}

TEST(Parameters, AreNumbersOfEitherKindAndWithinTheirLimits) {
  EXPECT_EQ(with("threads", 4).integer("threads", 0), 4);
  EXPECT_EQ(with("threads", 4.0).integer("threads", 0), 4);
  EXPECT_EQ(with("threads", "4").integer("threads", 0), 4);
  EXPECT_EQ(with("margin", 1).real("margin", 0), 1);
  EXPECT_EQ(with("margin", 0.25).real("margin", 0), 0.25);
  EXPECT_EQ(with("margin", "0.25").real("margin", 0), 0.25);
  for (const XmlRpcValue& bad :
       {XmlRpcValue(true), XmlRpcValue("wide"), XmlRpcValue(""), XmlRpcValue("1 m"),
        XmlRpcValue(std::nan("")), XmlRpcValue(INFINITY), XmlRpcValue(".nan"), listOf({1}),
        mapping(), date()}) {
    expectSays(errorOf([&] { with("margin", bad).real("margin", 0); }), {"~margin is ", "number"});
    expectSays(errorOf([&] { with("threads", bad).integer("threads", 0); }),
               {"~threads is ", "give a whole number"});
  }
  for (const XmlRpcValue& bad : {XmlRpcValue(4.5), XmlRpcValue(1e12), XmlRpcValue("4.5")}) {
    expectSays(errorOf([&] { with("threads", bad).integer("threads", 0); }), {"whole number"});
  }
  expectSays(errorOf([] { with("lag", 11).real("lag", 1, 0, 10); }),
             {"~lag is 11; give a number from 0 to 10"});
  expectSays(errorOf([] { with("lag", -0.5).real("lag", 1, 0); }), {"-0.5", "at least 0"});
  expectSays(errorOf([] { with("threads", -1).integer("threads", 1, 0); }), {"-1", "at least 0"});
}

TEST(Parameters, ThatCannotBeUsedAreRefusedWithTheCommandThatDeletesThem) {
  const std::string remedy = "rosparam delete /node/it.";
  expectSays(errorOf([] { with("it", "maybe").flag("it", true); }), {remedy});
  expectSays(errorOf([] { with("it", 11).integer("it", 1, 0, 10); }), {remedy});
  expectSays(errorOf([] { with("it", 11).real("it", 1, 0, 10); }), {remedy});
  expectSays(errorOf([] { with("it", true).text("it"); }), {remedy});
  expectSays(errorOf([] { with("it", listOf({true})).texts("it"); }), {remedy});
  expectSays(errorOf([] { with("it", "left").integers("it"); }), {remedy});
  expectSays(errorOf([] { with("it", 2).reals("it", 0, 1); }), {remedy});
}

TEST(Parameters, AreNamesAlsoIfTheyLookLikeNumbers) {
  EXPECT_EQ(with("model", "rooms").text("model"), "rooms");
  EXPECT_EQ(with("model", 2024).text("model"), "2024");
  EXPECT_EQ(with("model", -7).text("model"), "-7");
  EXPECT_EQ(with("model", 1.5).text("model"), "1.5");
  EXPECT_EQ(with("model", 20241128123.0).text("model"), "20241128123");
  EXPECT_EQ(with("bag", "/my bags/~ run.bag ").text("bag"), "/my bags/~ run.bag ");
  EXPECT_EQ(with("model", "").text("model", "rooms"), "");
  expectSays(errorOf([] { with("model", true).text("model"); }),
             {"~model is the truth value true", "yes and on", "quotes"});
  for (const XmlRpcValue& bad : {XmlRpcValue(std::nan("")), listOf({"rooms"}), mapping(), date()}) {
    expectSays(errorOf([&] { with("model", bad).text("model"); }), {"~model is ", "give a name"});
  }
}

TEST(Parameters, AreListsOfNames) {
  const auto places = [](const XmlRpcValue& value) {
    return with("places", value).texts("places");
  };
  EXPECT_EQ(places(listOf({"kitchen", "corridor"})), (Texts{"kitchen", "corridor"}));
  EXPECT_EQ(places(listOf({101, 102})), (Texts{"101", "102"}));
  EXPECT_EQ(places(listOf({"kitchen", 101, 1.5})), (Texts{"kitchen", "101", "1.5"}));
  EXPECT_EQ(places(listOf({})), Texts());
  EXPECT_EQ(places("kitchen"), Texts{"kitchen"});
  EXPECT_EQ(places("Elin's office, left"), Texts{"Elin's office, left"});
  EXPECT_EQ(places(101), Texts{"101"});
  EXPECT_EQ(places(""), Texts());
  EXPECT_EQ(places(" "), Texts());
}

TEST(Parameters, AreListsWrittenAsText) {  // rosrun and launch files pass lists as text
  const auto places = [](const char* text) { return with("places", text).texts("places"); };
  EXPECT_EQ(places("[kitchen, corridor]"), (Texts{"kitchen", "corridor"}));
  EXPECT_EQ(places("[kitchen, 101, 007, 1.10]"), (Texts{"kitchen", "101", "007", "1.10"}));
  EXPECT_EQ(places("[on, off, Yes, no, true]"), (Texts{"on", "off", "Yes", "no", "true"}));
  EXPECT_EQ(places("['on', \"a, b\", Elin's office]"), (Texts{"on", "a, b", "Elin's office"}));
  EXPECT_EQ(places("[]"), Texts());
  EXPECT_EQ(places("- kitchen\n- 101\n"), (Texts{"kitchen", "101"}));
  EXPECT_EQ(with("buttons", "[3, 1]").integers("buttons"), (std::vector<int>{3, 1}));
  EXPECT_EQ(with("buttons", 3).integers("buttons"), std::vector<int>{3});
  EXPECT_EQ(with("buttons", "3").integers("buttons"), std::vector<int>{3});
  EXPECT_EQ(with("buttons", listOf({3.0, "1"})).integers("buttons"), (std::vector<int>{3, 1}));
}

TEST(Parameters, SayWhichElementOfAListIsWrong) {
  const auto problem = [](const XmlRpcValue& value) {
    return errorOf([&] { with("places", value).texts("places"); });
  };
  expectSays(problem(listOf({"kitchen", true})), {"~places[1] is the truth value true", "quotes"});
  expectSays(problem(listOf({listOf({"kitchen"})})), {"~places[0] is a list", "give a name"});
  expectSays(problem(listOf({"a", mapping()})), {"~places[1] is a mapping", "give a name"});
  expectSays(problem(listOf({date()})), {"~places[0] is a date", "quotes"});
  expectSays(problem(mapping()), {"~places[0] is a mapping"});
  expectSays(problem(true), {"~places[0] is the truth value true"});
  expectSays(problem("[kitchen"), {"~places"});
  expectSays(problem("[[kitchen]]"), {"~places", "a list"});
  expectSays(problem("[{name: kitchen}]"), {"~places", "mapping"});
  expectSays(problem("[kitchen, ~]"), {"~places", "empty"});
  expectSays(errorOf([] {
               with("buttons", listOf({1, "two"})).integers("buttons");
             }),
             {"~buttons[1] is 'two'; give a whole number"});
}

TEST(Parameters, ThatNobodyKnowsAreNamedWithTheNearestThatIsKnown) {
  XmlRpcValue values;
  values["model"] = "rooms";
  values["smothing"] = 1;
  values["colour"] = true;
  Parameters parameters("/node", values);
  parameters.text("model");
  parameters.real("smoothing", 0.2);
  const Texts doubts = parameters.doubts();
  ASSERT_EQ(doubts.size(), 2u);
  expectSays(doubts[0], {"~colour of /node", "known are ~model, ~smoothing."});
  expectSays(doubts[1], {"~smothing of /node", "did you mean ~smoothing?"});
}

TEST(Parameters, ThatMayHaveBeenMeantForAListAreNamed) {
  Parameters parameters = with("places", "kitchen,corridor");
  EXPECT_EQ(parameters.texts("places"), Texts{"kitchen,corridor"});
  const Texts doubts = parameters.doubts();
  ASSERT_EQ(doubts.size(), 1u);
  expectSays(doubts[0], {"~places", "[kitchen,corridor]"});
  Parameters list = with("places", "['left, behind']");
  EXPECT_EQ(list.texts("places"), Texts{"left, behind"});
  EXPECT_EQ(list.doubts().size(), 0u);
}

TEST(Parameters, OfLibrariesAndOfOtherNodesAreNotNamed) {
  XmlRpcValue values;
  values["image_transport"] = "raw";
  values["diagnostic_period"] = 1.0;
  values["num_worker_threads"] = 4;
  values["debug_image"]["compressed"]["jpeg_quality"] = 80;  // image_transport's plugins
  values["train"]["status_frequency"] = 5;                   // actionlib
  values["camera"]["frame_rate"] = 30;                       // a node below this one
  Parameters parameters("/node", values);
  parameters.text("model");
  EXPECT_EQ(parameters.doubts(), Texts());
}

TEST(Parameters, IndentedTooFarAreNamed) {
  XmlRpcValue values;
  values["place_recognizer"]["model"] = "rooms";
  Parameters parameters("/place_recognizer", values);
  parameters.text("model");
  const Texts doubts = parameters.doubts();
  ASSERT_EQ(doubts.size(), 1u);
  expectSays(doubts[0], {"~place_recognizer", "did you mean ~model?"});
}

}  // namespace
}  // namespace place_recognition
