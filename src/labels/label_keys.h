#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace place_recognition {

/// Maps keys of a terminal and buttons of a joystick to places. Places are numbered in the order of
/// the list: the keys are 1 to 9, then a, b, c ... without q; 0 means no place.
class LabelKeys {
 public:
  /// `buttons[i]` selects places[i]; if `buttons` is empty, button i does. `no_place_button`: -1
  /// means none.
  LabelKeys(std::vector<std::string> places, std::vector<int> buttons, int no_place_button);

  /// The place that the key selects; nothing if the key has no meaning.
  std::optional<std::string> placeOfKey(char key) const;

  /// The place selected by the button that is down in `buttons` (0: up) and was up in the previous
  /// call.
  std::optional<std::string> placeOfButtons(const std::vector<int>& buttons);

  /// Normalized by placeName(), in order.
  const std::vector<std::string>& places() const { return places_; }

  /// "1 kitchen, 2 corridor, 0 no place".
  std::string help() const;

 private:
  std::optional<std::string> placeOfButton(int button) const;

  std::vector<std::string> places_;
  std::vector<int> buttons_;
  int no_place_button_;
  std::vector<int> last_buttons_;
};

}  // namespace place_recognition
