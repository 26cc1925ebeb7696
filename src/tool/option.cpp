#include "tool/option.h"

#include <algorithm>
#include <boost/algorithm/string.hpp>

#include "base/contains.h"
#include "base/text.h"
#include "base/user_path.h"
#include "tool/usage_text.h"

namespace place_recognition::tool {

Option& Option::required() {
  required_ = true;
  return *this;
}

Option& Option::many() {
  many_ = true;
  return *this;
}

Option& Option::commaSeparated() {
  comma_separated_ = true;
  return *this;
}

Option& Option::oneOf(Values choices) {
  checks_.push_back([choices = std::move(choices)](const std::string& text) {
    if (contains(choices, text)) return;
    throw UsageError("'" + text + "' is not one of " + orList(choices));
  });
  return *this;
}

Option& Option::range(double min, double max) {
  checks_.push_back([min, max](const std::string& text) {
    const auto value = parseValue<double>(text);
    if (min <= value && value <= max) return;
    throw UsageError("'" + text + "' is not within " + significant(min, 10) + ".." +
                     significant(max, 10));
  });
  return *this;
}

Option& Option::positive() {
  checks_.push_back([](const std::string& text) {
    if (!(parseValue<double>(text) > 0)) throw UsageError("'" + text + "' is not positive");
  });
  return *this;
}

Option& Option::written() {
  written_ = true;
  return *this;
}

Option& Option::checked(std::function<void(const std::string&)> check) {
  checks_.push_back(std::move(check));
  return *this;
}

Option& Option::needs(const std::string& other) {
  needs_.push_back(other);
  return *this;
}

Option& Option::excludes(const std::string& other) {
  excludes_.push_back(other);
  return *this;
}

Option& Option::group(const std::string& title) {
  group_ = title;
  return *this;
}

/// "--model NAME", "INPUT...".
std::string Option::signature() const {
  if (name_ != value_) return name_ + (value_.empty() ? "" : " " + value_) + (many_ ? "..." : "");
  return name_ + (kind_ == Kind::kList ? "..." : "");
}

/// Its meaning, and the rules that concern other options.
std::string Option::meaningAndRules() const {
  Values rules;
  if (required_) rules.push_back("required");
  if (!needs_.empty()) rules.push_back("needs " + boost::join(needs_, ", "));
  if (!excludes_.empty()) rules.push_back("not with " + boost::join(excludes_, ", "));
  return meaning_ + (rules.empty() ? "" : " (" + boost::join(rules, "; ") + ")");
}

void Option::assign(const Values& words) const {
  Values values = words;
  for (std::string& value : values) {
    if (startsWith(value, "~/"))
      value = userPath(value);  // a shell leaves --option=~/file as it is
  }
  if (comma_separated_) {
    values.clear();
    for (const std::string& word : words) {
      Values parts;
      boost::split(parts, word, boost::is_any_of(","));
      values.insert(values.end(), parts.begin(), parts.end());
    }
  }
  try {
    for (const auto& check : checks_) std::for_each(values.begin(), values.end(), check);
    store_(values);
    if (contains(values, "")) {
      throw UsageError("the value is empty; give one, or omit the option");
    }
  } catch (const UsageError& e) {
    throw UsageError(name_ + ": " + e.what());
  }
}

}  // namespace place_recognition::tool
