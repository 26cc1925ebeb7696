#include "evaluation/timeline.h"

#include <functional>
#include <vector>

#include "base/place_name.h"
#include "evaluation/over_time.h"
#include "report/svg.h"

namespace place_recognition {
namespace {

constexpr const char* kWhite = "#fff";
constexpr const char* kPale = "#eee";
constexpr const char* kRed = "#c0504d";

using Frames = std::vector<const FrameResult*>;

struct Paint {
  std::string colour;
  std::string tooltip;
};

/// A row of the plot: what it shows for each frame.
struct Strip {
  std::string name;
  std::function<Paint(const FrameResult&)> paint;
};

/// Paints places in their colours.
class Places {
 public:
  explicit Places(const std::vector<std::string>& names) : names_(names) {}

  /// -1: unknown, with `why` in brackets.
  Paint paint(int place, const std::string& why = "") const {
    if (place < 0) return {kPale, kUnknownPlace + (why.empty() ? why : " (" + why + ")")};
    const auto k = static_cast<std::size_t>(place);
    return {placeColour(k, names_.size()), names_[k]};
  }

  Paint answer(const FrameResult& frame) const {
    if (frame.known) return paint(frame.place);
    return paint(-1, frame.place < 0 ? "no answer" : paint(frame.place).tooltip);
  }

 private:
  const std::vector<std::string>& names_;
};

std::vector<Strip> stripsOf(const Evaluation& evaluation, bool drive) {
  const Places places(evaluation.places);
  std::vector<Strip> strips{
      {"truth", [places](const FrameResult& f) { return places.paint(f.truth); }},
      {drive ? "single" : "answer", [places](const FrameResult& f) { return places.answer(f); }}};
  if (drive) {
    strips.push_back(
        {"~place", [places](const FrameResult& f) { return places.paint(f.place_over_time); }});
    strips.push_back(
        {"~smoothed", [places](const FrameResult& f) { return places.paint(f.place_smoothed); }});
  } else {
    strips.push_back({"wrong", [](const FrameResult& f) {
                        return f.correct() ? Paint{kWhite, "right"} : Paint{kRed, "wrong"};
                      }});
  }
  return strips;
}

/// One rectangle for each series of frames with the same appearance.
void draw(const Strip& strip, const Frames& frames, double top, Svg& svg) {
  constexpr double kLeft = 84, kWidth = 806, kHeight = 26;
  svg.text(kLeft - 8, top + 18, strip.name, "end");
  const double step = kWidth / static_cast<double>(frames.size());
  Paint next = strip.paint(*frames[0]);
  for (std::size_t first = 0, last = 0; first < frames.size(); first = last) {
    const Paint paint = next;
    while (last < frames.size() && next.tooltip == paint.tooltip) {
      if (++last < frames.size()) next = strip.paint(*frames[last]);
    }
    svg.rectangle(kLeft + step * static_cast<double>(first), top,
                  step * static_cast<double>(last - first), kHeight, paint.colour, paint.tooltip);
  }
}

}  // namespace

std::string timelinePlot(const Evaluation& evaluation, int recording) {
  const Frames frames = evaluation.framesOf(recording);
  if (frames.empty()) return "";
  constexpr double kTop = 4, kRow = 32;
  const std::vector<Strip> strips = stripsOf(evaluation, isDrive(frames, evaluation.places.size()));
  Svg svg(900, kTop + kRow * static_cast<double>(strips.size()));
  for (std::size_t i = 0; i < strips.size(); ++i) {
    draw(strips[i], frames, kTop + kRow * static_cast<double>(i), svg);
  }
  return svg.str();
}

}  // namespace place_recognition
