#include "simulation/palette.h"

#include "simulation/light.h"
#include "simulation/patterns.h"
#include "simulation/pictures.h"

namespace place_recognition::simulation {
namespace {

/// Adds materials to a scene. Each draws from its own generator, so that a change to one leaves the
/// others unchanged.
class Painter {
 public:
  Painter(Scene& scene, std::uint64_t seed) : scene_(scene), seed_(seed) {}

  Random random() { return Random(seed_, stream_++); }

  /// `width` by `height` m per repeat; 0: once over the facet.
  int surface(const cv::Mat& picture, float width, float height) {
    Material material;
    material.texture = std::make_shared<Texture>(picture);
    material.size = {width, height};
    return scene_.add(material);
  }

  int plain(double red, double green, double blue, float mirror = 0.0f) {
    Random noise = random();
    const int index = surface(plastic(noise, rgb(red, green, blue)), 1.0f, 1.0f);
    material(index).mirror = mirror;
    return index;
  }

  /// `count` variants of a pattern.
  template <typename Paint>
  Palette::Choice several(int count, float width, float height, const Paint& paint) {
    Palette::Choice choice;
    for (int i = 0; i < count; ++i) {
      Random noise = random();
      choice.push_back(surface(paint(noise), width, height));
    }
    return choice;
  }

  int luminous(int like, const Vec3& radiance) {
    Material material = scene_.materials[static_cast<std::size_t>(like)];
    material.emission = radiance;
    return scene_.add(material);
  }

  Material& material(int index) { return scene_.materials[static_cast<std::size_t>(index)]; }

