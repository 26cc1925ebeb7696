#include <filesystem>

#include "base/bag_name.h"
#include "base/data_folder.h"
#include "base/text.h"
#include "place_recognition/error.h"
#include "place_recognition/model_file.h"

namespace place_recognition {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExtension = ".places";

}  // namespace

std::string modelFolder() { return dataFolder("models"); }

std::string modelPath(const std::string& name) {
  const std::string scheme = "file://";
  if (startsWith(name, scheme + "/")) return name.substr(scheme.size());
  return isFileName(name, kExtension) ? name : namedModelPath(name);
}

std::string namedModelPath(const std::string& name) {
  if (hasBagName(name)) {
    throw Error(inQuotes(name) + " is a bag, not a model; give the name of a model.");
  }
  const std::string stem = fs::path(name).stem().string();
  if (isFileName(name, kExtension) && isPlainName(stem)) {
    throw Error(inQuotes(name) + " is a file, not the name of a model; copy the file to " +
                modelFolder() + "/" + stem + kExtension + " and give the name " + stem + ".");
  }
  if (!isPlainName(name)) {
    throw Error(inQuotes(name) + " cannot name a model; use " + kPlainNameRule + ".");
  }
  const std::string path = modelFolder() + "/" + name + kExtension;
  if (fs::is_symlink(fs::symlink_status(path))) {
    throw Error("The model '" + name + "' is a link to elsewhere; put the file itself into " +
                modelFolder() + ".");
  }
  return path;
}

}  // namespace place_recognition
