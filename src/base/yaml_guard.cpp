#include "base/yaml_guard.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <sstream>

#include "place_recognition/error.h"

namespace place_recognition {
namespace {

/// Follows the parser, which calls this class before it descends to the next level.
class ModestYaml : public YAML::EventHandler {
 public:
  explicit ModestYaml(const std::string& where) : where_(where) {}

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    throw Error(where_ + " has an alias ('*') in line " + std::to_string(mark.line + 1) +
                "; write the value out.");
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {
    enter(mark);
  }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {
    enter(mark);
  }
  void OnSequenceEnd() override { --depth_; }
  void OnMapEnd() override { --depth_; }

  /// yaml-cpp does not pass a sign with which nothing begins, such as a comma, and finds documents
  /// in front of it without end.
  void OnDocumentStart(const YAML::Mark& mark) override {
    if (mark.pos == document_) {
      throw Error(where_ + " is not valid YAML: unexpected sign in line " +
                  std::to_string(mark.line + 1) + ", column " + std::to_string(mark.column + 1) +
                  ".");
    }
    document_ = mark.pos;
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t,
                const std::string&) override {}

 private:
  void enter(const YAML::Mark& mark) {
    constexpr int kMaxDepth = 50;
    if (++depth_ > kMaxDepth) {
      throw Error(where_ + " is nested too deeply in line " + std::to_string(mark.line + 1) +
                  "; it is not a configuration.");
    }
  }

  const std::string& where_;
  int depth_ = 0;
  int document_ = -1;  // its position
};

}  // namespace

void requireModestYaml(const std::string& text, const std::string& where) {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  ModestYaml guard(where);
  while (parser.HandleNextDocument(guard)) continue;
}

}  // namespace place_recognition
