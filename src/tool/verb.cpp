#include "tool/verb.h"

#include <algorithm>
#include <boost/program_options.hpp>
#include <filesystem>
#include <sstream>

#include "base/contains.h"
#include "base/nearest_name.h"
#include "tool/usage_text.h"

namespace place_recognition::tool {
namespace {

namespace po = boost::program_options;
namespace fs = std::filesystem;

/// Whether two paths name one regular file, which need not exist yet.
bool areOneFile(const std::string& a, const std::string& b) {
  if (a.empty() || b.empty()) return false;
  std::error_code ignored;
  if (fs::exists(a, ignored)) return fs::is_regular_file(a) && fs::equivalent(a, b, ignored);
  return fs::absolute(a).lexically_normal() == fs::absolute(b).lexically_normal();
}

}  // namespace

Verb::Verb(std::string name, std::string summary)
    : name_(std::move(name)), summary_(std::move(summary)) {}

Option& Verb::flag(const std::string& name, bool& target, const std::string& meaning, bool meant) {
  Option& flag = add(options_, name, "", meaning);
  flag.kind_ = Option::Kind::kFlag;
  flag.store_ = [&target, meant](const Option::Values&) { target = meant; };
  return flag;
}

Option& Verb::add(std::deque<Option>& where, const std::string& name, const std::string& value,
                  const std::string& meaning) {
  Option& option = where.emplace_back();
  option.name_ = name;
  option.value_ = value;
  option.meaning_ = meaning;
  return option;
}

Words Verb::optionNames() const {
  Words names = {"--help"};
  for (const Option& option : options_) names.push_back(option.name_);
  return names;
}

std::string Verb::help(const std::string& program) const {
  std::ostringstream out;
  out << summary_ << "\nUsage: " << program << " " << name_ << " [OPTIONS]";
  for (const Option& argument : arguments_) out << " " << argument.signature();
  out << "\n";
  if (!arguments_.empty()) out << "\nArguments:\n";
  for (const Option& argument : arguments_) {
    printRow(argument.name_, argument.meaning_, out);
  }
  Words groups = {"Options"};
  for (const Option& option : options_) {
    if (!contains(groups, option.group_)) groups.push_back(option.group_);
  }
  for (const std::string& group : groups) {
    out << "\n" << group << ":\n";
    if (group == "Options") printRow("-h, --help", "Print this and exit", out);
    for (const Option& option : options_) {
      if (option.group_ == group) {
        printRow(option.signature(), option.meaningAndRules(), out);
      }
    }
  }
  if (!footer_.empty()) out << "\n" << footer_ << "\n";
  return out.str();
}

void Verb::parse(const Words& words) const {
  Words arguments;
  Given given = readOptions(words, arguments);
  readArguments(arguments, given);
  check(given);
  checkFiles(given);
  for (const std::deque<Option>* list : {&options_, &arguments_}) {
    for (const Option& option : *list) {
      const auto found = given.find(option.name_);
      if (found != given.end()) option.assign(found->second);
    }
  }
}

bool Verb::isList(const std::string& name) const {
  return std::any_of(options_.begin(), options_.end(), [&](const Option& option) {
    return option.name_ == name && option.kind_ == Option::Kind::kList;
  });
}

Verb::Given Verb::readOptions(const Words& words, Words& arguments) const {
  po::options_description known;
  for (const Option& option : options_) {
    const std::string name = option.name_.substr(2);
    auto* semantic = po::value<Words>();
    if (option.kind_ == Option::Kind::kFlag) semantic->zero_tokens();
    if (option.many_) semantic->multitoken();
    known.add_options()(name.c_str(), semantic);
  }
  constexpr int kStyle =
      po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;
  Given given;
  try {
    const po::parsed_options parsed =
        po::command_line_parser(words).options(known).style(kStyle).run();
    for (const po::option& part : parsed.options) {
      if (part.position_key >= 0) {
        arguments.insert(arguments.end(), part.value.begin(), part.value.end());
        continue;
      }
      const std::string name = "--" + part.string_key;
      const auto [entry, is_new] = given.emplace(name, part.value);
      if (is_new) continue;
      if (!isList(name)) throw UsageError(name + " is given twice");
      entry->second.insert(entry->second.end(), part.value.begin(), part.value.end());
    }
  } catch (const po::unknown_option& e) {
    const std::string name = e.get_option_name();
    throw UsageError("there is no option " + name + suggestion(name, optionNames()));
  } catch (const po::error& e) {
    throw UsageError(e.what());
  }
  return given;
}

void Verb::readArguments(const Words& words, Given& given) const {
  auto word = words.begin();
  for (const Option& argument : arguments_) {
    const bool all = argument.kind_ == Option::Kind::kList;
    const auto end = all || word == words.end() ? words.end() : word + 1;
    if (word != end) given.emplace(argument.name_, Words(word, end));
    word = end;
  }
  if (word != words.end()) throw UsageError("unexpected argument '" + *word + "'");
}

void Verb::check(const Given& given) const {
  for (const std::deque<Option>* list : {&options_, &arguments_}) {
    for (const Option& option : *list) {
      if (given.count(option.name_) == 0) {
        if (option.required_) throw UsageError(option.signature() + " is required");
        continue;
      }
      for (const std::string& other : option.needs_) {
        if (given.count(other) == 0) throw UsageError(option.name_ + " needs " + other);
      }
      for (const std::string& other : option.excludes_) {
        if (given.count(other) != 0)
          throw UsageError(option.name_ + " cannot be combined with " + other);
      }
    }
  }
}

void Verb::checkFiles(const Given& given) const {
  for (const Option& option : options_) {
    const auto own = given.find(option.name_);
    if (!option.written_ || own == given.end()) continue;
    const std::string& file = own->second.front();
    for (const auto& [other, values] : given) {
      const bool is_named_too =
          other != option.name_ &&
          std::any_of(values.begin(), values.end(),
                      [&](const std::string& value) { return areOneFile(file, value); });
      if (is_named_too) {
        throw UsageError(option.name_ + " and " + other + " name the same file, " + file);
      }
    }
  }
}

}  // namespace place_recognition::tool
