#include <sys/stat.h>

#include <ctime>
#include <filesystem>
#include <iostream>
#include <memory>

#include "place_recognition/error.h"
#include "place_recognition/model_file.h"
#include "tool/output.h"
#include "tool/verbs.h"

namespace place_recognition::tool {
namespace {

struct RestoreOptions {
  std::string name;
  int age = 1;
  bool list = false;
  OutputOptions output;
};

/// The local time at which a file was last written.
std::string writtenAt(const std::string& path) {
  struct stat status;
  std::tm time{};
  if (stat(path.c_str(), &status) != 0 || !localtime_r(&status.st_mtime, &time)) return "";
  char text[32];
  std::strftime(text, sizeof(text), "%Y-%m-%d %H:%M:%S", &time);
  return text;
}

/// `age` 0: the model itself.
Json describe(const std::string& path, int age) {
  Json figures = {{"age", age}, {"file", path}, {"written", writtenAt(path)}};
  try {
    const Model model = loadModel(path);
    figures["version"] = model.version;
    figures["rooms"] = model.places;
    figures["support_vectors"] = model.supportVectorCount();
  } catch (const Error& e) {
    figures["problem"] = e.what();
  }
  return figures;
}

Json listModels(const std::string& path) {
  Json models = Json::array();
  for (int age = 0; age <= kModelBackups; ++age) {
    const std::string file = age == 0 ? path : backupPath(path, age);
    if (std::filesystem::exists(file)) models.push_back(describe(file, age));
  }
  if (models.empty())
    throw Error("There is neither a model " + path + " nor a backup of it; check the name.");
  return models;
}

void printModels(const Json& models, std::ostream& out) {
  for (const Json& model : models) {
    const int age = model["age"];
    out << (age == 0 ? "in use   " : "backup " + std::to_string(age) + " ") << " "
        << model["written"].get<std::string>() << "  ";
    if (model.contains("problem")) {
      out << model["problem"].get<std::string>() << "\n";
    } else {
      out << "version " << model["version"].get<std::string>() << ", " << model["rooms"].size()
          << " rooms, " << model["support_vectors"] << " support vectors\n";
    }
  }
  out << std::flush;
}

void restore(const RestoreOptions& options) {
  const std::string path = modelPath(options.name);
  if (options.list) {
    const Json models = listModels(path);
    if (options.output.json != "-") printModels(models, options.output.text());
    options.output.writeJson({{"models", models}});
    return;
  }
  const bool replaces = std::filesystem::exists(path);
  restoreModel(path, options.age);
  options.output.text() << "Backup " << options.age << " is in use again"
                        << (replaces ? "; the replaced model is now backup 1" : "")
                        << ". Running recognizers load it with ~reload_model." << std::endl;
  options.output.writeJson({{"models", listModels(path)}});
}

}  // namespace

void addRestore(CommandLine& tool) {
  Verb& verb = tool.verb("restore", "Puts an earlier model of a name back into use");
  const auto options = std::make_shared<RestoreOptions>();
  verb.argument("NAME", options->name, "Name or file of the model");
  verb.flag("--list", options->list, "Only list the models, and change nothing");
  verb.option("--age", "N", options->age, "Backup to restore; 1 (default): the newest")
      .range(1, kModelBackups)
      .excludes("--list");
  options->output.addTo(verb);
  verb.footer("Example:\n  place_tool restore office --list\n  place_tool restore office --age 2");
  verb.run([options] { restore(*options); });
}

}  // namespace place_recognition::tool
