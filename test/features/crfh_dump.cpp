// crfh_dump IMAGE OPTIONS: the CRFH of an image as lines "index:value", for crfh_check.py.
// OPTIONS is YAML text.
#include <cstdio>
#include <opencv2/imgcodecs.hpp>

#include "base/options.h"
#include "features/feature_extractor.h"

int main(int argc, char** argv) {
  using namespace place_recognition;
  if (argc != 3) return 2;
  CrfhOptions options;
  readOptions(parseYaml(argv[2], "OPTIONS"), "", options);
  Feature feature;
  makeFeatureExtractor(options)->extract(cv::imread(argv[1], cv::IMREAD_UNCHANGED), feature);
  const auto& histogram = std::get<SparseVector>(feature);
  for (std::size_t i = 0; i < histogram.size(); ++i) {
    std::printf("%llu:%.9g\n", static_cast<unsigned long long>(histogram.indices[i]),
                histogram.values[i]);
  }
}
