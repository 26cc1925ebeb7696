#include "tool/command_line.h"

#include <algorithm>
#include <boost/algorithm/string.hpp>
#include <boost/program_options.hpp>
#include <iostream>
#include <sstream>

#include "base/nearest_name.h"

namespace place_recognition::tool {
namespace {

namespace po = boost::program_options;
using Words = std::vector<std::string>;

/// " (did you mean X?)", if one of `known` is near enough to have been meant.
std::string suggestion(const std::string& word, const Words& known) {
  const std::string meant = nearestName(word, known);
  return meant.empty() ? "" : " (did you mean " + meant + "?)";
}

Words split(const std::string& text, const char* separator) {
  Words parts;
  boost::split(parts, text, boost::is_any_of(separator));
  return parts;
}

std::string orList(const Words& choices) {
  std::string text = choices.front();
  for (std::size_t i = 1; i < choices.size(); ++i) {
    text += (i + 1 < choices.size() ? ", " : " or ") + choices[i];
  }
  return text;
}

bool asksForHelp(const Words& words) {
  const auto end = std::find(words.begin(), words.end(), "--");
  return std::any_of(words.begin(), end,
                     [](const std::string& word) { return word == "--help" || word == "-h"; });
}

/// A name, and beside it what it means, in lines of 96 columns.
void printRow(const std::string& name, const std::string& meaning, std::ostream& out) {
  constexpr std::size_t kColumn = 30;
  constexpr std::size_t kWidth = 96;
  const std::string indent(kColumn, ' ');
  std::string line = "  " + name;
  line += line.size() + 1 < kColumn ? std::string(kColumn - line.size(), ' ') : "\n" + indent;
  std::size_t column = kColumn;
  std::istringstream words(meaning);
  for (std::string word; words >> word; column += word.size() + 1) {
    if (column + word.size() > kWidth) {
      line += "\n" + indent;
      column = kColumn;
    }
    line += word + " ";
  }
  boost::replace_all(line, " \n", "\n");
  out << boost::trim_right_copy(line) << "\n";
}

}  // namespace

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
    if (std::find(choices.begin(), choices.end(), text) != choices.end()) return;
    throw UsageError("'" + text + "' is none of " + orList(choices));
  });
  return *this;
}

Option& Option::range(double min, double max) {
  checks_.push_back([min, max](const std::string& text) {
    const auto value = parseValue<double>(text);
    if (min <= value && value <= max) return;
    std::ostringstream what;
    what.precision(10);
    what << "'" << text << "' is not within " << min << ".." << max;
    throw UsageError(what.str());
  });
  return *this;
}

Option& Option::positive() {
  checks_.push_back([](const std::string& text) {
    if (!(parseValue<double>(text) > 0)) throw UsageError("'" + text + "' is not positive");
  });
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

/// What it means, and the rules beside those for its value.
std::string Option::meaningAndRules() const {
  Values rules;
  if (required_) rules.push_back("required");
  if (!needs_.empty()) rules.push_back("needs " + boost::join(needs_, ", "));
  if (!excludes_.empty()) rules.push_back("not with " + boost::join(excludes_, ", "));
  return meaning_ + (rules.empty() ? "" : " (" + boost::join(rules, "; ") + ")");
}

void Option::assign(const Values& words) const {
  Values values = words;
  if (comma_separated_) {
    values.clear();
    for (const std::string& word : words) {
      const Values parts = split(word, ",");
      values.insert(values.end(), parts.begin(), parts.end());
    }
  }
  try {
    for (const auto& check : checks_) std::for_each(values.begin(), values.end(), check);
    store_(values);
    if (std::find(values.begin(), values.end(), "") != values.end()) {
      throw UsageError("the value is empty; give one, or leave the option out");
    }
  } catch (const UsageError& e) {
    throw UsageError(name_ + ": " + e.what());
  }
}

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
    if (std::find(groups.begin(), groups.end(), option.group_) == groups.end()) {
      groups.push_back(option.group_);
    }
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
  if (word != words.end()) throw UsageError("there is no use for the argument '" + *word + "'");
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
        if (given.count(other) != 0) throw UsageError(option.name_ + " does not go with " + other);
      }
    }
  }
}

CommandLine::CommandLine(std::string program, std::string summary, std::string version)
    : program_(std::move(program)),
      name_(program_),
      summary_(std::move(summary)),
      version_(std::move(version)) {}

Verb& CommandLine::verb(const std::string& name, const std::string& summary) {
  return verbs_.emplace_back(name, summary);
}

void CommandLine::run(const Words& arguments) {
  if (!arguments.empty() && arguments.front() == "--version") {
    std::cout << version_ << std::endl;
    return;
  }
  Words words = arguments;
  const Verb* verb = takeVerb(words);
  if (verb != nullptr) name_ += " " + verb->name_;
  if (asksForHelp(words)) {
    std::cout << (verb ? verb->help(program_) : help(words.front())) << std::flush;
    return;
  }
  if (verb == nullptr) refuse(words);
  verb->parse(words);
  verb->work_();
}

/// The verb whose name `words` begin with; takes the name away.
const Verb* CommandLine::takeVerb(Words& words) const {
  for (const Verb& verb : verbs_) {
    const Words name = split(verb.name_, " ");
    if (words.size() < name.size() || !std::equal(name.begin(), name.end(), words.begin()))
      continue;
    words.erase(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(name.size()));
    return &verb;
  }
  return nullptr;
}

/// The help text on all verbs, or on those of two words that begin with `first_word`.
std::string CommandLine::help(const std::string& first_word) const {
  const Words names = verbNames();
  const bool is_group = std::any_of(names.begin(), names.end(), [&](const std::string& name) {
    return boost::starts_with(name, first_word + " ");
  });
  std::ostringstream out;
  out << summary_ << "\nUsage: " << program_ << " VERB [OPTIONS]\n\nOptions:\n";
  printRow("-h, --help", "Print this, or the help of a verb, and exit", out);
  printRow("--version", "Print the version and exit", out);
  out << "\nVerbs:\n";
  for (const Verb& verb : verbs_) {
    if (verb.hidden_ || (is_group && !boost::starts_with(verb.name_, first_word + " "))) continue;
    printRow(verb.name_, verb.summary_, out);
  }
  return out.str();
}

void CommandLine::refuse(const Words& words) const {
  if (words.empty()) throw UsageError("a verb is required");
  const std::string& word = words.front();
  if (boost::starts_with(word, "-"))
    throw UsageError("there is no option " + word + " before a verb");
  Words second;
  for (const std::string& name : verbNames()) {
    if (boost::starts_with(name, word + " ")) second.push_back(name.substr(word.size() + 1));
  }
  if (!second.empty()) throw UsageError(word + " is followed by " + orList(second));
  throw UsageError("there is no verb " + word + suggestion(word, verbNames()));
}

Words CommandLine::verbNames() const {
  Words names;
  for (const Verb& verb : verbs_) {
    if (!verb.hidden_) names.push_back(verb.name_);
  }
  return names;
}

}  // namespace place_recognition::tool
