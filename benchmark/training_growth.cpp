// training_growth FRAMES [MOST [default]]: trains a model of five rooms on FRAMES views with the
// preset `crfh` or the default cues, from images to the model, and prints the cost as JSON. At most
// MOST views are learned (0: all). Run it once per number of frames, because its memory is that of
// the process.

#include <sys/resource.h>

#include <iostream>
#include <limits>
#include <string>

#include "sample_model.h"

int main(int argc, char** argv) {
  using namespace place_recognition;
  const bool default_cues = argc == 4 && std::string(argv[3]) == "default";
  if (argc < 2 || argc > 4 || (argc == 4 && !default_cues)) {
    std::cerr << "usage: training_growth FRAMES [MOST [default]]\n";
    return 2;
  }
  TrainingOptions options;
  if (!default_cues) options.cues = {CueOptions()};
  const int most = argc > 2 ? std::stoi(argv[2]) : 0;
  options.sampling.most = most > 0 ? most : std::numeric_limits<int>::max();
  const Training training = train({viewRun(std::stoul(argv[1]))}, options);

  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  const double processor =
      static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
      1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
  std::cout << "{\"frames\": " << training.images << ", \"passed_over\": " << training.passed_over
            << ", \"seconds\": " << training.seconds << ", \"processor_seconds\": " << processor
            << ", \"megabytes\": " << usage.ru_maxrss / 1024
            << ", \"support_vectors\": " << training.model.supportVectorCount() << "}\n";
}
