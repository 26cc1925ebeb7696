#include "ros/recognizer/debug_image.h"

#include <algorithm>
#include <numeric>
#include <opencv2/imgproc.hpp>
#include <sstream>

#include "base/place_name.h"
#include "base/text.h"

namespace place_recognition {
namespace {

constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
const cv::Scalar kWhite(255, 255, 255);
const cv::Scalar kGreen(80, 175, 40);
const cv::Scalar kGrey(150, 150, 150);

/// Sizes in proportion to the height of the image.
struct Layout {
  explicit Layout(const cv::Size& image)
      : line(std::max(12, image.height / 22)),
        font_scale(line / 30.0),
        bar_left(image.width / 3),
        bar_length(image.width - bar_left - 4 * line) {}

  int line;  ///< height of a line, pixels
  double font_scale;
  int bar_left;
  int bar_length;  ///< of probability 1
};

/// The most probable places, at most kMostBars, in their order.
std::vector<int> drawnPlaces(const Eigen::RowVectorXd& probabilities) {
  constexpr std::size_t kMostBars = 12;
  std::vector<int> places(static_cast<std::size_t>(probabilities.size()));
  std::iota(places.begin(), places.end(), 0);
  if (places.size() <= kMostBars) return places;
  std::stable_sort(places.begin(), places.end(),
                   [&](int a, int b) { return probabilities[a] > probabilities[b]; });
  places.resize(kMostBars);
  std::sort(places.begin(), places.end());
  return places;
}

}  // namespace

cv::Mat drawAnswer(const cv::Mat& image, const Recognition& recognition, const Model& model) {
  const Layout layout(image.size());
  const std::vector<int> places = drawnPlaces(recognition.probabilities);
  const int bars = static_cast<int>(places.size());
  cv::Mat canvas(image.rows + (bars + 1) * layout.line, image.cols, CV_8UC3,
                 cv::Scalar(40, 40, 40));
  cv::Mat frame = canvas.rowRange(0, image.rows);
  if (image.channels() == 1) {
    cv::cvtColor(image, frame, cv::COLOR_GRAY2BGR);
  } else {
    image.copyTo(frame);
  }

  std::string answer = kUnknownPlace;
  if (recognition.known) {
    answer = model.places[static_cast<std::size_t>(recognition.place)] + "  " +
             percent(recognition.confidence, 0);
  }
  cv::rectangle(canvas, cv::Rect(0, 0, image.cols, 2 * layout.line), cv::Scalar(0, 0, 0),
                cv::FILLED);
  cv::putText(canvas, answer, {layout.line / 2, layout.line * 3 / 2}, kFont,
              1.6 * layout.font_scale, recognition.known ? kWhite : kGrey, 1, cv::LINE_AA);

  for (int i = 0; i < bars; ++i) {
    const int top = image.rows + layout.line / 2 + i * layout.line;
    const int place = places[static_cast<std::size_t>(i)];
    const double probability = recognition.probabilities[place];
    const bool chosen = recognition.known && place == recognition.place;
    cv::putText(canvas, model.places[static_cast<std::size_t>(place)],
                {layout.line / 2, top + layout.line * 3 / 4}, kFont, layout.font_scale, kWhite, 1,
                cv::LINE_AA);
    const int length = std::max(1, static_cast<int>(probability * layout.bar_length));
    cv::rectangle(canvas, cv::Rect(layout.bar_left, top + 1, length, layout.line - 2),
                  chosen ? kGreen : kGrey, cv::FILLED);
    cv::putText(canvas, percent(probability, 0),
                {layout.bar_left + length + layout.line / 4, top + layout.line * 3 / 4}, kFont,
                layout.font_scale, kWhite, 1, cv::LINE_AA);
  }
  return canvas;
}

}  // namespace place_recognition
