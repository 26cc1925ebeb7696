#pragma once

#include <opencv2/core.hpp>

#include "simulation/random.h"

/// Procedural surfaces: CV_8UC3, sRGB, BGR, 512 x 512, seamlessly repeating. The caller determines
/// their size in metres.
namespace place_recognition::simulation {

/// An sRGB colour, 0..255, in the order of a picture's channels.
inline cv::Scalar rgb(double red, double green, double blue) { return {blue, green, red}; }

/// Smooth seamless noise, CV_32F, 0..1, with `cells` bumps across the picture.
cv::Mat noise(Random& random, cv::Size size, cv::Size cells);

cv::Mat plaster(Random& random, const cv::Scalar& base);
cv::Mat wood(Random& random, const cv::Scalar& base);
/// Planks run along x, `rows` of them.
cv::Mat planks(Random& random, const cv::Scalar& base, int rows);
cv::Mat carpet(Random& random, const cv::Scalar& base);
cv::Mat linoleum(Random& random, const cv::Scalar& base);
/// `count` by `count` tiles with joints.
cv::Mat tiles(Random& random, const cv::Scalar& base, const cv::Scalar& joint, int count);
/// One perforated panel of a suspended ceiling in its rails.
cv::Mat ceilingPanel(Random& random);
cv::Mat fabric(Random& random, const cv::Scalar& base, const cv::Scalar& stripe);
/// Folds that hang down.
cv::Mat curtain(Random& random, const cv::Scalar& base);
cv::Mat plastic(Random& random, const cv::Scalar& base);
cv::Mat leaf(Random& random);

}  // namespace place_recognition::simulation
