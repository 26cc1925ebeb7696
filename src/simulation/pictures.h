#pragma once

#include <opencv2/core.hpp>

#include "simulation/random.h"
#include "simulation/simulation.h"

/// Printed, written or displayed pictures: CV_8UC3, sRGB, BGR. Each fills one facet.
namespace place_recognition::simulation {

/// A scientific poster: title, columns of text, plots. Upright.
cv::Mat poster(Random& random);
/// A framed painting of coloured fields and a horizon. Wide.
cv::Mat painting(Random& random);
/// A cork board with papers pinned to it. Wide.
cv::Mat noticeBoard(Random& random);
/// Formulas and boxes in coloured ink. Wide.
cv::Mat whiteboard(Random& random);
/// A sheet with lines of text, perhaps a figure.
cv::Mat paper(Random& random);
/// The spines of a row of books, with occasional binders and gaps. Wide.
cv::Mat books(Random& random);
/// The contents of a screen: windows, text, code. Wide.
cv::Mat screen(Random& random);
cv::Mat keyboard(Random& random);
/// Pigeonholes with mail.
cv::Mat pigeonholes(Random& random);
/// The control panel of a copier.
cv::Mat controlPanel(Random& random);
/// Square, on the white of its casing.
cv::Mat clockFace(Random& random);
/// A calendar page for one month.
cv::Mat calendar(Random& random);
/// The view outside, with the horizon at mid-height. Wide, repeating along x. Linear brightness
/// reaches that of the sky.
cv::Mat outdoors(Random& random, Condition condition);

}  // namespace place_recognition::simulation
