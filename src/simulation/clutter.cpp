#include "simulation/furniture.h"

#include <algorithm>

// Things that people hang up or leave lying around.
namespace place_recognition::simulation {

void Furniture::curtain(const Placement& at, float width, float bottom, float top, int cloth) {
  const int folds = std::max(3, static_cast<int>(width / 0.06f));
  for (int i = 0; i < folds; ++i) {
    const float x0 = -width + width * static_cast<float>(i) / static_cast<float>(folds);
    const float x1 = x0 + width / static_cast<float>(folds);
    const float y0 = i % 2 == 0 ? -0.06f : -0.1f, y1 = i % 2 == 0 ? -0.1f : -0.06f;
    scene_
        .polygon({at(x0, y0, bottom), at(x1, y1, bottom), at(x1, y1, top), at(x0, y0, top)}, cloth)
        .two_sided = true;
  }
}

void Furniture::blind(const Placement& at, float width, float height, int cloth) {
  scene_.picture(at.moved(0, -0.03f, -height), width, height, cloth).two_sided = true;
  scene_.box(at, {-width / 2.0f, -0.04f, -height - 0.02f}, {width / 2.0f, -0.02f, -height},
             palette_.frame);
}

void Furniture::mug(const Placement& at) {
  const int glaze = pick(palette_.mugs);
  scene_.turned(at, {0, 0, 0}, {0, 0, 0.095f}, {{0.036f, 0.036f}, {0.04f, 0.04f}}, glaze, 10);
  scene_.box(at, {0.035f, -0.006f, 0.025f}, {0.065f, 0.006f, 0.075f}, glaze);
}

void Furniture::sheets(const Placement& at, int count) {
  for (int i = 0; i < count; ++i) {
    const Placement sheet = at.moved(0.03f * random_.normal(), 0.03f * random_.normal(),
                                     0.002f * static_cast<float>(i + 1), 0.3f * random_.normal());
    scene_.polygon({sheet(-0.105f, -0.148f, 0), sheet(0.105f, -0.148f, 0), sheet(0.105f, 0.148f, 0),
                    sheet(-0.105f, 0.148f, 0)},
                   pick(palette_.papers));
  }
}

void Furniture::bookPile(const Placement& at, int count) {
  float z = 0.0f;
  for (int i = 0; i < count; ++i) {
    const float thick = random_.uniform(0.015f, 0.045f);
    const float half = random_.uniform(0.08f, 0.12f);
    scene_.box(at.moved(0, 0, z, 0.2f * random_.normal()), {-half, -0.14f, 0.0f},
               {half, 0.14f, thick}, pick(palette_.clothes));
    z += thick;
  }
}

}  // namespace place_recognition::simulation
