#include "ros/nodes/parameter_value.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/options.h"
#include "base/text.h"
#include "place_recognition/error.h"

namespace place_recognition {
namespace {

using XmlRpc::XmlRpcValue;

std::string describe(const XmlRpcValue& value) {
  switch (value.getType()) {
    case XmlRpcValue::TypeBoolean:
      return static_cast<const bool&>(value) ? "the truth value true" : "the truth value false";
    case XmlRpcValue::TypeInt:
      return std::to_string(static_cast<const int&>(value));
    case XmlRpcValue::TypeDouble:
      return shortest(static_cast<const double&>(value));
    case XmlRpcValue::TypeString:
      return inQuotes(static_cast<const std::string&>(value));
    case XmlRpcValue::TypeArray:
      return "a list";
    case XmlRpcValue::TypeStruct:
      return "a mapping";
    case XmlRpcValue::TypeDateTime:
      return "a date";
    case XmlRpcValue::TypeBase64:
      return "binary data";
    default:
      return "nothing";
  }
}

[[noreturn]] void refuse(const XmlRpcValue& value, const std::string& where,
                         const std::string& wanted) {
  throw Error(where + " is " + describe(value) + "; give " + wanted + ".");
}

/// Reads text that is entirely a T.
template <typename T>
bool parse(const XmlRpcValue& value, T& parsed) {
  if (value.getType() != XmlRpcValue::TypeString) return false;
  return YAML::convert<T>::decode(YAML::Node(static_cast<const std::string&>(value)), parsed);
}

bool isYamlList(const std::string& text) {
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  return start != std::string::npos && (text[start] == '[' || text.compare(start, 2, "- ") == 0);
}

std::vector<XmlRpcValue> elementsOf(const std::string& text, const std::string& where) {
  const YAML::Node list = parseYaml(text, where);
  if (!list.IsSequence()) throw Error(where + " is " + inQuotes(text) + "; give a list.");
  std::vector<XmlRpcValue> elements;
  for (const YAML::Node& element : list) {
    if (!element.IsScalar()) {
      throw Error(where + " has an element that is " +
                  (element.IsNull() ? "empty" : "a list or a mapping") + ": " + inQuotes(text) +
                  "; put each element that is not a plain word into quotes.");
    }
    elements.emplace_back(element.Scalar());
  }
  return elements;
}

}  // namespace

bool toFlag(const XmlRpcValue& value, const std::string& where) {
  if (value.getType() == XmlRpcValue::TypeBoolean) return static_cast<const bool&>(value);
  bool flag = false;
  if (parse(value, flag)) return flag;
  int number = 0;
  if (value.getType() == XmlRpcValue::TypeInt) number = static_cast<const int&>(value);
  const bool is_number = value.getType() == XmlRpcValue::TypeInt || parse(value, number);
  if (!is_number || (number != 0 && number != 1)) refuse(value, where, "true or false");
  return number == 1;
}

int toInteger(const XmlRpcValue& value, const std::string& where) {
  if (value.getType() == XmlRpcValue::TypeInt) return static_cast<const int&>(value);
  double number = 0;
  if (value.getType() == XmlRpcValue::TypeDouble) {
    number = static_cast<const double&>(value);
  } else if (!parse(value, number)) {
    refuse(value, where, "a whole number");
  }
  constexpr double kMax = std::numeric_limits<int>::max();
  if (number != std::nearbyint(number) || std::abs(number) > kMax) {  // also true for NaN
    refuse(value, where, "a whole number");
  }
  return static_cast<int>(number);
}

double toReal(const XmlRpcValue& value, const std::string& where) {
  double number = 0;
  if (value.getType() == XmlRpcValue::TypeInt) {
    number = static_cast<const int&>(value);
  } else if (value.getType() == XmlRpcValue::TypeDouble) {
    number = static_cast<const double&>(value);
  } else if (!parse(value, number)) {
    refuse(value, where, "a number");
  }
  if (!std::isfinite(number)) refuse(value, where, "a finite number");
  return number;
}

std::string toText(const XmlRpcValue& value, const std::string& where) {
  if (value.getType() == XmlRpcValue::TypeString) return static_cast<const std::string&>(value);
  if (value.getType() == XmlRpcValue::TypeBoolean) {
    throw Error(where + " is " + describe(value) +
                ", as YAML reads true, yes and on, or false, no and off; put the word into quotes, "
                "such as \"'on'\".");
  }
  const bool is_number =
      value.getType() == XmlRpcValue::TypeInt || (value.getType() == XmlRpcValue::TypeDouble &&
                                                  std::isfinite(static_cast<const double&>(value)));
  if (!is_number) refuse(value, where, "a name, in quotes if it is not a plain word");
  return describe(value);
}

std::vector<XmlRpcValue> toList(const XmlRpcValue& value, const std::string& where) {
  if (value.getType() == XmlRpcValue::TypeArray) {
    std::vector<XmlRpcValue> elements;
    for (int i = 0; i < value.size(); ++i) elements.push_back(value[i]);
    return elements;
  }
  if (value.getType() == XmlRpcValue::TypeString) {
    const auto& text = static_cast<const std::string&>(value);
    if (isYamlList(text)) return elementsOf(text, where);
    if (text.find_first_not_of(" \t\r\n") == std::string::npos) return {};
  }
  return {value};
}

}  // namespace place_recognition
