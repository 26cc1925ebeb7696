#include "tool/command_line.h"

#include <algorithm>
#include <boost/algorithm/string.hpp>
#include <iostream>
#include <sstream>

#include "base/nearest_name.h"
#include "tool/usage_text.h"

namespace place_recognition::tool {
namespace {

bool asksForHelp(const Words& words) {
  const auto end = std::find(words.begin(), words.end(), "--");
  return std::any_of(words.begin(), end,
                     [](const std::string& word) { return word == "--help" || word == "-h"; });
}

}  // namespace

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

/// The verb whose name is at the start of `words`; removes the name.
const Verb* CommandLine::takeVerb(Words& words) const {
  for (const Verb& verb : verbs_) {
    Words name;
    boost::split(name, verb.name_, boost::is_any_of(" "));
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
