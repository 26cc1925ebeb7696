// training_growth FRAMES [GAMMA [REDUCTION]]: trains a model of five rooms on so many views with
// the default preset, from images to the model; prints its cost as JSON. One process a number of
// frames, so that memory is that of this training.

#include <sys/resource.h>

#include <iostream>
#include <limits>
#include <string>

#include "sample_model.h"

int main(int argc, char** argv) {
  using namespace place_recognition;
  if (argc < 2 || argc > 4) {
    std::cerr << "usage: training_growth FRAMES [GAMMA [REDUCTION]]\n";
    return 2;
  }
  TrainingOptions options;
  options.cues.front().feature = CrfhOptions();
  options.sampling.most = std::numeric_limits<int>::max();
  if (argc > 2) options.cues.front().kernel.gamma = std::stod(argv[2]);
  if (argc > 3) options.reduction.method = argv[3];
  const Training training = train({viewRun(std::stoul(argv[1]))}, options);

  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  const double processor =
      static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
      1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
  std::cout << "{\"frames\": " << training.images << ", \"seconds\": " << training.seconds
            << ", \"processor_seconds\": " << processor
            << ", \"megabytes\": " << usage.ru_maxrss / 1024
            << ", \"support_vectors\": " << training.model.supportVectorCount() << "}\n";
}
