// Keys and buttons for labelling places.

#include "labels/label_keys.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "error_of.h"
#include "place_recognition/error.h"

namespace place_recognition {
namespace {

const std::vector<std::string> kPlaces = {"kitchen", "corridor"};

TEST(LabelKeys, DigitsSayPlacesInTheirOrder) {
  const LabelKeys keys(kPlaces, {}, -1);
  EXPECT_EQ(keys.placeOfKey('1'), "kitchen");
  EXPECT_EQ(keys.placeOfKey('2'), "corridor");
  EXPECT_EQ(keys.placeOfKey('0'), "");
  EXPECT_EQ(keys.placeOfKey('3'), std::nullopt);
  EXPECT_EQ(keys.placeOfKey('q'), std::nullopt);
  EXPECT_EQ(keys.placeOfKey('\n'), std::nullopt);
  EXPECT_EQ(keys.help(), "1 kitchen, 2 corridor, 0 no place");
}

TEST(LabelKeys, NamesAreTidied) {
  const LabelKeys keys({" Ku\u0308che ", "meeting\u00a0 room"}, {}, -1);
  EXPECT_EQ(keys.placeOfKey('1'), "K\u00fcche");
  EXPECT_EQ(keys.placeOfKey('2'), "meeting room");
}

TEST(LabelKeys, APlaceHasOneKey) {
  EXPECT_THROW(LabelKeys({"kitchen", "corridor", "kitchen "}, {}, -1), Error);
}

TEST(LabelKeys, LettersFollowTheDigits) {
  std::vector<std::string> many;
  for (int i = 0; i < 34; ++i) many.push_back("room" + std::to_string(i));
  const LabelKeys keys(many, {}, -1);
  EXPECT_EQ(keys.placeOfKey('9'), "room8");
  EXPECT_EQ(keys.placeOfKey('a'), "room9");
  EXPECT_EQ(keys.placeOfKey('z'), "room33");
  many.push_back("one more");
  EXPECT_THROW(LabelKeys(many, {}, -1), Error);
}

TEST(LabelKeys, AButtonSpeaksOnceWhenItIsPressed) {
  LabelKeys keys(kPlaces, {}, 4);
  EXPECT_EQ(keys.placeOfButtons({0, 0, 0, 0, 0}), std::nullopt);
  EXPECT_EQ(keys.placeOfButtons({0, 1, 0, 0, 0}), "corridor");
  EXPECT_EQ(keys.placeOfButtons({0, 1, 0, 0, 0}), std::nullopt);  // still down
  EXPECT_EQ(keys.placeOfButtons({1, 1, 0, 0, 0}), "kitchen");
  EXPECT_EQ(keys.placeOfButtons({0, 0, 0, 0, 1}), "");
  EXPECT_EQ(keys.placeOfButtons({0, 0, 0, 1, 0}), std::nullopt);  // assigned to no place
  EXPECT_EQ(keys.placeOfButtons({}), std::nullopt);
}

TEST(LabelKeys, ButtonsCanBeChosen) {
  LabelKeys keys(kPlaces, {5, 3}, -1);
  EXPECT_EQ(keys.placeOfButtons({1, 0, 0, 0, 0, 0}), std::nullopt);
  EXPECT_EQ(keys.placeOfButtons({0, 0, 0, 0, 0, 1}), "kitchen");
  EXPECT_THROW(LabelKeys(kPlaces, {1}, -1), Error);
  EXPECT_THROW(LabelKeys({"kitchen", "hall"}, {3, 3}, -1), Error);
  EXPECT_THROW(LabelKeys({"kitchen", "hall"}, {}, 1), Error);
  EXPECT_THROW(LabelKeys({"unknown"}, {}, -1), Error);
}

TEST(LabelKeys, ButtonsCountFromZero) {
  for (const int button : {-5, -1}) {
    EXPECT_EQ(errorOf([&] {
                LabelKeys(kPlaces, {0, button}, -1);
              }),
              "The parameter ~buttons has " + std::to_string(button) +
                  "; give numbers from 0, the first button.");
  }
}

}  // namespace
}  // namespace place_recognition
