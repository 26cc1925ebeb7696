#include "report/svg.h"

#include "base/place_name.h"
#include "base/text.h"

namespace place_recognition {
namespace {

/// ` name="value"`, a number rounded to a tenth of a pixel.
std::string attribute(const char* name, double value) {
  return std::string(" ") + name + "=\"" + fixed(value, 1) + "\"";
}

std::string attribute(const char* name, const std::string& value) {
  return std::string(" ") + name + "=\"" + value + "\"";
}

/// Closes `element`, with a tooltip inside if it is not empty.
std::string close(const std::string& element, const char* tag, const std::string& tooltip) {
  if (tooltip.empty()) return element + "/>";
  return element + "><title>" + escapeMarkup(tooltip) + "</title></" + tag + ">";
}

}  // namespace

std::string escapeMarkup(const std::string& text) {
  const bool utf8 = isUtf8(text);
  std::string escaped;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += byte < 0x20 || byte == 0x7f || (byte >= 0x80 && !utf8) ? '?' : c;
    }
  }
  return escaped;
}

Svg::Svg(double width, double height) : width_(width), height_(height) {}

void Svg::rectangle(double x, double y, double width, double height, const std::string& fill,
                    const std::string& tooltip) {
  add(close("<rect" + attribute("x", x) + attribute("y", y) + attribute("width", width) +
                attribute("height", height) + attribute("fill", fill),
            "rect", tooltip));
}

void Svg::line(double x1, double y1, double x2, double y2, const std::string& stroke) {
  add("<line" + attribute("x1", x1) + attribute("y1", y1) + attribute("x2", x2) +
      attribute("y2", y2) + attribute("stroke", stroke) + "/>");
}

void Svg::polyline(const std::vector<std::pair<double, double>>& points,
                   const std::string& stroke) {
  std::string list;
  for (const auto& [x, y] : points) list += fixed(x, 1) + "," + fixed(y, 1) + " ";
  add("<polyline" + attribute("points", list) + attribute("stroke", stroke) +
      " fill=\"none\" stroke-width=\"2\"/>");
}

void Svg::circle(double x, double y, double radius, const std::string& fill,
                 const std::string& tooltip) {
  add(close("<circle" + attribute("cx", x) + attribute("cy", y) + attribute("r", radius) +
                attribute("fill", fill),
            "circle", tooltip));
}

void Svg::ring(double x, double y, double radius, const std::string& stroke) {
  add("<circle" + attribute("cx", x) + attribute("cy", y) + attribute("r", radius) +
      attribute("stroke", stroke) + " fill=\"none\"/>");
}

void Svg::area(const std::vector<std::vector<std::pair<double, double>>>& rings,
               const std::string& fill, const std::string& stroke) {
  std::string path;
  for (const auto& ring : rings) {
    const char* command = "M";
    for (const auto& [x, y] : ring) {
      path += command + fixed(x, 0) + " " + fixed(y, 0);
      command = "L";
    }
    path += "Z";
  }
  add("<path" + attribute("d", path) + attribute("fill", fill) + attribute("stroke", stroke) +
      " fill-rule=\"evenodd\"/>");
}

void Svg::text(double x, double y, const std::string& text, const std::string& anchor) {
  add("<text" + attribute("x", x) + attribute("y", y) + attribute("text-anchor", anchor) + ">" +
      escapeMarkup(text) + "</text>");
}

std::string Svg::str() const {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\"" + attribute("width", width_) +
         attribute("height", height_) +
         " font-family=\"sans-serif\" font-size=\"12\" fill=\"#333\">\n" + elements_ + "</svg>\n";
}

void Svg::add(const std::string& element) { elements_ += element + "\n"; }

std::string placeColour(std::size_t k, std::size_t n) {
  constexpr std::size_t kDistinctHues = 12;
  if (n <= kDistinctHues) {
    return "hsl(" + std::to_string(360 * k / (n == 0 ? 1 : n)) + ",55%,55%)";
  }
  constexpr std::size_t kGoldenAngle = 13751;  // hundredths of a degree
  return "hsl(" + std::to_string(kGoldenAngle * k % 36000 / 100) + ",55%," +
         std::to_string(45 + 12 * (k % 3)) + "%)";
}

}  // namespace place_recognition
