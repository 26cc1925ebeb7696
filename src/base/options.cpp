#include "base/options.h"

#include <cmath>
#include <set>
#include <sstream>

#include "base/atomic_file.h"
#include "base/contains.h"
#include "base/nearest_name.h"
#include "base/text.h"
#include "base/yaml_guard.h"

namespace place_recognition {

namespace options_detail {
namespace {

std::string inside(const std::string& where) {
  return where.empty() ? "the configuration" : "'" + where + "'";
}

/// What may stand instead of `key`.
std::string choices(const std::string& key, const std::vector<std::string>& known) {
  return suggestion(key, known) + "; the known ones are: " + listed(known) + ".";
}

template <typename T>
bool decode(const YAML::Node& node, T& value) {
  if (!node.IsScalar()) return false;
  // Versions of yaml-cpp before 0.7 read -1 as the largest unsigned number.
  if (std::is_unsigned_v<T> && node.Scalar().find('-') != std::string::npos) return false;
  return YAML::convert<T>::decode(node, value);
}

template <typename T>
void readAs(const YAML::Node& node, const std::string& where, const char* kind, T& value) {
  if (!decode(node, value)) {
    const std::string text = node.IsScalar() ? "'" + node.Scalar() + "'"
                             : node.IsNull() ? "empty"
                                             : "a list or mapping";
    throw Error("Option '" + where + "' is " + text + "; give " + kind + ".");
  }
}

}  // namespace

void throwUnknownKey(const std::string& key, const std::string& where,
                     const std::vector<std::string>& known) {
  throw Error("Unknown option '" + key + "' in " + inside(where) + choices(key, known));
}

void throwUnknownType(const std::string& type, const std::string& where,
                      const std::vector<std::string>& known) {
  throw Error("Unknown type '" + type + "' in " + inside(where) + choices(type, known));
}

void requireMapping(const YAML::Node& node, const std::string& where) {
  if (!node.IsMap()) throw Error("Expected 'key: value' lines in " + inside(where) + ".");
}

void requireRenamed(const YAML::Node& node, const char* former_key, const char* key,
                    const std::string& where) {
  if (!node[key]) return;
  throw Error("Option '" + std::string(former_key) + "' in " + inside(where) + " is now named '" +
              key + "'; give only that.");
}

void requireContents(const YAML::Node& node, const std::string& where) {
  if (!node.IsMap() || node.size() > 0) return;
  throw Error("Option '" + where + "' is empty; give its keys, or leave it out.");
}

void requireKnownKeys(const YAML::Node& node, const std::vector<std::string>& known,
                      const std::string& where) {
  std::set<std::string> seen;
  for (const auto& entry : node) {
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "?";
    if (!contains(known, key)) throwUnknownKey(key, where, known);
    if (!seen.insert(key).second) {
      throw Error("Option '" + key + "' occurs twice in " + inside(where) + "; keep one.");
    }
  }
}

void readScalar(const YAML::Node& node, const std::string& where, bool& value) {
  readAs(node, where, "true or false", value);
}

void readScalar(const YAML::Node& node, const std::string& where, int& value) {
  readAs(node, where, "a whole number", value);
}

void readScalar(const YAML::Node& node, const std::string& where, std::uint64_t& value) {
  readAs(node, where, "a whole number from 0", value);
}

void readScalar(const YAML::Node& node, const std::string& where, double& value) {
  readAs(node, where, "a number", value);
  if (!std::isfinite(value))
    throw Error("Option '" + where + "' is not finite; give a finite number.");
}

void readScalar(const YAML::Node& node, const std::string& where, std::string& value) {
  readAs(node, where, "a word", value);
}

}  // namespace options_detail

namespace {

/// The names of the values in a mapping, or of the elements of a list.
std::vector<std::string> namesIn(const YAML::Node& parent) {
  std::vector<std::string> names;
  for (const auto& child : parent) {
    if (parent.IsMap()) {
      names.push_back(child.first.Scalar());
    } else if (child.IsMap() && child["name"]) {
      names.push_back(child["name"].Scalar());
    }
  }
  return names;
}

/// The value of `key` in a mapping, or the element of a list with the name or index `key`; not
/// defined if there is none.
YAML::Node childOf(YAML::Node parent, const std::string& key) {
  if (parent.IsMap()) return parent[key];
  for (std::size_t i = 0; parent.IsSequence() && i < parent.size(); ++i) {
    const YAML::Node element = parent[i];
    const bool named = element.IsMap() && element["name"] && element["name"].Scalar() == key;
    if (named || key == std::to_string(i)) return element;
  }
  return YAML::Node(YAML::NodeType::Undefined);
}

}  // namespace

YAML::Node parseYaml(const std::string& text, const std::string& where) {
  try {
    requireModestYaml(text, where);
    const std::vector<YAML::Node> documents = YAML::LoadAll(text);
    for (std::size_t i = 1; i < documents.size(); ++i) {
      if (documents[i].IsNull()) continue;
      throw Error(where +
                  " contains several YAML documents, of which only one would be read; remove "
                  "the others or the lines '---'.");
    }
    return documents.empty() ? YAML::Node() : documents.front();
  } catch (const YAML::Exception& e) {
    throw Error(where + " is not valid YAML: " + e.what() + ".");
  }
}

YAML::Node readYamlFile(const std::string& path) {
  constexpr std::size_t kMaxFileSize = 64 << 20;
  return parseYaml(toUtf8(readFile(path, kMaxFileSize)), path);
}

void assignOption(const YAML::Node& root, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw Error("'" + assignment + "' sets no option; write key=value, such as svm.c=10.");
  }
  YAML::Node node = root;
  std::string where;
  std::istringstream path(assignment.substr(0, equals));
  for (std::string key; std::getline(path, key, '.');) {
    const YAML::Node child = childOf(node, key);
    const bool is_reported_later = node.IsMap() && path.eof();  // with the known keys
    if (!child.IsDefined() && !is_reported_later) {
      const std::vector<std::string> names = namesIn(node);
      throw Error("'" + assignment + "' sets no option: there is no '" + key + "'" +
                  (where.empty() ? "" : " in '" + where + "'") +
                  (names.empty() ? "; set " + where + " as a whole."
                                 : options_detail::choices(key, names)));
    }
    node.reset(child);
    where += (where.empty() ? "" : ".") + key;
  }
  node = parseYaml(assignment.substr(equals + 1), "'" + assignment + "'");
}

}  // namespace place_recognition
