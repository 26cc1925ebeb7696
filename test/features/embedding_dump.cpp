// embedding_dump OPTIONS IMAGE: the embedding of an image, a number per line. For
// embedding_check.py.
#include <cstdio>
#include <iostream>
#include <opencv2/imgcodecs.hpp>

#include "base/options.h"
#include "features/embedding.h"

int main(int argc, char** argv) {
  using namespace place_recognition;
  if (argc != 3) return 2;
  try {
    EmbeddingOptions options;
    readOptions(readYamlFile(argv[1]), argv[1], options);
    Feature feature;
    EmbeddingExtractor(options).extract(cv::imread(argv[2], cv::IMREAD_UNCHANGED), feature);
    for (const float value : std::get<DenseVector>(feature).values) std::printf("%.9g\n", value);
  } catch (const std::exception& e) {
    std::cerr << e.what() << "\n";
    return 1;
  }
}
