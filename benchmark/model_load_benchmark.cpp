// Compares loading a model of 1000 support vectors with reading its file by cat. One core; compares
// processor time, that of cat's whole process included.

#include <benchmark/benchmark.h>
#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "learning/classifier_parts.h"
#include "place_recognition/model_file.h"
#include "sample_model.h"

namespace place_recognition {
namespace {

constexpr std::size_t kVectors = 1000;

/// The model's file, written once and removed at the end.
class ModelFile {
 public:
  ModelFile() {
    const Model model = sampleModel(kVectors);
    saveModel(model, path_);
    content_ = serializeModel(model);
    vectors_ = model.supportVectorCount();
  }
  ~ModelFile() { std::filesystem::remove(path_); }

  const std::string& path() const { return path_; }
  /// The model that was written.
  const std::string& content() const { return content_; }
  std::size_t vectors() const { return vectors_; }

 private:
  std::string path_ =
      std::filesystem::temp_directory_path() / ("benchmark" + std::to_string(getpid()) + ".places");
  std::string content_;
  std::size_t vectors_ = 0;
};

const ModelFile& modelFile() {
  static const ModelFile file;
  return file;
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// The processor time of `cat PATH > /dev/null`, s; negative if it fails.
double secondsOfCat(const std::string& path) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  std::string command = "cat", argument = path;
  char* arguments[] = {command.data(), argument.data(), nullptr};
  pid_t process = 0;
  int status = posix_spawnp(&process, "cat", &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  rusage usage = {};
  if (status != 0 || wait4(process, &status, 0, &usage) != process || status != 0) return -1;
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

void load(benchmark::State& state) {
  const std::string& path = modelFile().path();
  std::size_t vectors = 0;
  for (auto _ : state) vectors = loadModel(path).supportVectorCount();
  state.counters["bytes"] = static_cast<double>(modelFile().content().size());
  if (vectors != kVectors || modelFile().vectors() != kVectors ||
      serializeModel(loadModel(path)) != modelFile().content()) {
    state.SkipWithError("The model that was loaded is not the one that was saved.");
  }
}

/// The additional time that loading would take if the file stored vectors one by one: building the
/// inverted index.
void index(benchmark::State& state) {
  const Model model = loadModel(modelFile().path());
  const SupportSet& set = ClassifierParts::of(model.classifiers.front()).support_set;
  const std::vector<Feature> vectors = set.vectors();
  for (auto _ : state) benchmark::DoNotOptimize(SupportSet(set.kernel(), vectors));
}

void cat(benchmark::State& state) {
  const std::string& path = modelFile().path();
  for (auto _ : state) {
    const double time = secondsOfCat(path);
    if (time < 0) state.SkipWithError("cat cannot be run.");
    state.SetIterationTime(time);
  }
}

BENCHMARK(load)->Unit(benchmark::kMillisecond);
BENCHMARK(index)->Unit(benchmark::kMillisecond);
BENCHMARK(cat)->Unit(benchmark::kMillisecond)->UseManualTime();

}  // namespace
}  // namespace place_recognition
