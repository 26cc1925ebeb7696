#include "labels/label_keys.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "base/place_name.h"
#include "labels/labels.h"
#include "place_recognition/error.h"

namespace place_recognition {
namespace {

const std::string kKeys = "123456789abcdefghijklmnoprstuvwxyz";  // q ends the node
constexpr char kNoPlaceKey = '0';

}  // namespace

LabelKeys::LabelKeys(std::vector<std::string> places, std::vector<int> buttons, int no_place_button)
    : places_(std::move(places)), buttons_(std::move(buttons)), no_place_button_(no_place_button) {
  std::set<std::string> known;
  for (std::string& place : places_) {
    checkLabel(place, "The parameter ~places");
    place = placeName(place);
    if (!known.insert(place).second) {
      throw Error("The parameter ~places names '" + place + "' twice; name each place once.");
    }
  }
  if (places_.size() > kKeys.size()) {
    throw Error("The parameter ~places lists more than " + std::to_string(kKeys.size()) +
                " places; list those of this run.");
  }
  if (buttons_.empty()) {
    buttons_.resize(places_.size());
    std::iota(buttons_.begin(), buttons_.end(), 0);
  }
  for (const int button : buttons_) {
    if (button >= 0) continue;
    throw Error("The parameter ~buttons has " + std::to_string(button) +
                "; give numbers from 0, the first button.");
  }
  if (buttons_.size() != places_.size()) {
    throw Error("The parameter ~buttons must have one button for each of ~places.");
  }
  std::set<int> meanings{no_place_button_};
  for (const int button : buttons_) {
    if (meanings.insert(button).second) continue;
    throw Error("The parameters ~buttons and ~no_place_button use button " +
                std::to_string(button) + " twice; give each one meaning.");
  }
}

std::optional<std::string> LabelKeys::placeOfKey(char key) const {
  if (key == kNoPlaceKey) return "";
  const std::size_t i = kKeys.find(key);
  if (i >= places_.size()) return std::nullopt;
  return places_[i];
}

std::optional<std::string> LabelKeys::placeOfButtons(const std::vector<int>& buttons) {
  std::optional<std::string> place;
  for (std::size_t i = 0; i < buttons.size() && !place; ++i) {
    const bool was_down = i < last_buttons_.size() && last_buttons_[i] != 0;
    if (buttons[i] != 0 && !was_down) place = placeOfButton(static_cast<int>(i));
  }
  last_buttons_ = buttons;
  return place;
}

std::optional<std::string> LabelKeys::placeOfButton(int button) const {
  if (button == no_place_button_) return "";
  const auto found = std::find(buttons_.begin(), buttons_.end(), button);
  if (found == buttons_.end()) return std::nullopt;
  return places_[static_cast<std::size_t>(found - buttons_.begin())];
}

std::string LabelKeys::help() const {
  std::string text;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    text += std::string(1, kKeys[i]) + " " + places_[i] + ", ";
  }
  return text + kNoPlaceKey + " no place";
}

}  // namespace place_recognition
