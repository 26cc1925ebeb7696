#pragma once

#include <boost/lexical_cast/try_lexical_convert.hpp>
#include <cmath>
#include <deque>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace place_recognition::tool {

/// Bad usage. The message says what is wrong, without a full stop, so that a hint on help can
/// follow.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

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
  std::vector<std::function<void(const std::string&)>> checks_;
  std::vector<std::string> needs_;
  std::vector<std::string> excludes_;
  std::function<void(const Values&)> store_;
};

/// One verb of place_tool: its options and its work. The targets of the options must outlive it.
class Verb {
 public:
  Verb(std::string name, std::string summary);

  /// `--name VALUE`. `target` may be a string, a number, or a vector of strings: then the option
  /// may be repeated.
  template <typename T>
  Option& option(const std::string& name, const std::string& value, T& target,
                 const std::string& meaning);

  /// `--name`, which sets `target` to `meant`.
  Option& flag(const std::string& name, bool& target, const std::string& meaning,
               bool meant = true);

  /// A word without a name, in the order of declaration. Required unless `required` is false. A
  /// vector takes all remaining words, so it must be last.
  template <typename T>
  Option& argument(const std::string& name, T& target, const std::string& meaning,
                   bool required = true);

  /// The end of --help: an example.
  void footer(std::string text) { footer_ = std::move(text); }
  /// Omits the verb from the list of verbs.
  void hide() { hidden_ = true; }
  /// The work: throws UsageError, Error for bad input, Cancelled after a signal.
  void run(std::function<void()> work) { work_ = std::move(work); }

 private:
  friend class CommandLine;

  Option& add(std::deque<Option>& where, const std::string& name, const std::string& value,
              const std::string& meaning);
  template <typename T>
  static void bind(Option& option, T& target);

  using Given = std::map<std::string, Option::Values>;  // by name of the option or argument

  Option::Values optionNames() const;
  bool isList(const std::string& name) const;
  std::string help(const std::string& program) const;
  /// Sets the targets. Throws UsageError.
  void parse(const Option::Values& words) const;
  Given readOptions(const Option::Values& words, Option::Values& arguments) const;
  void readArguments(const Option::Values& words, Given& given) const;
  void check(const Given& given) const;

  std::string name_;
  std::string summary_;
  std::string footer_;
  bool hidden_ = false;
  std::deque<Option> options_;
  std::deque<Option> arguments_;
  std::function<void()> work_;
};

/// The verbs of a program; each run executes one. Boost.Program_options reads the words; this adds
/// verbs, dependencies between options, and a suggestion for a misspelt name.
class CommandLine {
 public:
  CommandLine(std::string program, std::string summary, std::string version);

  /// A name may be two words: "network add".
  Verb& verb(const std::string& name, const std::string& summary);

  /// Executes what the words request: a verb's work, --help or --version. Throws UsageError, and
  /// whatever the work throws.
  void run(const std::vector<std::string>& words);

  /// The program and, once run() knows it, the verb: "place_tool train".
  const std::string& name() const { return name_; }

 private:
  const Verb* takeVerb(std::vector<std::string>& words) const;
  [[noreturn]] void refuse(const std::vector<std::string>& words) const;
  std::vector<std::string> verbNames() const;
  std::string help(const std::string& first_word) const;

  std::string program_;
  std::string name_;
  std::string summary_;
  std::string version_;
  std::deque<Verb> verbs_;
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

template <typename T>
Option& Verb::option(const std::string& name, const std::string& value, T& target,
                     const std::string& meaning) {
  Option& option = add(options_, name, value, meaning);
  bind(option, target);
  return option;
}

template <typename T>
Option& Verb::argument(const std::string& name, T& target, const std::string& meaning,
                       bool required) {
  Option& argument = add(arguments_, name, name, meaning);
  argument.required_ = required;
  bind(argument, target);
  return argument;
}

template <typename T>
void Verb::bind(Option& option, T& target) {
  if constexpr (std::is_same_v<T, Option::Values>) {
    option.kind_ = Option::Kind::kList;
    option.store_ = [&target](const Option::Values& values) { target = values; };
  } else {
    option.store_ = [&target](const Option::Values& values) {
      target = parseValue<T>(values.at(0));
    };
  }
}

}  // namespace place_recognition::tool
