#include "ros/trainer/train_command.h"

#include <ros/names.h>

#include <algorithm>
#include <map>
#include <regex>
#include <sstream>

#include "base/child_process.h"
#include "base/confined_path.h"
#include "base/contains.h"
#include "base/data_folder.h"
#include "labels/labels.h"
#include "place_recognition/error.h"
#include "place_recognition/learning_options.h"
#include "ros/nodes/message_fields.h"

namespace place_recognition {
namespace {

constexpr std::size_t kMaxBags = 1000;
constexpr std::size_t kMaxRecognizers = 100;
constexpr std::size_t kMaxYamlBytes = 64 * 1024;
constexpr std::size_t kMaxTopicBytes = 256;
constexpr std::uint32_t kMaxVectorLimit = 1000000;
constexpr std::uint32_t kMaxThreads = 1024;

void requireOfGoal(bool sound, const std::string& what) {
  if (!sound) throw Error("The goal's " + what + ".");
}

bool isGraphName(const std::string& name) {
  std::string problem;
  return name.size() <= kMaxTopicBytes && ros::names::validate(name, problem);
}

/// One name, or several separated by commas.
bool areGraphNames(const std::string& names) {
  std::istringstream words(names);
  for (std::string name; std::getline(words, name, ',');) {
    if (!isGraphName(name)) return false;
  }
  return names.size() <= kMaxRecognizers * kMaxTopicBytes;
}

void check(const TrainGoal& goal) {
  requireOfGoal(!goal.bags.empty() || !goal.from_model.empty(), "bags are missing");
  requireOfGoal(goal.bags.size() <= kMaxBags, "bags has more than " + std::to_string(kMaxBags));
  requireOfGoal(isPlainName(goal.model), std::string("model must be ") + kPlainNameRule);
  requireOfGoal(goal.preset.empty() || isPlainName(goal.preset),
                "preset must be the name of a file in config/, such as 'crfh'");
  requireOfGoal(goal.preset.empty() || goal.yaml.empty(), "preset and yaml exclude each other");
  requireOfGoal(goal.yaml.size() <= kMaxYamlBytes,
                "yaml is longer than " + std::to_string(kMaxYamlBytes) + " bytes");
  if (!goal.reduction.empty()) {
    ReductionOptions reduction;
    reduction.method = goal.reduction;
    reduction.check();
  }
  requireOfGoal(goal.add_to.empty() || isPlainName(goal.add_to),
                std::string("add_to must be ") + kPlainNameRule);
  requireOfGoal(
      goal.add_to.empty() || (goal.preset.empty() && goal.yaml.empty() && goal.reduction.empty()),
      "add_to excludes preset, yaml and reduction, which the model defines");
  requireOfGoal(goal.from_model.empty() || isPlainName(goal.from_model),
                std::string("from_model must be ") + kPlainNameRule);
  requireOfGoal(goal.from_model.empty() || !goal.add_to.empty(), "from_model needs add_to");
  requireOfGoal(
      !goal.calibrate || (goal.preset.empty() && goal.yaml.empty() && goal.reduction.empty() &&
                          goal.add_to.empty() && goal.validate.empty()),
      "calibrate excludes preset, yaml, reduction, add_to and validate");
  requireOfGoal(goal.validate.size() <= kMaxBags,
                "validate has more than " + std::to_string(kMaxBags) + " bags");
  requireOfGoal(goal.vector_limit == 0 || !goal.add_to.empty(), "vector_limit needs add_to");
  requireOfGoal(goal.vector_limit <= kMaxVectorLimit,
                "vector_limit is more than " + std::to_string(kMaxVectorLimit));
  requireOfGoal(goal.forgetting >= 0 && goal.forgetting <= 0.99, "forgetting is not in 0..0.99");
  requireOfGoal(goal.forgetting == 0 || goal.vector_limit > 0, "forgetting needs vector_limit");
  requireOfGoal(goal.threads <= kMaxThreads, "threads is more than " + std::to_string(kMaxThreads));
  requireOfGoal(areGraphNames(goal.image_topic), "image_topic is not the name of a topic");
  requireOfGoal(isGraphName(goal.label_topic), "label_topic is not the name of a topic");
  requireOfGoal(goal.label.empty() || goal.label_topic.empty(),
                "label and label_topic exclude each other");
  if (!goal.label.empty()) checkLabel(goal.label, "The goal");
  requireOfGoal(!contains(goal.recognizers, ""), "recognizers has an empty name");
  requireOfGoal(goal.recognizers.size() <= kMaxRecognizers,
                "recognizers has more than " + std::to_string(kMaxRecognizers));
  requireOfGoal(std::all_of(goal.recognizers.begin(), goal.recognizers.end(), isGraphName),
                "recognizers are not names of nodes");
}

/// Fields that do not correspond to an option of place_tool with the same name.
const std::vector<std::string> kOtherFields = {
    "bags", "validate", "preset", "yaml", "reduction", "vector_limit", "calibrate", "recognizers"};

/// `--image-topic` for image_topic.
std::string optionOf(std::string field) {
  std::replace(field.begin(), field.end(), '_', '-');
  return "--" + field;
}

/// The fields of a goal by their options.
std::map<std::string, std::string> fieldsByOption() {
  std::map<std::string, std::string> fields{
      {"--limit", "vector_limit"}, {"--config", "preset or yaml"}, {"--set", "reduction"}};
  for (const MessageField& field : fieldsOf(TrainGoal())) {
    fields.emplace(optionOf(field.name), field.name);
  }
  return fields;
}

}  // namespace

std::vector<std::string> trainCommand(const TrainGoal& goal,
                                      const std::vector<std::string>& bag_roots,
                                      const std::string& yaml_path) {
  check(goal);
  std::vector<std::string> command = {findExecutable("place_tool"),
                                      goal.calibrate ? "calibrate" : "train"};
  for (const std::string& bag : goal.bags) command.push_back(confinedBagPath(bag, bag_roots));
  for (const std::string& bag : goal.validate) {
    command.push_back("--validate=" + confinedBagPath(bag, bag_roots));
  }
  // A value joined to its option cannot be mistaken for another option.
  const auto add = [&command](const std::string& option, const std::string& value) {
    if (!value.empty()) command.push_back(option + "=" + value);
  };
  for (const MessageField& field : fieldsOf(goal)) {
    if (contains(kOtherFields, field.name)) continue;
    for (const std::string& value : field.values) {
      const bool is_unset = field.type != "string" && value == "0";
      if (!is_unset) add(optionOf(field.name), value);
    }
  }
  add("--config", goal.yaml.empty() ? goal.preset : yaml_path);
  add("--set", goal.reduction.empty() ? "" : "reduction.method=" + goal.reduction);
  add("--limit", goal.vector_limit == 0 ? "" : std::to_string(goal.vector_limit));
  command.insert(command.end(), {"--progress=json", "--json=-"});
  return command;
}

std::string inTermsOfGoal(const std::string& message) {
  static const std::map<std::string, std::string> fields = fieldsByOption();
  static const std::regex option("--[a-z-]+"), program("^place_tool[a-z ]*: ");
  const std::string text = std::regex_replace(message, program, "");
  std::string result;
  auto end = text.cbegin();
  for (std::sregex_iterator match(text.begin(), text.end(), option), none; match != none; ++match) {
    result.append(end, (*match)[0].first);
    end = (*match)[0].second;
    const auto field = fields.find(match->str());
    result += field == fields.end() ? match->str() : field->second;
  }
  return result.append(end, text.cend());
}

}  // namespace place_recognition
