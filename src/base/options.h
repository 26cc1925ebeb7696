#pragma once

#include <yaml-cpp/yaml.h>

#include <cstdint>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "base/text.h"
#include "place_recognition/error.h"

/// Reading, writing and documenting option structs as YAML. A struct takes part by listing its
/// fields in a static member template visit(self, visitor), see feature_options.h. If a key was
/// renamed, its former name follows the comment: it is read, but not written. Supported
/// fields: bool, int, std::uint64_t, double, std::string, other such structs, std::vector of any of
/// these, and std::variant of structs, whose alternative is named by the key `type` and kType.
namespace place_recognition {

namespace options_detail {

template <typename T, typename = void>
struct IsStruct : std::false_type {};
struct AnyVisitor {
  template <typename T>
  void operator()(const char*, T&, const char*, const char* = nullptr) {}
};
template <typename T>
struct IsStruct<T, std::void_t<decltype(T::visit(std::declval<T&>(), AnyVisitor{}))>>
    : std::true_type {};

template <typename T>
struct IsVector : std::false_type {};
template <typename T>
struct IsVector<std::vector<T>> : std::true_type {};

template <typename T>
struct IsVariant : std::false_type {};
template <typename... T>
struct IsVariant<std::variant<T...>> : std::true_type {};

[[noreturn]] void throwUnknownKey(const std::string& key, const std::string& where,
                                  const std::vector<std::string>& known);
[[noreturn]] void throwUnknownType(const std::string& type, const std::string& where,
                                   const std::vector<std::string>& known);
/// Throws unless `node` is a mapping.
void requireMapping(const YAML::Node& node, const std::string& where);
/// Throws if the mapping `node` has a key and also its former name.
void requireRenamed(const YAML::Node& node, const char* former_key, const char* key,
                    const std::string& where);
/// Throws for a mapping without keys, whose defaults would replace those of the list that it is in.
void requireContents(const YAML::Node& node, const std::string& where);
/// Throws for a key of the mapping `node` that is not in `known`, or that occurs twice.
void requireKnownKeys(const YAML::Node& node, const std::vector<std::string>& known,
                      const std::string& where);

void readScalar(const YAML::Node& node, const std::string& where, bool& value);
void readScalar(const YAML::Node& node, const std::string& where, int& value);
void readScalar(const YAML::Node& node, const std::string& where, std::uint64_t& value);
void readScalar(const YAML::Node& node, const std::string& where, double& value);
void readScalar(const YAML::Node& node, const std::string& where, std::string& value);

template <typename T>
void read(const YAML::Node& node, const std::string& where, T& value);

/// Reads the fields that `node` has; the others keep their values.
struct FieldReader {
  const YAML::Node& node;
  const std::string& where;
  std::vector<std::string>& known;

  template <typename T>
  void operator()(const char* key, T& field, const char* /*comment*/,
                  const char* former_key = nullptr) {
    known.emplace_back(key);
    if (former_key && node[former_key]) {
      requireRenamed(node, former_key, key, where);
      known.emplace_back(former_key);
      key = former_key;
    }
    if (const YAML::Node child = node[key]) {
      read(child, where.empty() ? key : where + "." + key, field);
    }
  }
};

template <typename T>
void readStruct(const YAML::Node& node, const std::string& where, T& value,
                std::vector<std::string> known = {}) {
  requireMapping(node, where);
  T::visit(value, FieldReader{node, where, known});
  requireKnownKeys(node, known, where);
}

template <typename Variant, std::size_t I = 0>
void readVariant(const YAML::Node& node, const std::string& where, const std::string& type,
                 Variant& value, std::vector<std::string> tried = {}) {
  if constexpr (I == std::variant_size_v<Variant>) {
    throwUnknownType(type, where, tried);
  } else {
    using T = std::variant_alternative_t<I, Variant>;
    if (type == T::kType) {
      if (value.index() != I) value.template emplace<I>();
      readStruct(node, where, std::get<I>(value), {"type"});
    } else {
      tried.emplace_back(T::kType);
      readVariant<Variant, I + 1>(node, where, type, value, std::move(tried));
    }
  }
}

template <typename T>
void readElement(const YAML::Node& node, const std::string& where, T& value) {
  if constexpr (IsStruct<T>::value) requireContents(node, where);
  read(node, where, value);
}

template <typename T>
void readVector(const YAML::Node& node, const std::string& where, std::vector<T>& values) {
  values.clear();
  if (!node.IsSequence()) {  // One element may stand without brackets.
    readElement(node, where, values.emplace_back());
    return;
  }
  for (std::size_t i = 0; i < node.size(); ++i) {
    readElement(node[i], where + "[" + std::to_string(i) + "]", values.emplace_back());
  }
}

template <typename T>
void read(const YAML::Node& node, const std::string& where, T& value) {
  if constexpr (IsStruct<T>::value) {
    readStruct(node, where, value);
  } else if constexpr (IsVector<T>::value) {
    readVector(node, where, value);
  } else if constexpr (IsVariant<T>::value) {
    requireMapping(node, where);
    std::string type = std::visit([](const auto& v) { return std::string(v.kType); }, value);
    if (const YAML::Node child = node["type"]) readScalar(child, where + ".type", type);
    readVariant(node, where, type, value);
  } else {
    readScalar(node, where, value);
  }
}

template <typename T>
YAML::Node write(const T& value);

struct FieldWriter {
  YAML::Node& node;

  template <typename T>
  void operator()(const char* key, const T& field, const char* /*comment*/,
                  const char* /*former_key*/ = nullptr) {
    node[key] = write(field);
  }
};

template <typename T>
YAML::Node write(const T& value) {
  YAML::Node node;
  if constexpr (IsStruct<T>::value) {
    T::visit(value, FieldWriter{node});
  } else if constexpr (IsVector<T>::value) {
    node = YAML::Node(YAML::NodeType::Sequence);
    for (const auto& element : value) node.push_back(write(element));
    using Element = typename T::value_type;
    if (!IsStruct<Element>::value) node.SetStyle(YAML::EmitterStyle::Flow);
  } else if constexpr (IsVariant<T>::value) {
    std::visit(
        [&node](const auto& v) {
          node["type"] = v.kType;
          std::decay_t<decltype(v)>::visit(v, FieldWriter{node});
        },
        value);
  } else if constexpr (std::is_same_v<T, double>) {
    node = shortest(value);
  } else {
    node = value;
  }
  return node;
}

}  // namespace options_detail

/// Overwrites the fields of `options` that `node` names. Throws Error for a key that does not exist
/// (listing the existing ones) or a value of the wrong kind; `where` names the source in messages.
template <typename Options>
void readOptions(const YAML::Node& node, const std::string& where, Options& options) {
  if (!node || node.IsNull()) return;
  options_detail::read(node, where, options);
}

/// All fields of `options` as YAML text, from which readOptions() restores equal options.
template <typename Options>
std::string writeOptions(const Options& options) {
  YAML::Emitter out;
  out << options_detail::write(options);
  return std::string(out.c_str()) + "\n";
}

/// Parses YAML text; throws Error naming `where` and the line if it is not YAML.
YAML::Node parseYaml(const std::string& text, const std::string& where);

/// Reads a YAML file; throws Error if it cannot be read or is not YAML.
YAML::Node readYamlFile(const std::string& path);

/// Applies `assignment`, "key.key=value", to a tree of options before it is read. An element of a
/// list is addressed by its index from 0 or, if the elements have one, by its `name`. Throws Error
/// if the text does not have this form.
void assignOption(const YAML::Node& root, const std::string& assignment);

}  // namespace place_recognition
