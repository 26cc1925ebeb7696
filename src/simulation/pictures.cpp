#include "simulation/pictures.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "simulation/patterns.h"

namespace place_recognition::simulation {
namespace {

/// A saturated colour, not too light.
cv::Scalar ink(Random& random) {
  static const cv::Scalar kInks[] = {rgb(178, 34, 40),  rgb(26, 72, 140), rgb(30, 112, 62),
                                     rgb(214, 140, 30), rgb(90, 50, 110), rgb(40, 44, 52),
                                     rgb(20, 130, 150), rgb(120, 74, 40)};
  return kInks[random.integer(8)];
}

/// Lines of words as grey dashes.
void text(cv::Mat picture, Random& random, const cv::Rect& box, int line, const cv::Scalar& hue) {
  const int thick = std::max(1, line / 3);
  for (int y = box.y + line; y < box.y + box.height; y += line) {
    int x = box.x;
    const int end = box.x + (random.chance(0.15f) ? box.width / 2 : box.width);
    while (x < end) {
      const int word = std::min(line + random.integer(3 * line), end - x);
      cv::line(picture, {x, y}, {x + word, y}, hue, thick, cv::LINE_AA);
      x += word + std::max(2, line / 2);
    }
  }
}

void plot(cv::Mat picture, Random& random, const cv::Rect& box) {
  cv::rectangle(picture, box, rgb(248, 248, 244), cv::FILLED);
  cv::rectangle(picture, box, rgb(60, 60, 60), 1);
  for (int curve = 0; curve < 3; ++curve) {
    const cv::Scalar hue = ink(random);
    float level = random.uniform(0.2f, 0.8f);
    cv::Point last(box.x, box.y + static_cast<int>(level * box.height));
    for (int i = 1; i <= 12; ++i) {
      level = std::clamp(level + 0.12f * random.normal(), 0.05f, 0.95f);
      const cv::Point next(box.x + box.width * i / 12,
                           box.y + static_cast<int>(level * box.height));
      cv::line(picture, last, next, hue, 2, cv::LINE_AA);
      last = next;
    }
  }
}

/// Coloured noise that resembles a photograph seen from afar.
void photograph(cv::Mat picture, Random& random, const cv::Rect& box) {
  cv::Mat channels[3], image;
  const cv::Mat common = noise(random, box.size(), {5, 4});
  const cv::Mat detail = noise(random, box.size(), {30, 24});
  for (cv::Mat& channel : channels) {
    const cv::Mat own = noise(random, box.size(), {4, 3});
    const cv::Mat field = 0.5 * common + 0.25 * own + 0.25 * detail;
    field.convertTo(channel, CV_8U, 330.0, -60.0);
  }
  cv::merge(channels, 3, image);
  image.copyTo(picture(box));
}

void figure(cv::Mat picture, Random& random, const cv::Rect& box) {
  random.chance(0.5f) ? plot(picture, random, box) : photograph(picture, random, box);
}

}  // namespace

cv::Mat poster(Random& random) {
  const bool pale = random.chance(0.7f);
  const cv::Scalar theme = ink(random);
  cv::Mat picture(720, 512, CV_8UC3, pale ? rgb(242, 240, 232) : theme);
  cv::rectangle(picture, {0, 0, 512, 96}, pale ? theme : rgb(240, 238, 230), cv::FILLED);
  text(picture, random, {40, 8, 430, 70}, 30, pale ? rgb(245, 245, 240) : rgb(30, 30, 30));
  const cv::Scalar body = pale ? rgb(70, 70, 74) : rgb(225, 225, 220);
  for (int column = 0; column < 2; ++column) {
    for (int row = 0; row < 3; ++row) {
      const cv::Rect box(20 + column * 244, 116 + row * 198, 228, 184);
      if (random.chance(0.55f)) {
        figure(picture, random, box);
      } else {
        text(picture, random, {box.x, box.y, box.width, 30}, 22, theme);
        text(picture, random, {box.x, box.y + 34, box.width, box.height - 34}, 12, body);
      }
    }
  }
  return picture;
}

cv::Mat painting(Random& random) {
  cv::Mat picture(384, 512, CV_8UC3);
  photograph(picture, random, {0, 0, 512, 384});
  const int horizon = 120 + random.integer(140);
  const cv::Scalar sky = ink(random) * 0.5 + rgb(120, 120, 120);
  const cv::Scalar land = ink(random);
  cv::Mat fields = picture.clone();
  cv::rectangle(fields, {0, 0, 512, horizon}, sky, cv::FILLED);
  cv::rectangle(fields, {0, horizon, 512, 384 - horizon}, land, cv::FILLED);
  for (int i = 0; i < 5; ++i) {
    const cv::Point at(random.integer(512), horizon + random.integer(100) - 40);
    cv::ellipse(fields, at, {30 + random.integer(70), 20 + random.integer(60)}, 0, 0, 360,
                ink(random), cv::FILLED, cv::LINE_AA);
  }
  cv::addWeighted(picture, 0.35, fields, 0.65, 0.0, picture);
  cv::rectangle(picture, {0, 0, 512, 384}, rgb(62, 44, 30), 28);
  cv::rectangle(picture, {22, 22, 468, 340}, rgb(220, 214, 200), 12);
  return picture;
}

cv::Mat paper(Random& random) {
  cv::Mat picture(256, 192, CV_8UC3, rgb(246, 246, 242));
  text(picture, random, {20, 10, 152, 24}, 14, rgb(40, 40, 40));
  text(picture, random, {20, 40, 152, 196}, 9, rgb(96, 96, 98));
  if (random.chance(0.5f)) figure(picture, random, {24, 60 + random.integer(80), 144, 80});
  return picture;
}

cv::Mat noticeBoard(Random& random) {
  cv::Mat picture(512, 1024, CV_8UC3);
  cv::resize(carpet(random, rgb(168, 124, 80)), picture, picture.size());
  for (int i = 0; i < 17; ++i) {
    cv::Mat sheet = random.chance(0.2f) ? painting(random) : paper(random);
    const float scale = random.uniform(0.55f, 0.95f) * 190.0f / static_cast<float>(sheet.cols);
    cv::resize(sheet, sheet, {}, scale, scale, cv::INTER_AREA);
    if (random.chance(0.3f)) sheet = sheet.mul(ink(random) * 0.3 + cv::Scalar::all(170), 1 / 255.0);
    const cv::Rect at(20 + random.integer(984 - sheet.cols), 20 + random.integer(472 - sheet.rows),
                      sheet.cols, sheet.rows);
    cv::rectangle(picture, at + cv::Point(3, 4), rgb(96, 70, 46), cv::FILLED);
    sheet.copyTo(picture(at));
    cv::circle(picture, {at.x + at.width / 2, at.y + 7}, 5, ink(random), cv::FILLED, cv::LINE_AA);
  }
  cv::rectangle(picture, {0, 0, 1024, 512}, rgb(120, 84, 52), 22);
  return picture;
}

cv::Mat whiteboard(Random& random) {
  cv::Mat picture(512, 1024, CV_8UC3, rgb(240, 242, 243));
  for (int block = 0; block < 7; ++block) {
    const cv::Point at(40 + random.integer(700), 40 + random.integer(330));
    const cv::Scalar pen = ink(random);
    for (int row = 0; row < 4; ++row) {
      cv::Point last = at + cv::Point(0, row * 34);
      for (int i = 0; i < 22; ++i) {
        const cv::Point next(last.x + 4 + random.integer(9),
                             at.y + row * 34 + random.integer(24) - 12);
        if (random.chance(0.85f)) cv::line(picture, last, next, pen, 2, cv::LINE_AA);
        last = next;
      }
    }
    if (random.chance(0.4f)) cv::rectangle(picture, {at.x - 14, at.y - 20, 250, 150}, pen, 2);
  }
  cv::rectangle(picture, {0, 0, 1024, 512}, rgb(150, 152, 156), 16);
  return picture;
}

cv::Mat books(Random& random) {
  cv::Mat picture(256, 1024, CV_8UC3, rgb(28, 24, 22));
  int x = 0;
  while (x < 1010) {
    if (random.chance(0.05f)) x += 30 + random.integer(90);
    const bool binder = random.chance(0.12f);
    const int width = std::min(binder ? 52 : 12 + random.integer(32), 1024 - x);
    const int height = binder ? 225 : 140 + random.integer(90);
    if (width < 8) break;
    const cv::Scalar cover = random.chance(0.25f) ? rgb(214, 208, 196) : ink(random) * 0.9;
    const cv::Rect spine(x, 256 - height, width - 1, height);
    cv::rectangle(picture, spine, cover, cv::FILLED);
    cv::line(picture, spine.tl(), {spine.x, 256}, cover * 0.55, 2);
    const cv::Scalar print = cover[1] > 128 ? rgb(50, 50, 56) : rgb(228, 214, 160);
    if (binder) {
      cv::rectangle(picture, {x + 9, 256 - height + 30, 32, 90}, rgb(240, 240, 236), cv::FILLED);
      cv::circle(picture, {x + 25, 220}, 9, rgb(20, 20, 20), 3, cv::LINE_AA);
    } else if (width > 14) {
      const int length = height / 3 + random.integer(height / 3);
      cv::line(picture, {x + width / 2, 256 - height + 20},
               {x + width / 2, 256 - height + 20 + length}, print, width / 4, cv::LINE_AA);
      cv::line(picture, {x + 2, 236}, {x + width - 3, 236}, print, 3);
    }
    x += width;
  }
  return picture;
}

cv::Mat screen(Random& random) {
  cv::Mat picture(384, 512, CV_8UC3, ink(random) * 0.6 + rgb(20, 40, 60));
  for (int i = 0; i < 3; ++i) {
    const cv::Rect window(10 + random.integer(180), 10 + random.integer(120), 300, 230);
    const bool dark = random.chance(0.35f);
    cv::rectangle(picture, window, dark ? rgb(24, 26, 30) : rgb(246, 247, 248), cv::FILLED);
    cv::rectangle(picture, {window.x, window.y, window.width, 16}, rgb(110, 126, 150), cv::FILLED);
    const cv::Rect body(window.x + 10, window.y + 22, window.width - 20, window.height - 34);
    if (random.chance(0.35f)) {
      figure(picture, random, body);
    } else {
      text(picture, random, body, 9, dark ? rgb(120, 200, 130) : rgb(70, 72, 80));
    }
  }
  cv::rectangle(picture, {0, 368, 512, 16}, rgb(180, 184, 192), cv::FILLED);
  return picture;
}

cv::Mat keyboard(Random& random) {
  const bool dark = random.chance(0.5f);
  cv::Mat picture(128, 384, CV_8UC3, dark ? rgb(40, 40, 42) : rgb(196, 194, 184));
  const cv::Scalar key = dark ? rgb(66, 66, 68) : rgb(224, 222, 212);
  for (int y = 10; y < 108; y += 20) {
    for (int x = 10; x < 366; x += 20) cv::rectangle(picture, {x, y, 16, 16}, key, cv::FILLED);
  }
  return picture;
}

cv::Mat pigeonholes(Random& random) {
  cv::Mat picture(512, 512, CV_8UC3, rgb(176, 138, 92));
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 4; ++x) {
      const cv::Rect hole(x * 128 + 6, y * 64 + 6, 116, 52);
      cv::rectangle(picture, hole, rgb(44, 34, 26), cv::FILLED);
      for (int sheet = random.integer(6); sheet > 0; --sheet) {
        const cv::Scalar hue = random.chance(0.7f) ? rgb(232, 230, 222) : ink(random);
        const int top = hole.y + 50 - 7 * sheet;
        cv::rectangle(picture, {hole.x + 6 + random.integer(12), top, 86, 4}, hue, cv::FILLED);
      }
      cv::rectangle(picture, {hole.x + 30, hole.y - 6, 50, 7}, rgb(240, 240, 236), cv::FILLED);
    }
  }
  return picture;
}

