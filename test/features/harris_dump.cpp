// harris_dump IMAGE: the Harris-Laplace points of an image, from one octave of integration scales,
// as lines "x y sigma cornerness", for harris_check.py.
#include <cstdio>
#include <opencv2/imgcodecs.hpp>

#include "features/harris_laplace.h"

int main(int argc, char** argv) {
  using namespace place_recognition;
  if (argc != 2) return 2;
  HarrisLaplace detector({2, 4, 1, 0.05, 100, 5});
  const cv::Mat1f image(cv::Mat1b(cv::imread(argv[1], cv::IMREAD_GRAYSCALE)));
  for (const InterestPoint& p : detector.detect(image, 1000000)) {
    std::printf("%.6f %.6f %.6f %.9g\n", p.x, p.y, p.sigma, p.cornerness);
  }
}
