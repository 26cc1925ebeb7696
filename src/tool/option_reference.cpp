#include <algorithm>
#include <iostream>

#include "base/options.h"
#include "place_recognition/training_options.h"
#include "place_recognition/tuning.h"
#include "tool/verbs.h"

namespace place_recognition::tool {
namespace {

using options_detail::IsStruct;
using options_detail::IsVariant;
using options_detail::IsVector;

constexpr const char* kIntroduction =
    R"(# Configuration

<!-- Written by `place_tool document` from the comments in include/place_recognition. -->

`place_tool train --config FILE` accepts a YAML file with the keys below, or the name of a preset in
`config/`. A key that the file lacks keeps its default. `--set KEY=VALUE` overrides one key, for
example `--set svm.multiclass=one-against-one`; a cue is addressed by its name, for example
`--set cues.edges.kernel.type=intersection`. Unknown keys are refused. A list of cues in a file replaces the
default list: `colours`, `tints`, `edges`, `shapes` and `directions`, as in `config/default.yaml`. The model stores
the options that it was trained with; `place_tool info` shows them.
)";

constexpr const char* kSearchSpace =
    "The search space of `place_tool tune --space FILE`: a YAML file of these keys, each with its "
    "default.";

/// YAML on one line.
template <typename T>
std::string flowText(const T& value) {
  YAML::Emitter out;
  out.SetSeqFormat(YAML::Flow);
  out.SetMapFormat(YAML::Flow);
  out << options_detail::write(value);
  return out.c_str();
}

/// The comment as a separate sentence.
std::string sentence(std::string text) {
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text + ".";
}

/// A link to the section titled `path`, with GitHub's form of anchors.
std::string linkTo(const std::string& path) {
  std::string anchor = path;
  anchor.erase(std::remove(anchor.begin(), anchor.end(), '.'), anchor.end());
  return "; see [" + path + "](#" + anchor + ")";
}

/// Collects one table of keys per struct of options, in the order of declaration.
class Reference {
 public:
  /// `path`: the keys from the top level; empty there.
  template <typename Options>
  void add(const std::string& title, const std::string& path, const std::string& comment,
           const Options& options) {
    const std::size_t own = sections_.size();
    sections_.push_back("\n## " + title + "\n\n" + comment +
                        "\n\n| key | default | meaning |\n| --- | --- | --- |\n");
    Options::visit(options, [&](const char* key, const auto& field, const std::string& meaning,
                                const char* /*former_key*/ = nullptr) {
      addField(own, key, path.empty() ? key : path + "." + key, field, meaning);
    });
  }

  void print(std::ostream& out) const {
    for (const std::string& section : sections_) out << section;
  }

 private:
  template <typename Field>
  void addField(std::size_t own, const std::string& key, const std::string& path,
                const Field& field, const std::string& meaning) {
    if constexpr (IsStruct<Field>::value) {
      addRow(own, key, "", meaning + linkTo(path));
      add(path, path, sentence(meaning), field);
    } else if constexpr (IsVariant<Field>::value) {
      addRow(own, key, "", meaning + "; its `type` selects one of the tables of " + path);
      addAlternatives<Field>(path, meaning);
    } else if constexpr (IsVector<Field>::value) {
      addList(own, key, path, field, meaning);
    } else {
      addRow(own, key, flowText(field), meaning);
    }
  }

  template <typename Element>
  void addList(std::size_t own, const std::string& key, const std::string& path,
               const std::vector<Element>& field, const std::string& meaning) {
    if constexpr (IsStruct<Element>::value) {
      const std::string value = flowText(field);
      constexpr std::size_t kLongest =
          100;  // longer defaults are left to the table of the elements
      addRow(own, key, value.size() <= kLongest ? value : "", meaning + linkTo(path));
      add(path, path, "A list: " + meaning + ".", Element());
    } else {
      addRow(own, key, flowText(field), meaning);
    }
  }

  template <typename Variant, std::size_t I = 0>
  void addAlternatives(const std::string& path, const std::string& meaning) {
    if constexpr (I < std::variant_size_v<Variant>) {
      using Alternative = std::variant_alternative_t<I, Variant>;
      add(path + ", type: " + Alternative::kType, path, sentence(meaning), Alternative());
      addAlternatives<Variant, I + 1>(path, meaning);
    }
  }

  void addRow(std::size_t section, const std::string& key, const std::string& value,
              const std::string& meaning) {
    std::string escaped;
    for (const char c : meaning) escaped += c == '|' ? "\\|" : std::string(1, c);
    sections_[section] +=
        "| `" + key + "` | " + (value.empty() ? "" : "`" + value + "`") + " | " + escaped + " |\n";
  }

  std::vector<std::string> sections_;
};

}  // namespace

void addDocument(CommandLine& tool) {
  Verb& verb = tool.verb("document", "Prints doc/configuration.md");
  verb.hide();  // For developers of the options.
  verb.run([] {
    Reference reference;
    reference.add("Top level", "", "The options of `train`.", TrainingOptions());
    reference.add("Search space", "", kSearchSpace, SearchSpace());
    std::cout << kIntroduction;
    reference.print(std::cout);
  });
}

}  // namespace place_recognition::tool
