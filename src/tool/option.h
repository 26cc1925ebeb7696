#pragma once

#include <boost/lexical_cast/try_lexical_convert.hpp>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace place_recognition::tool {

/// Bad usage. The message says what is wrong, without a full stop, so that a hint on help can
/// follow.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The number that `text` represents, or the text itself. Throws UsageError.
template <typename T>
T parseValue(const std::string& text) {
  if constexpr (std::is_same_v<T, std::string>) {
    return text;
  } else {
    static_assert(std::is_arithmetic_v<T>);
    T value{};
    // A conversion to an unsigned number would turn -1 into a huge one.
    const bool wraps = std::is_unsigned_v<T> && text.find('-') != std::string::npos;
    if (wraps || !boost::conversion::try_lexical_convert(text, value) ||
        !std::isfinite(static_cast<double>(value))) {
      throw UsageError("'" + text + "' is not a" + (std::is_integral_v<T> ? " whole" : "") +
                       " number" + (wraps ? " from 0" : "") + " that fits");
    }
    return value;
  }
}

/// An option, or an argument without a name, of a verb, with the rules for its value.
class Option {
 public:
  using Values = std::vector<std::string>;

  Option& required();
  /// A list takes all following values, not just one per occurrence.
  Option& many();
  /// A list takes its values from one word: a,b,c.
  Option& commaSeparated();
  Option& oneOf(Values choices);
  /// Includes both ends.
  Option& range(double min, double max);
  Option& positive();
  /// The value is a file to write, which must not be one that another option or argument names.
  Option& written();
  /// `check` throws if a value is invalid.
  Option& checked(std::function<void(const std::string&)> check);
  /// Options that must, or must not, be given with this one.
  Option& needs(const std::string& other);
  Option& excludes(const std::string& other);
  /// The title under which --help lists this option, instead of "Options".
  Option& group(const std::string& title);

 private:
  friend class Verb;
  enum class Kind { kFlag, kValue, kList };

  std::string signature() const;
  std::string meaningAndRules() const;
  void assign(const Values& words) const;

  std::string name_;     // "--model", or "INPUT" of an argument
  std::string value_;    // the value's name in --help: "NAME"
  std::string meaning_;  // for --help
  std::string group_ = "Options";
  Kind kind_ = Kind::kValue;
  bool required_ = false;
  bool many_ = false;
  bool comma_separated_ = false;
  bool written_ = false;
  std::vector<std::function<void(const std::string&)>> checks_;
  std::vector<std::string> needs_;
  std::vector<std::string> excludes_;
  std::function<void(const Values&)> store_;
};

}  // namespace place_recognition::tool
