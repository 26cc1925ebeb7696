#include "features/local_images.h"

#include <cstdlib>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace place_recognition {

std::vector<cv::Mat1b> realImages(int every) {
  std::vector<cv::Mat1b> images;
  const char* data = std::getenv("PLACE_RECOGNITION_TEST_DATA");
  if (!data) return images;
  for (const char* pattern : {"/ie_rooms/clip1/*.jpg", "/nao_canteen/*.jpg"}) {
    std::vector<cv::String> files;
    try {
      cv::glob(data + std::string(pattern), files, true);
    } catch (const cv::Exception&) {
      continue;  // no such folder
    }
    for (std::size_t i = every / 2; i < files.size(); i += every) {
      images.push_back(cv::imread(files[i], cv::IMREAD_GRAYSCALE));
    }
  }
  return images;
}

cv::Mat1f texture(int width, int height, int seed) {
  cv::Mat1f image(height, width);
  cv::RNG(seed).fill(image, cv::RNG::NORMAL, 0, 1);
  cv::GaussianBlur(image, image, cv::Size(), 2);
  cv::normalize(image, image, 0, 255, cv::NORM_MINMAX);
  return image;
}

}  // namespace place_recognition
