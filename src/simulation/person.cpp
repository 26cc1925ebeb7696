#include "simulation/furniture.h"

namespace place_recognition::simulation {

void Furniture::limb(const Placement& at, const Vec3& from, const Vec3& to, float start, float end,
                     int material) {
  const float middle = 0.53f * (start + end);
  scene_.turned(at, from, to, {{start, start}, {middle, middle}, {end, end}}, material);
}

void Furniture::lowerBody(const Placement& at, float hip, bool seated, int cloth) {
  for (const float x : {-0.1f, 0.1f}) {
    const Vec3 joint(x, 0.0f, hip);
    float foot = random_.uniform(-0.05f, 0.05f);
    if (seated) {
      const Vec3 knee(x, -0.45f, 0.52f);
      foot -= 0.47f;
      limb(at, joint, knee, 0.085f, 0.065f, cloth);
      limb(at, {x, foot, 0.06f}, knee, 0.05f, 0.065f, cloth);
    } else {
      limb(at, {x, foot, 0.06f}, joint, 0.055f, 0.09f, cloth);
    }
    scene_.box(at, {x - 0.045f, foot - 0.17f, 0.0f}, {x + 0.045f, foot + 0.08f, 0.07f},
               palette_.black);
  }
}

void Furniture::upperBody(const Placement& at, float hip, float shoulder, bool seated, int cloth,
                          int skin) {
  scene_.turned(at, {0, 0, hip - 0.06f}, {0, 0, shoulder + 0.04f},
                {{0.16f, 0.11f},
                 {0.17f, 0.12f},
                 {0.16f, 0.11f},
                 {0.18f, 0.12f},
                 {0.2f, 0.12f},
                 {0.2f, 0.11f},
                 {0.15f, 0.09f},
                 {0.06f, 0.06f}},
                cloth, 16);
  for (const float side : {-1.0f, 1.0f}) {
    const float bend = seated ? -0.2f : random_.uniform(-0.12f, 0.02f);
    const Vec3 top(0.2f * side, 0.0f, shoulder - 0.05f);
    const Vec3 elbow(0.24f * side, bend, shoulder - 0.32f);
    const Vec3 hand(0.17f * side, bend - 0.18f, shoulder - (seated ? 0.33f : 0.5f));
    limb(at, elbow, top, 0.045f, 0.06f, cloth);
    limb(at, hand, elbow, 0.034f, 0.045f, cloth);
    limb(at, hand + Vec3(0.0f, -0.1f, -0.04f), hand, 0.02f, 0.03f, skin);
  }
}

void Furniture::head(const Placement& at, float neck, int skin) {
  limb(at, {0, 0, neck}, {0, 0, neck + 0.1f}, 0.055f, 0.05f, skin);
  scene_.turned(at, {0, -0.01f, neck + 0.07f}, {0, -0.01f, neck + 0.3f},
                {{0.035f, 0.045f},
                 {0.06f, 0.08f},
                 {0.072f, 0.092f},
                 {0.077f, 0.097f},
                 {0.074f, 0.094f},
                 {0.04f, 0.05f}},
                skin, 14);
  scene_.turned(
      at, {0, 0.02f, neck + 0.14f}, {0, 0.005f, neck + 0.325f},
      {{0.055f, 0.06f}, {0.083f, 0.09f}, {0.085f, 0.095f}, {0.077f, 0.092f}, {0.03f, 0.04f}},
      pick(palette_.hairs), 14);
}

void Furniture::person(const Placement& at, bool seated) {
  const int trousers = pick(palette_.clothes);
  const int shirt = pick(palette_.clothes);
  const int skin = pick(palette_.skins);
  const float hip = seated ? 0.5f : 0.86f + 0.04f * random_.normal();
  const float shoulder = hip + 0.54f;
  lowerBody(at, hip, seated, trousers);
  upperBody(at, hip, shoulder, seated, shirt, skin);
  head(at, shoulder + 0.02f, skin);
  stand(at, 0.3f, seated ? -0.65f : -0.25f, 0.2f);
}

}  // namespace place_recognition::simulation
