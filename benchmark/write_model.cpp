// write_model VECTORS FILE: writes a model of VECTORS support vectors, for measurements of the
// node.

#include <iostream>
#include <string>

#include "place_recognition/model_file.h"
#include "sample_model.h"

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: write_model VECTORS FILE\n";
    return 2;
  }
  const place_recognition::Model model = place_recognition::sampleModel(std::stoul(argv[1]));
  place_recognition::saveModel(model, argv[2]);
  std::cout << model.supportVectorCount() << " support vectors\n";
}