cv::Mat controlPanel(Random& random) {
  cv::Mat picture(128, 512, CV_8UC3, rgb(206, 206, 200));
  cv::rectangle(picture, {150, 20, 180, 88}, rgb(96, 140, 130), cv::FILLED);
  text(picture, random, {160, 24, 160, 76}, 14, rgb(20, 40, 40));
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) {
      cv::rectangle(picture, {356 + x * 26, 16 + y * 25, 18, 16}, rgb(120, 122, 126), cv::FILLED);
    }
  }
  cv::circle(picture, {484, 90}, 16, rgb(40, 150, 70), cv::FILLED, cv::LINE_AA);
  for (int i = 0; i < 4; ++i) cv::circle(picture, {30 + i * 30, 64}, 9, ink(random), cv::FILLED);
  return picture;
}

cv::Mat clockFace(Random& random) {
  cv::Mat picture(256, 256, CV_8UC3, rgb(236, 236, 230));
  cv::circle(picture, {128, 128}, 118, rgb(40, 40, 44), 12, cv::LINE_AA);
  const auto hand = [&](double turn, double from, double to, int thickness) {
    const cv::Point2d way(std::sin(2.0 * CV_PI * turn), -std::cos(2.0 * CV_PI * turn));
    const cv::Point2d middle(128.0, 128.0);
    cv::line(picture, middle + from * way, middle + to * way, rgb(20, 20, 24), thickness,
             cv::LINE_AA);
  };
  for (int hour = 0; hour < 12; ++hour) hand(hour / 12.0, 90.0, 106.0, 5);
  const double time = 12.0 * random.uniform();
  hand(time / 12.0, 0.0, 62.0, 9);
  hand(time, 0.0, 92.0, 5);
  return picture;
}

cv::Mat calendar(Random& random) {
  cv::Mat picture(512, 384, CV_8UC3, rgb(246, 246, 242));
  photograph(picture, random, {0, 0, 384, 250});
  for (int y = 0; y < 6; ++y) {
    for (int x = 0; x < 7; ++x) {
      const cv::Rect day(12 + x * 52, 262 + y * 41, 46, 36);
      cv::rectangle(picture, day, rgb(120, 120, 126), 1);
      const cv::Scalar hue = x > 4 ? rgb(190, 40, 40) : rgb(60, 60, 60);
      cv::line(picture, {day.x + 8, day.y + 12}, {day.x + 20, day.y + 12}, hue, 6);
      if (random.chance(0.25f)) text(picture, random, day + cv::Point(6, 10), 9, ink(random));
    }
  }
  return picture;
}

}  // namespace place_recognition::simulation