 private:
  Scene& scene_;
  std::uint64_t seed_;
  std::uint64_t stream_ = 0;
};

/// `base` varied slightly in brightness and hue, so that buildings differ.
cv::Scalar near(Random& random, const cv::Scalar& base) {
  const double brightness = random.uniform(0.94f, 1.04f);
  return {base[0] * brightness * random.uniform(0.96f, 1.04f), base[1] * brightness,
          base[2] * brightness * random.uniform(0.97f, 1.03f)};
}

void paintRooms(Painter& painter, Palette& palette) {
  const cv::Scalar paints[] = {rgb(226, 226, 216), rgb(230, 222, 196), rgb(222, 212, 178),
                               rgb(220, 222, 218), rgb(216, 220, 222)};
  for (const cv::Scalar& paint : paints) {
    Random random = painter.random();
    palette.walls.push_back(painter.surface(plaster(random, near(random, paint)), 1.6f, 1.6f));
  }
  Random random = painter.random();
  const int stone = painter.surface(linoleum(random, near(random, rgb(150, 142, 124))), 1.5f, 1.5f);
  palette.floors = {
      painter.surface(carpet(random, near(random, rgb(98, 106, 122))), 1.0f, 1.0f),
      painter.surface(planks(random, near(random, rgb(172, 124, 76)), 7), 1.4f, 0.8f),
      painter.surface(tiles(random, near(random, rgb(178, 164, 146)), rgb(110, 104, 96), 4), 1.2f,
                      1.2f),
      stone, stone};
  palette.ceiling = painter.surface(ceilingPanel(random), 0.6f, 0.6f);
  palette.wall_tiles = painter.surface(
      tiles(random, near(random, rgb(224, 228, 226)), rgb(160, 160, 156), 4), 0.6f, 0.6f);
}

void paintPlain(Painter& painter, Palette& palette) {
  palette.white = painter.plain(228, 228, 224);
  palette.black = painter.plain(30, 30, 32, 0.02f);
  palette.grey = painter.plain(112, 114, 118);
  palette.beige = painter.plain(206, 202, 188);
  palette.steel = painter.plain(150, 154, 158, 0.12f);
  palette.porcelain = painter.plain(236, 236, 232, 0.03f);
  palette.skirting = painter.plain(196, 190, 178);
  palette.frame = painter.plain(218, 216, 208);
  palette.pot = painter.plain(150, 82, 54);
  palette.cardboard = painter.plain(170, 132, 92);
  palette.red = painter.plain(170, 24, 22, 0.02f);
  palette.skins = {painter.plain(214, 166, 140), painter.plain(176, 124, 94)};
  palette.hairs = {painter.plain(52, 38, 28), painter.plain(126, 92, 52)};
  palette.mugs = {painter.plain(176, 44, 40), painter.plain(44, 80, 140),
                  painter.plain(230, 226, 216)};
  palette.glass = painter.plain(255, 255, 255, 0.05f);
  painter.material(palette.glass).glass = true;
}

void paintPatterns(Painter& painter, Palette& palette) {
  Random random = painter.random();
  for (const cv::Scalar& tone : {rgb(206, 172, 124), rgb(150, 88, 52), rgb(92, 66, 46)}) {
    palette.woods.push_back(painter.surface(wood(random, near(random, tone)), 1.1f, 0.5f));
  }
  cv::Mat upright;
  cv::transpose(wood(random, near(random, rgb(180, 138, 88))), upright);
  palette.door = painter.surface(upright, 0.5f, 1.1f);
  palette.worktop = painter.surface(linoleum(random, rgb(112, 108, 104)), 0.8f, 0.8f);
  const cv::Scalar cloths[] = {rgb(54, 72, 120), rgb(150, 50, 44), rgb(60, 92, 70),
                               rgb(60, 60, 66)};
  for (const cv::Scalar& cloth : cloths) {
    const cv::Scalar base = near(random, cloth);
    palette.fabrics.push_back(painter.surface(fabric(random, base, base * 1.25), 0.4f, 0.4f));
  }
  for (const cv::Scalar& cloth : {rgb(196, 118, 60), rgb(70, 110, 140), rgb(214, 206, 186)}) {
    palette.curtains.push_back(painter.surface(curtain(random, near(random, cloth)), 0.8f, 3.0f));
    palette.blinds.push_back(
        painter.surface(fabric(random, rgb(206, 202, 190), rgb(196, 192, 180)), 0.5f, 0.5f));
  }
  const cv::Scalar clothes[] = {rgb(40, 46, 70),    rgb(150, 150, 154), rgb(120, 30, 36),
                                rgb(210, 206, 196), rgb(46, 84, 60),    rgb(70, 92, 130)};
  for (const cv::Scalar& cloth : clothes) {
    palette.clothes.push_back(painter.surface(fabric(random, cloth, cloth), 0.5f, 0.5f));
  }
  palette.leaf = painter.surface(leaf(random), 0.0f, 0.0f);
}

void paintPictures(Painter& painter, Palette& palette) {
  palette.books = painter.several(9, 0.0f, 0.0f, books);
  palette.posters = painter.several(7, 0.0f, 0.0f, poster);
  palette.paintings = painter.several(4, 0.0f, 0.0f, painting);
  palette.notices = painter.several(3, 0.0f, 0.0f, noticeBoard);
  palette.whiteboards = painter.several(2, 0.0f, 0.0f, whiteboard);
  palette.calendars = painter.several(2, 0.0f, 0.0f, calendar);
  palette.papers = painter.several(5, 0.0f, 0.0f, paper);
  palette.keyboards = painter.several(2, 0.0f, 0.0f, keyboard);
  Random random = painter.random();
  palette.clock = painter.surface(clockFace(random), 0.0f, 0.0f);
  palette.pigeonholes = painter.surface(pigeonholes(random), 0.0f, 0.0f);
  palette.control_panel = painter.surface(controlPanel(random), 0.0f, 0.0f);
  for (const int face : painter.several(3, 0.0f, 0.0f, screen)) {
    painter.material(face).tint = Vec3(0.02f, 0.02f, 0.02f);
    palette.screens.push_back(painter.luminous(face, kScreenRadiance));
  }
}

}  // namespace

Palette makePalette(Scene& scene, std::uint64_t seed, Condition condition) {
  Painter painter(scene, seed);
  Palette palette;
  paintRooms(painter, palette);
  paintPlain(painter, palette);
  paintPatterns(painter, palette);
  paintPictures(painter, palette);

  palette.tube_off = palette.white;
  palette.tube_on = painter.luminous(palette.white, kTubeRadiance);
  palette.shade_off = palette.curtains.back();
  palette.shade_on = painter.luminous(palette.shade_off, kShadeRadiance);

  for (const int blind : palette.blinds) {
    painter.material(blind).emission = 0.12f * daylight(condition).sky;  // light shines through
  }
  Random random = painter.random();
  palette.outdoors = painter.surface(outdoors(random, condition), 0.0f, 0.0f);
  painter.material(palette.outdoors).emission = daylight(condition).outdoors;
  painter.material(palette.outdoors).tint = Vec3(0.0f, 0.0f, 0.0f);
  return palette;
}

}  // namespace place_recognition::simulation
