#include "experiments/viewpoint_page.h"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "base/text.h"
#include "datasets/image_file.h"
#include "experiments/training_subsets.h"
#include "report/html_page.h"
#include "report/svg.h"

namespace place_recognition {
namespace {

constexpr int kColumns = 6;
const cv::Size kThumbnail(144, 108);

/// All images in rows of kColumns, as a JPEG.
std::string contactSheet(const std::vector<std::string>& paths) {
  const int rows = (static_cast<int>(paths.size()) + kColumns - 1) / kColumns;
  cv::Mat3b sheet(rows * kThumbnail.height, kColumns * kThumbnail.width, cv::Vec3b(255, 255, 255));
  for (int i = 0; i < static_cast<int>(paths.size()); ++i) {
    cv::Mat image = readImageFile(paths[static_cast<std::size_t>(i)]).image;
    if (image.empty()) continue;
    if (image.channels() == 1) cv::cvtColor(image, image, cv::COLOR_GRAY2BGR);
    const cv::Point corner(i % kColumns * kThumbnail.width, i / kColumns * kThumbnail.height);
    cv::resize(image, sheet(cv::Rect(corner, kThumbnail)), kThumbnail, 0, 0, cv::INTER_AREA);
  }
  std::vector<std::uint8_t> bytes;
  cv::imencode(".jpg", sheet, bytes, {cv::IMWRITE_JPEG_QUALITY, 85});
  return {bytes.begin(), bytes.end()};
}

}  // namespace

std::vector<std::string> imagesOf(const ImageSet& set, const std::string& place, int number) {
  std::vector<std::string> paths;
  const auto first = kViewpointSamples * static_cast<std::size_t>(number - 1);
  std::size_t position = 0;
  for (const LabelledImage& image : set.images) {
    if (image.place != place) continue;
    if (position >= first && position < first + kViewpointSamples) paths.push_back(image.path);
    ++position;
  }
  return paths;
}

std::string viewpointPage(const std::vector<ShownViewpoint>& viewpoints) {
  std::string body =
      "<h1>Salient viewpoints</h1>\n<p>Those of each training set without which the rate on the "
      "other sets falls most.</p>\n";
  for (std::size_t i = 0; i < viewpoints.size(); ++i) {
    const ShownViewpoint& view = viewpoints[i];
    if (i == 0 || view.training_set != viewpoints[i - 1].training_set) {
      body += "<h2>Trained on " + escapeMarkup(view.training_set) + ": " + percent(view.rate) +
              "</h2>\n";
    }
    body += htmlImage(contactSheet(view.images), kColumns * kThumbnail.width,
                      escapeMarkup(view.place) + ", viewpoint " + std::to_string(view.number) +
                          ": " + percent(view.rate_without) + " without it");
  }
  return htmlPage("Salient viewpoints", body);
}

}  // namespace place_recognition
