#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace place_recognition {

/// Which key of a terminal and which button of a joystick says which place. Places are numbered as
/// they are listed: the keys are 1 to 9, then a, b, c ... without q; 0 is no place.
class LabelKeys {
 public:
  /// `buttons[i]` says places[i]; empty: button i does. `no_place_button`: -1 is none.
  LabelKeys(std::vector<std::string> places, std::vector<int> buttons, int no_place_button);

  /// What the key says; nothing: it says nothing.
  std::optional<std::string> placeOfKey(char key) const;

  /// What the button says that is down in `buttons` (0: up) and was not in the call before.
  std::optional<std::string> placeOfButtons(const std::vector<int>& buttons);

  /// As placeName() has them, in order.
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
