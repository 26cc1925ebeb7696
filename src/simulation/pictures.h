#pragma once

#include <opencv2/core.hpp>

#include "simulation/random.h"
#include "simulation/simulation.h"

/// Things with something printed, written or shown on them: CV_8UC3, sRGB, BGR. Each fills a facet
/// once.
namespace place_recognition::simulation {

/// A scientific poster: title, columns of text, plots. Upright.
cv::Mat poster(Random& random);
/// A framed painting of coloured fields and a horizon. Wide.
cv::Mat painting(Random& random);
/// A board of cork with papers pinned to it. Wide.
cv::Mat noticeBoard(Random& random);
/// Formulas and boxes in coloured ink. Wide.
cv::Mat whiteboard(Random& random);
/// A sheet with lines of text, perhaps a figure.
cv::Mat paper(Random& random);
/// The spines of a row of books, binders now and then, leaving a gap here and there. Wide.
cv::Mat books(Random& random);
/// What is on a screen: windows, text, code. Wide.
cv::Mat screen(Random& random);
cv::Mat keyboard(Random& random);
/// Pigeonholes with mail in them.
cv::Mat pigeonholes(Random& random);
/// The control panel of a copier.
cv::Mat controlPanel(Random& random);
/// Square, on the white of its casing.
cv::Mat clockFace(Random& random);
/// A calendar page of a month.
cv::Mat calendar(Random& random);
/// What stands outside, the horizon at mid height. Wide, repeating along x. Linear brightness goes
/// up to that of the sky.
cv::Mat outdoors(Random& random, Condition condition);

}  // namespace place_recognition::simulation
