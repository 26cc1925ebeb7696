// Learns the rooms of a folder of room/image files:
//   train FOLDER MODEL.places [--tune]
// --tune first searches for the features that suit these rooms, which takes minutes.

#include <place_recognition/error.h>
#include <place_recognition/model_file.h>
#include <place_recognition/training.h>
#include <place_recognition/tuning.h>

#include <iostream>
#include <string>
#include <vector>

namespace pr = place_recognition;

int main(int argc, char** argv) try {
  if (argc < 3) {
    std::cerr << "usage: train FOLDER MODEL.places [--tune]\n";
    return 2;
  }
  const std::string folder = argv[1];
  const std::vector<pr::RecordingOpener> recordings = {
      [&] { return pr::openFolderRecording(folder); }};

  pr::TrainingOptions options;
  if (argc > 3 && argv[3] == std::string("--tune")) {
    pr::SearchSpace space;
    options = pr::tune(recordings, {}, options, space).options;
  }
  const pr::Training training = pr::train(recordings, options);
  pr::saveModel(training.model, argv[2]);
  std::cout << training.model.places.size() << " rooms from " << training.images << " images, "
            << 100 * training.model.validation.average_rate << " % of held-out images correct\n";
  return 0;
} catch (const pr::Error& e) {
  std::cerr << "train: " << e.what() << "\n";
  return 1;
}
