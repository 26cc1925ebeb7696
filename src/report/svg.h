#pragma once

#include <string>
#include <vector>

namespace place_recognition {

/// Escapes text for HTML and SVG; bytes that are not printable ASCII or valid UTF-8 become question
/// marks.
std::string escapeMarkup(const std::string& text);

/// An SVG drawing, in pixels from the top left corner. Colours and fonts are those of CSS.
class Svg {
 public:
  Svg(double width, double height);

  void rectangle(double x, double y, double width, double height, const std::string& fill,
                 const std::string& tooltip = "");
  void line(double x1, double y1, double x2, double y2, const std::string& stroke);
  void polyline(const std::vector<std::pair<double, double>>& points, const std::string& stroke);
  void circle(double x, double y, double radius, const std::string& fill,
              const std::string& tooltip = "");
  void ring(double x, double y, double radius, const std::string& stroke);
  /// The area inside an odd number of `rings` of corners: rings inside others are holes.
  void area(const std::vector<std::vector<std::pair<double, double>>>& rings,
            const std::string& fill, const std::string& stroke);
  /// `anchor`: start, middle or end; y is the base line.
  void text(double x, double y, const std::string& text, const std::string& anchor = "start");

  /// The whole drawing, an <svg> element.
  std::string str() const;

 private:
  void add(const std::string& element);

  double width_;
  double height_;
  std::string elements_;
};

/// The colour of the k-th of n places: evenly spaced hues; for many places, neighbours in the list
/// differ in hue and lightness.
std::string placeColour(std::size_t k, std::size_t n);

}  // namespace place_recognition
