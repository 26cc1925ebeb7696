#include "views.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "features/feature_extractor.h"

namespace place_recognition {
namespace {

namespace fs = std::filesystem;

const cv::Size kSize(640, 480);

bool isImage(const fs::path& path) {
  return path.extension() == ".jpg" || path.extension() == ".png";
}

/// A large part of the image, selected by `number`.
cv::Rect partOf(const cv::Mat& image, std::size_t number) {
  cv::RNG random(number);
  const double scale = random.uniform(0.6, 0.9);
  const int width = static_cast<int>(scale * image.cols);
  const int height = static_cast<int>(scale * image.rows);
  return {random.uniform(0, image.cols - width), random.uniform(0, image.rows - height), width,
          height};
}

}  // namespace

Views::Views() {
  const char* folder = std::getenv("PLACE_RECOGNITION_PICTURES");
  std::map<std::string, std::vector<std::string>> rooms;
  if (folder && fs::is_directory(folder)) {
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      const fs::path& path = entry.path();
      if (isImage(path)) rooms[path.parent_path().filename()].push_back(path);
    }
  }
  for (auto& [name, files] : rooms) {
    std::sort(files.begin(), files.end());
    if (files_.size() < kPlaces) files_.push_back(files);
  }
  if (files_.size() < kPlaces) {
    throw std::runtime_error("PLACE_RECOGNITION_PICTURES names no folder with five rooms.");
  }
}

View Views::operator[](std::size_t i) const {
  const std::size_t place = i % kPlaces;
  const std::vector<std::string>& files = files_[place];
  const std::size_t round = i / kPlaces / files.size();
  View view{cv::imread(files[i / kPlaces % files.size()], cv::IMREAD_COLOR),
            static_cast<int>(place)};
  if (round > 0) view.image = view.image(partOf(view.image, i)).clone();
  if (round % 2 == 1) cv::flip(view.image, view.image, 1);
  cv::resize(view.image, view.image, kSize, 0, 0, cv::INTER_AREA);
  return view;
}

ViewFeatures extractViews(const FeatureOptions& options, std::size_t count, std::size_t first) {
  const Views views;
  const auto extractor = makeFeatureExtractor(options);
  ViewFeatures all;
  Feature feature;
  for (std::size_t i = first; all.features.size() < count; ++i) {
    const View view = views[i];
    extractor->extract(view.image, feature);
    if (isMissing(feature)) continue;
    all.features.push_back(feature);
    all.labels.push_back(view.place);
  }
  return all;
}

}  // namespace place_recognition
