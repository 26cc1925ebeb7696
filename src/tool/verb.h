#pragma once

#include <deque>
#include <functional>
#include <map>
#include <string>
#include <type_traits>
#include <utility>

#include "tool/option.h"

namespace place_recognition::tool {

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
  void checkFiles(const Given& given) const;

  std::string name_;
  std::string summary_;
  std::string footer_;
  bool hidden_ = false;
  std::deque<Option> options_;
  std::deque<Option> arguments_;
  std::function<void()> work_;
};

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
