// mr8_dump filters: the MR8 filters, one per line; mr8_dump IMAGE: the MR8 histogram of an image,
// as lines "index:value". For mr8_check.py.
#include <cstdio>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "features/mr8.h"

namespace {

void print(const cv::Mat1f& filter) {
  for (const float value : filter) std::printf("%.9g ", value);
  std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) {
  using namespace place_recognition;
  if (argc != 2) return 2;
  if (std::string(argv[1]) == "filters") {
    for (int scale = 0; scale < Mr8FilterBank::kScales; ++scale) {
      for (int i = 0; i < Mr8FilterBank::kOrientations; ++i) print(Mr8FilterBank::edge(scale, i));
      for (int i = 0; i < Mr8FilterBank::kOrientations; ++i) print(Mr8FilterBank::bar(scale, i));
    }
    print(Mr8FilterBank::gaussian());
    print(Mr8FilterBank::laplacian());
    return 0;
  }
  Feature feature;
  Mr8Extractor(Mr8Options()).extract(cv::imread(argv[1], cv::IMREAD_GRAYSCALE), feature);
  const auto& histogram = std::get<SparseVector>(feature);
  for (std::size_t i = 0; i < histogram.size(); ++i) {
    std::printf("%llu:%.9g\n", static_cast<unsigned long long>(histogram.indices[i]),
                histogram.values[i]);
  }
}
