#include <algorithm>
#include <cmath>

#include "simulation/furniture.h"
#include "simulation/light.h"

// Appliances, lamps, doors and other hard objects among the furniture.
namespace place_recognition::simulation {

void Furniture::fridge(const Placement& at) {
  scene_.box(at, {-0.3f, -0.6f, 0.03f}, {0.3f, 0.0f, 1.8f}, palette_.white);
  scene_.box(at, {-0.3f, -0.62f, 0.05f}, {0.3f, -0.603f, 1.1f}, palette_.porcelain);
  scene_.box(at, {-0.3f, -0.62f, 1.11f}, {0.3f, -0.603f, 1.79f}, palette_.porcelain);
  scene_.box(at, {0.22f, -0.66f, 0.75f}, {0.25f, -0.62f, 1.05f}, palette_.steel);
  scene_.box(at, {0.22f, -0.66f, 1.16f}, {0.25f, -0.62f, 1.45f}, palette_.steel);
  for (int i = 0; i < 4; ++i) {
    const Placement note =
        at.moved(random_.uniform(-0.2f, 0.1f), -0.621f, random_.uniform(1.2f, 1.55f));
    scene_.picture(note, 0.1f, 0.14f, pick(palette_.papers));
  }
  stand(at, 0.3f, -0.62f, 0.0f);
}

void Furniture::copier(const Placement& at) {
  scene_.box(at, {-0.55f, -0.68f, 0.08f}, {0.3f, -0.05f, 0.92f}, palette_.beige);
  for (int drawer = 0; drawer < 3; ++drawer) {
    const float z = 0.1f + 0.17f * static_cast<float>(drawer);
    scene_.box(at, {-0.5f, -0.7f, z}, {0.24f, -0.68f, z + 0.155f}, palette_.white);
    scene_.box(at, {-0.2f, -0.712f, z + 0.1f}, {-0.05f, -0.7f, z + 0.125f}, palette_.grey);
  }
  scene_.box(at, {-0.5f, -0.69f, 0.62f}, {0.24f, -0.68f, 0.7f}, palette_.grey);
  scene_.box(at, {-0.52f, -0.62f, 0.92f}, {0.26f, -0.08f, 1.08f}, palette_.beige);
  scene_.box(at, {-0.45f, -0.55f, 1.08f}, {0.1f, -0.12f, 1.13f}, palette_.grey);
  const float tilt = 0.05f;
  scene_.polygon({at(-0.5f, -0.76f, 0.95f), at(0.24f, -0.76f, 0.95f),
                  at(0.24f, -0.6f, 1.03f + tilt), at(-0.5f, -0.6f, 1.03f + tilt)},
                 palette_.control_panel);
  scene_.box(at, {0.3f, -0.55f, 0.5f}, {0.62f, -0.15f, 0.53f}, palette_.grey);
  scene_.box(at, {0.32f, -0.5f, 0.53f}, {0.54f, -0.2f, 0.55f}, palette_.white);
  stand(at, 0.62f, -0.76f, 0.0f);
}

void Furniture::deskPrinter(const Placement& at) {
  scene_.box(at, {-0.22f, -0.45f, 0.0f}, {0.22f, -0.03f, 0.34f}, palette_.beige);
  scene_.box(at, {-0.18f, -0.46f, 0.03f}, {0.18f, -0.45f, 0.13f}, palette_.grey);
  scene_.box(at, {-0.16f, -0.4f, 0.34f}, {0.16f, -0.12f, 0.36f}, palette_.black);
  scene_.picture(at.moved(0.1f, -0.452f, 0.24f), 0.16f, 0.06f, palette_.control_panel);
}

void Furniture::plant(const Placement& at, float height) {
  scene_.turned(at, {0, 0, 0}, {0, 0, 0.3f}, {{0.13f, 0.13f}, {0.17f, 0.17f}, {0.18f, 0.18f}},
                palette_.pot, 12);
  for (int i = 0; i < 46; ++i) {
    const float turn = random_.uniform(0.0f, 6.2832f);
    const float rise = random_.uniform(0.25f, 1.0f);
    const float reach = random_.uniform(0.18f, 0.42f) * (1.3f - 0.6f * rise);
    const float low = 0.32f + (height - 0.55f) * rise;
    const float tip = low + random_.uniform(-0.05f, 0.25f);
    const float half = random_.uniform(0.025f, 0.05f);
    const Placement stem = at.moved(0, 0, 0, turn);
    const float mid = (low + tip) / 2.0f + 0.05f;
    const auto blade = [&](float x0, float z0, float w0, float x1, float z1, float w1) {
      scene_
          .polygon({stem(x0, -w0, z0), stem(x1, -w1, z1), stem(x1, w1, z1), stem(x0, w0, z0)},
                   palette_.leaf)
          .two_sided = true;
    };
    blade(0.02f, low, 0.01f, reach * 0.5f, mid, half);
    blade(reach * 0.5f, mid, half, reach, tip, 0.006f);
  }
  stand(at, 0.2f, -0.2f, 0.2f);
}

void Furniture::bin(const Placement& at, int material) {
  scene_.turned(at, {0, 0, 0}, {0, 0, 0.36f}, {{0.11f, 0.11f}, {0.14f, 0.14f}}, material, 12);
  stand(at, 0.14f, -0.14f, 0.14f);
}

void Furniture::radiator(const Placement& at, float width) {
  const float w = width / 2.0f;
  for (float x = -w; x < w - 0.05f; x += 0.09f) {
    scene_.box(at, {x, -0.12f, 0.12f}, {x + 0.07f, -0.04f, 0.62f}, palette_.porcelain);
  }
  scene_.box(at, {-w, -0.09f, 0.14f}, {w, -0.07f, 0.6f}, palette_.porcelain);
  stand(at, w, -0.12f, 0.0f);
}

void Furniture::coatRack(const Placement& at) {
  scene_.box(at, {-0.6f, -0.03f, 1.6f}, {0.6f, 0.0f, 1.7f}, palette_.woods[2]);
  for (int i = 0; i < 5; ++i) {
    const float x = -0.48f + 0.24f * static_cast<float>(i);
    scene_.box(at, {x - 0.01f, -0.1f, 1.62f}, {x + 0.01f, -0.03f, 1.65f}, palette_.steel);
    if (random_.chance(0.4f)) continue;
    const float length = random_.uniform(0.7f, 1.05f);
    scene_.turned(at, {x, -0.1f, 1.62f - length}, {x, -0.07f, 1.64f},
                  {{0.17f, 0.06f}, {0.15f, 0.07f}, {0.14f, 0.07f}, {0.05f, 0.03f}},
                  pick(palette_.clothes), 10);
  }
}

void Furniture::computer(const Placement& at, bool on) {
  scene_.box(at, {-0.12f, -0.22f, 0.0f}, {0.12f, -0.04f, 0.015f}, palette_.black);
  scene_.box(at, {-0.03f, -0.12f, 0.015f}, {0.03f, -0.09f, 0.14f}, palette_.black);
  scene_.box(at, {-0.26f, -0.15f, 0.1f}, {0.26f, -0.11f, 0.47f}, palette_.black);
  const int face = on ? pick(palette_.screens) : palette_.black;
  scene_.picture(at.moved(0, -0.152f, 0.12f), 0.48f, 0.33f, face);
  scene_.box(at, {-0.22f, -0.5f, 0.0f}, {0.22f, -0.36f, 0.02f}, palette_.black);
  scene_.polygon({at(-0.22f, -0.5f, 0.021f), at(0.22f, -0.5f, 0.021f), at(0.22f, -0.36f, 0.024f),
                  at(-0.22f, -0.36f, 0.024f)},
                 palette_.keyboards[0]);
  scene_.box(at, {0.27f, -0.46f, 0.0f}, {0.33f, -0.37f, 0.03f}, palette_.black);
}

void Furniture::floorLamp(const Placement& at, bool on) {
  scene_.turned(at, {0, 0, 0}, {0, 0, 0.03f}, {{0.14f, 0.14f}, {0.14f, 0.14f}}, palette_.black, 12);
  scene_.turned(at, {0, 0, 0.03f}, {0, 0, 1.4f}, {{0.012f, 0.012f}, {0.012f, 0.012f}},
                palette_.black, 6);
  pendant(at.moved(0, 0, 1.65f), 0.25f, on);
  stand(at, 0.15f, -0.15f, 0.15f);
}

void Furniture::pendant(const Placement& at, float drop, bool on) {
  scene_.turned(at, {0, 0, -drop}, {0, 0, -drop + 0.24f}, {{0.2f, 0.2f}, {0.12f, 0.12f}},
                on ? palette_.shade_on : palette_.shade_off, 14);
  if (drop > 0.3f) {
    scene_.turned(at, {0, 0, -drop + 0.24f}, {0, 0, 0}, {{0.006f, 0.006f}, {0.006f, 0.006f}},
                  palette_.black, 4);
  }
  if (!on) return;
  // As large as its shade, but without sides.
  const Vec3 middle = at(0.0f, 0.0f, -drop + 0.12f);
  scene_.lamps.push_back({middle, {0.16f, 0, 0}, {0, 0, 0.14f}, {0, 0, 0}, kShadeRadiance});
}

void Furniture::tube(const Placement& at, bool on) {
  const float half = 0.62f, wide = 0.14f, drop = 0.07f;
  scene_.box(at, {-half - 0.02f, -wide - 0.015f, -drop + 0.01f},
             {half + 0.02f, wide + 0.015f, 0.0f}, palette_.white);
  scene_.polygon({at(-half, wide, -drop), at(half, wide, -drop), at(half, -wide, -drop),
                  at(-half, -wide, -drop)},
                 on ? palette_.tube_on : palette_.tube_off);
  if (!on) return;
  const Vec3 middle = at(0.0f, 0.0f, -drop);
  scene_.lamps.push_back({middle,
                          at(half, 0, -drop) - middle,
                          at(0, wide, -drop) - middle,
                          {0, 0, -1},
                          kTubeRadiance});
}

void Furniture::doorLeaf(const Placement& hinge, float width, bool paned) {
  const float high = 2.08f;
  const float y0 = -0.02f, y1 = 0.02f;
  if (paned) {
    scene_.box(hinge, {0.0f, y0, 0.01f}, {width, y1, 0.9f}, palette_.door);
    scene_.box(hinge, {0.0f, y0, 0.9f}, {0.14f, y1, high}, palette_.door);
    scene_.box(hinge, {width - 0.14f, y0, 0.9f}, {width, y1, high}, palette_.door);
    scene_.box(hinge, {0.14f, y0, high - 0.14f}, {width - 0.14f, y1, high}, palette_.door);
    scene_
        .picture(hinge.moved(width / 2.0f, 0.0f, 0.9f), width - 0.28f, high - 1.04f, palette_.glass)
        .two_sided = true;
  } else {
    scene_.box(hinge, {0.0f, y0, 0.01f}, {width, y1, high}, palette_.door);
  }
  for (const float y : {-0.06f, 0.02f}) {
    scene_.box(hinge, {width - 0.2f, y, 1.02f}, {width - 0.08f, y + 0.04f, 1.04f}, palette_.steel);
  }
  footprints.push_back({hinge.moved(width / 2.0f, 0), width / 2.0f, -0.05f, 0.05f});
}

void Furniture::closedDoor(const Placement& at) {
  scene_.box(at, {-0.52f, -0.03f, 0.0f}, {-0.45f, 0.0f, 2.16f}, palette_.door);
  scene_.box(at, {0.45f, -0.03f, 0.0f}, {0.52f, 0.0f, 2.16f}, palette_.door);
  scene_.box(at, {-0.45f, -0.03f, 2.09f}, {0.45f, 0.0f, 2.16f}, palette_.door);
  scene_.box(at, {-0.45f, -0.012f, 0.0f}, {0.45f, 0.0f, 2.09f}, palette_.door);
  scene_.box(at, {0.3f, -0.07f, 1.02f}, {0.42f, -0.03f, 1.04f}, palette_.steel);
  scene_.picture(at.moved(0.0f, -0.013f, 1.5f), 0.2f, 0.13f, pick(palette_.papers));
}

void Furniture::lightSwitch(const Placement& at) {
  scene_.box(at, {-0.04f, -0.012f, 1.05f}, {0.04f, 0.0f, 1.13f}, palette_.white);
  scene_.box(at, {-0.028f, -0.018f, 1.062f}, {0.028f, -0.012f, 1.118f}, palette_.beige);
}

void Furniture::extinguisher(const Placement& at) {
  scene_.turned(at, {0, -0.1f, 0.75f}, {0, -0.1f, 1.2f},
                {{0.07f, 0.07f}, {0.08f, 0.08f}, {0.08f, 0.08f}, {0.03f, 0.03f}}, palette_.red);
  scene_.turned(at, {0, -0.1f, 1.2f}, {0, -0.1f, 1.27f}, {{0.02f, 0.02f}, {0.03f, 0.03f}},
                palette_.black, 8);
  scene_.turned(at, {0.03f, -0.12f, 1.24f}, {0.09f, -0.12f, 0.85f},
                {{0.012f, 0.012f}, {0.016f, 0.016f}}, palette_.black, 6);
  scene_.picture(at.moved(0, -0.002f, 1.45f), 0.2f, 0.2f, palette_.red);
}

void Furniture::cardboardBox(const Placement& at, float side) {
  const float half = side / 2.0f;
  scene_.box(at, {-half, -half, 0.0f}, {half, half, side * 0.7f}, palette_.cardboard);
  scene_.box(at, {-half - 0.001f, -0.03f, side * 0.7f - 0.12f},
             {half + 0.001f, 0.03f, side * 0.7f + 0.001f}, palette_.beige);
  stand(at, half, -half, half);
}

}  // namespace place_recognition::simulation
