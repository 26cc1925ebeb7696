#include "simulation/furniture.h"

#include <algorithm>

// What people leave about, and the people.
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

void Furniture::limb(const Placement& at, const Vec3& from, const Vec3& to, float start, float end,
                     int material) {
  scene_.turned(at, from, to,
                {{start, start}, {(start + end) / 2.0f, (start + end) / 2.0f}, {end, end}},
                material, 10);
}

void Furniture::person(const Placement& at, bool seated) {
  const int trousers = pick(palette_.clothes);
  const int shirt = pick(palette_.clothes);
  const int skin = pick(palette_.skins);
  const float hip = seated ? 0.5f : 0.86f + 0.04f * random_.normal();
  for (const float x : {-0.1f, 0.1f}) {
    const Vec3 joint(x, 0.0f, hip);
    if (seated) {
      const Vec3 knee(x, -0.45f, 0.52f);
      limb(at, joint, knee, 0.085f, 0.065f, trousers);
      limb(at, {x, -0.47f, 0.06f}, knee, 0.05f, 0.065f, trousers);
      scene_.box(at, {x - 0.045f, -0.65f, 0.0f}, {x + 0.045f, -0.4f, 0.07f}, palette_.black);
    } else {
      limb(at, {x, random_.uniform(-0.05f, 0.05f), 0.06f}, joint, 0.055f, 0.09f, trousers);
      scene_.box(at, {x - 0.045f, -0.18f, 0.0f}, {x + 0.045f, 0.08f, 0.07f}, palette_.black);
    }
  }
  const float shoulder = hip + 0.54f;
  scene_.turned(at, {0, 0, hip - 0.06f}, {0, 0, shoulder + 0.04f},
                {{0.16f, 0.11f},
                 {0.17f, 0.12f},
                 {0.16f, 0.11f},
                 {0.19f, 0.12f},
                 {0.2f, 0.11f},
                 {0.06f, 0.05f}},
                shirt, 14);
  for (const float side : {-1.0f, 1.0f}) {
    const Vec3 top(0.21f * side, 0.0f, shoulder - 0.05f);
    const float bend = seated ? -0.2f : random_.uniform(-0.12f, 0.02f);
    const Vec3 elbow(0.25f * side, bend, shoulder - 0.32f);
    const Vec3 hand(0.17f * side, bend - 0.2f, seated ? shoulder - 0.33f : shoulder - 0.5f);
    limb(at, elbow, top, 0.04f, 0.055f, shirt);
    limb(at, hand, elbow, 0.032f, 0.04f, shirt);
    scene_.turned(at, hand - Vec3(0, 0.05f, 0.02f), hand, {{0.03f, 0.03f}, {0.03f, 0.03f}}, skin,
                  8);
  }
  limb(at, {0, 0, shoulder + 0.02f}, {0, 0, shoulder + 0.12f}, 0.055f, 0.05f, skin);
  scene_.turned(
      at, {0, -0.01f, shoulder + 0.09f}, {0, -0.01f, shoulder + 0.33f},
      {{0.04f, 0.05f}, {0.068f, 0.085f}, {0.076f, 0.095f}, {0.07f, 0.09f}, {0.03f, 0.04f}}, skin,
      12);
  scene_.turned(at, {0, 0.02f, shoulder + 0.17f}, {0, 0.01f, shoulder + 0.35f},
                {{0.06f, 0.07f}, {0.083f, 0.092f}, {0.078f, 0.092f}, {0.03f, 0.04f}},
                pick(palette_.hairs), 12);
  stand(at, 0.3f, seated ? -0.65f : -0.25f, 0.2f);
}

}  // namespace place_recognition::simulation
