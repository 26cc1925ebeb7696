#pragma once

#include <deque>
#include <string>
#include <vector>

#include "tool/verb.h"

namespace place_recognition::tool {

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

}  // namespace place_recognition::tool
