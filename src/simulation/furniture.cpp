#include "simulation/furniture.h"

#include <algorithm>
#include <cmath>

namespace place_recognition::simulation {

float Footprint::distance(float x, float y) const {
  const float c = std::cos(at.yaw), s = std::sin(at.yaw);
  const float local_x = c * (x - at.x) + s * (y - at.y);
  const float local_y = -s * (x - at.x) + c * (y - at.y);
  const float dx = std::max(std::abs(local_x) - half_width, 0.0f);
  const float dy = std::max({front - local_y, 0.0f, local_y - back});
  return std::hypot(dx, dy);
}

int Furniture::pick(const Palette::Choice& choice) {
  return choice[static_cast<std::size_t>(random_.integer(static_cast<int>(choice.size())))];
}

void Furniture::stand(const Placement& at, float half_width, float front, float back) {
  footprints.push_back({at, half_width, front, back});
}

void Furniture::legs(const Placement& at, float half_width, float front, float back, float height,
                     float thickness, int material) {
  for (const float x : {-half_width, half_width - thickness}) {
    for (const float y : {front, back - thickness}) {
      scene_.box(at, {x, y, 0.0f}, {x + thickness, y + thickness, height}, material);
    }
  }
}

void Furniture::table(const Placement& at, float width, float depth, float height, int wood) {
  const float w = width / 2.0f;
  scene_.box(at, {-w, -depth, height - 0.035f}, {w, 0.0f, height}, wood);
  scene_.box(at, {-w + 0.06f, -depth + 0.06f, height - 0.1f}, {w - 0.06f, -0.06f, height - 0.035f},
             wood);
  legs(at, w - 0.05f, -depth + 0.05f, -0.05f, height - 0.035f, 0.05f, wood);
  stand(at, w, -depth, 0.0f);
  tops.push_back({at.moved(0.0f, -depth / 2.0f, height), w - 0.15f, depth / 2.0f - 0.15f});
}

void Furniture::desk(const Placement& at, float width, int wood) {
  const float w = width / 2.0f;
  const float depth = 0.75f, height = 0.73f;
  scene_.box(at, {-w, -depth, height - 0.03f}, {w, 0.0f, height}, wood);
  legs(at, w - 0.04f, -depth + 0.06f, -0.04f, height - 0.03f, 0.04f, palette_.grey);
  scene_.box(at, {-w + 0.05f, -0.06f, 0.35f}, {w - 0.05f, -0.04f, height - 0.03f}, wood);
  const float left = w - 0.5f;
  scene_.box(at, {left, -0.68f, 0.06f}, {left + 0.42f, -0.1f, 0.62f}, palette_.grey);
  for (int drawer = 0; drawer < 3; ++drawer) {
    const float low = 0.08f + 0.18f * static_cast<float>(drawer);
    scene_.box(at, {left + 0.01f, -0.7f, low}, {left + 0.41f, -0.68f, low + 0.165f}, wood);
    scene_.box(at, {left + 0.15f, -0.715f, low + 0.1f}, {left + 0.27f, -0.7f, low + 0.115f},
               palette_.steel);
  }
  stand(at, w, -depth, 0.0f);
  tops.push_back({at.moved(0.0f, -depth / 2.0f, height), w - 0.2f, depth / 2.0f - 0.15f});
  computers.push_back(at.moved(-0.15f, -0.08f, height));
  seat(at.moved(-0.15f, -depth - 0.3f, 0.0f, 3.14159265f), true);
}

void Furniture::seat(const Placement& at, bool office) {
  seats.push_back({at, office});
  stand(at, 0.25f, -0.25f, 0.25f);
}

void Furniture::officeChair(const Placement& at, int fabric) {
  for (int leg = 0; leg < 5; ++leg) {
    const Placement arm = at.moved(0, 0, 0, 1.2566f * static_cast<float>(leg));
    scene_.box(arm, {0.0f, -0.025f, 0.05f}, {0.3f, 0.025f, 0.09f}, palette_.black);
    scene_.turned(arm.moved(0.28f, 0, 0), {0, 0, 0}, {0, 0, 0.055f},
                  {{0.03f, 0.03f}, {0.03f, 0.03f}}, palette_.black, 6);
  }
  scene_.turned(at, {0, 0, 0.08f}, {0, 0, 0.43f}, {{0.03f, 0.03f}, {0.03f, 0.03f}}, palette_.grey,
                8);
  scene_.box(at, {-0.24f, -0.24f, 0.43f}, {0.24f, 0.22f, 0.51f}, fabric);
  scene_.box(at, {-0.03f, 0.22f, 0.45f}, {0.03f, 0.26f, 0.7f}, palette_.black);
  scene_.turned(at, {0, 0.25f, 0.6f}, {0, 0.31f, 1.05f},
                {{0.19f, 0.03f}, {0.235f, 0.045f}, {0.235f, 0.045f}, {0.2f, 0.035f}}, fabric, 12);
  for (const float x : {-0.3f, 0.26f}) {
    scene_.box(at, {x, -0.12f, 0.66f}, {x + 0.04f, 0.15f, 0.69f}, palette_.black);
    scene_.box(at, {x, -0.02f, 0.46f}, {x + 0.04f, 0.02f, 0.66f}, palette_.black);
  }
  stand(at, 0.3f, -0.3f, 0.3f);
}

void Furniture::chair(const Placement& at, int wood, int fabric) {
  legs(at, 0.2f, -0.2f, 0.2f, 0.43f, 0.035f, wood);
  scene_.box(at, {-0.21f, -0.21f, 0.42f}, {0.21f, 0.21f, 0.46f}, fabric);
  for (const float x : {-0.2f, 0.165f}) {
    scene_.box(at, {x, 0.165f, 0.43f}, {x + 0.035f, 0.2f, 0.88f}, wood);
  }
  scene_.box(at, {-0.2f, 0.17f, 0.66f}, {0.2f, 0.195f, 0.86f}, fabric);
  stand(at, 0.22f, -0.22f, 0.22f);
}

void Furniture::sofa(const Placement& at, float width, int fabric) {
  const float w = width / 2.0f;
  scene_.box(at, {-w, -0.85f, 0.1f}, {w, -0.05f, 0.3f}, fabric);
  const int seats = std::max(2, static_cast<int>(width / 0.62f));
  const float seat = (width - 0.36f) / static_cast<float>(seats);
  for (int i = 0; i < seats; ++i) {
    const float x = -w + 0.18f + seat * static_cast<float>(i);
    scene_.box(at, {x + 0.005f, -0.86f, 0.3f}, {x + seat - 0.005f, -0.2f, 0.44f}, fabric);
    scene_.box(at, {x + 0.01f, -0.3f, 0.44f}, {x + seat - 0.01f, -0.12f, 0.8f}, fabric);
  }
  scene_.box(at, {-w, -0.15f, 0.1f}, {w, 0.0f, 0.72f}, fabric);
  for (const float x : {-w, w - 0.17f}) {
    scene_.box(at, {x, -0.87f, 0.1f}, {x + 0.17f, 0.0f, 0.6f}, fabric);
  }
  legs(at, w, -0.85f, 0.0f, 0.1f, 0.06f, palette_.black);
  stand(at, w, -0.87f, 0.0f);
}

void Furniture::bookshelf(const Placement& at, float width, int shelves, int wood) {
  const float w = width / 2.0f, depth = 0.3f, pitch = 0.36f, thick = 0.022f;
  const float height = 0.08f + pitch * static_cast<float>(shelves);
  for (const float x : {-w, w - thick}) {
    scene_.box(at, {x, -depth, 0.0f}, {x + thick, 0.0f, height}, wood);
  }
  scene_.box(at, {-w, -0.015f, 0.0f}, {w, 0.0f, height}, wood);
  scene_.box(at, {-w + thick, -depth, 0.0f}, {w - thick, -0.01f, 0.08f}, wood);
  scene_.box(at, {-w, -depth, height}, {w, 0.0f, height + thick}, wood);
  for (int i = 0; i < shelves; ++i) {
    const float z = 0.08f + pitch * static_cast<float>(i);
    scene_.box(at, {-w + thick, -depth + 0.01f, z - thick}, {w - thick, -0.015f, z}, wood);
    if (random_.chance(0.1f)) continue;
    const float back = -depth + 0.05f + random_.uniform(0.0f, 0.06f);
    scene_.picture(at.moved(0, back, z), width - 2 * thick, 0.3f, pick(palette_.books));
  }
  stand(at, w, -depth, 0.0f);
}

void Furniture::cupboard(const Placement& at, float width, float height, float depth, int wood,
                         int doors) {
  const float w = width / 2.0f;
  scene_.box(at, {-w, -depth, 0.0f}, {w, 0.0f, height}, wood);
  const float door = width / static_cast<float>(doors);
  for (int i = 0; i < doors; ++i) {
    const float x = -w + door * static_cast<float>(i);
    scene_.box(at, {x + 0.006f, -depth - 0.018f, 0.07f},
               {x + door - 0.006f, -depth, height - 0.01f}, wood);
    const float handle = i % 2 == 0 ? x + door - 0.06f : x + 0.04f;
    scene_.box(at, {handle, -depth - 0.04f, height * 0.5f - 0.07f},
               {handle + 0.015f, -depth - 0.018f, height * 0.5f + 0.07f}, palette_.steel);
  }
  stand(at, w, -depth, 0.0f);
}

void Furniture::kitchenUnit(const Placement& at, float width, int wood) {
  const float w = width / 2.0f;
  const int doors = static_cast<int>(width / 0.55f);
  cupboard(at.moved(0, -0.02f), width, 0.86f, 0.56f, wood, doors);
  scene_.box(at, {-w, -0.63f, 0.86f}, {w, 0.0f, 0.9f}, palette_.worktop);
  scene_.picture(at.moved(0, -0.005f, 0.9f), width, 0.5f, palette_.wall_tiles);
  const float door = width / static_cast<float>(doors);
  for (int i = 0; i < doors; ++i) {
    const float x = -w + door * static_cast<float>(i);
    scene_.box(at, {x, -0.34f, 1.4f}, {x + door, 0.0f, 2.1f}, wood);
    scene_.box(at, {x + 0.006f, -0.358f, 1.405f}, {x + door - 0.006f, -0.34f, 2.095f}, wood);
    scene_.box(at, {x + 0.05f, -0.375f, 1.43f}, {x + 0.065f, -0.358f, 1.55f}, palette_.steel);
  }
  scene_.box(at, {-0.3f, -0.5f, 0.9f}, {0.3f, -0.1f, 0.906f}, palette_.steel);
  scene_.box(at, {-0.25f, -0.46f, 0.906f}, {0.25f, -0.14f, 0.908f}, palette_.grey);
  scene_.turned(at, {0, -0.08f, 0.9f}, {0, -0.08f, 1.15f}, {{0.018f, 0.018f}, {0.014f, 0.014f}},
                palette_.steel, 8);
  scene_.turned(at, {0, -0.08f, 1.15f}, {0, -0.26f, 1.12f}, {{0.014f, 0.014f}, {0.012f, 0.012f}},
                palette_.steel, 8);
  // A microwave oven and a coffee machine.
  scene_.box(at, {w - 0.65f, -0.45f, 0.9f}, {w - 0.15f, -0.08f, 1.2f}, palette_.white);
  scene_.box(at, {w - 0.62f, -0.455f, 0.93f}, {w - 0.3f, -0.45f, 1.17f}, palette_.black);
  scene_.box(at, {-w + 0.2f, -0.4f, 0.9f}, {-w + 0.45f, -0.12f, 1.24f}, palette_.black);
  scene_.turned(at, {-w + 0.325f, -0.42f, 0.92f}, {-w + 0.325f, -0.42f, 1.06f},
                {{0.06f, 0.06f}, {0.08f, 0.08f}, {0.05f, 0.05f}}, palette_.steel, 10);
  tops.push_back({at.moved(w * 0.5f - 0.3f, -0.35f, 0.9f), 0.25f, 0.15f});
  tops.push_back({at.moved(-w * 0.5f, -0.35f, 0.9f), 0.25f, 0.15f});
}

void Furniture::hang(const Placement& at, float bottom, float width, float height, int picture,
                     int frame) {
  const float w = width / 2.0f;
  scene_.box(at, {-w - 0.012f, -0.018f, bottom - 0.012f},
             {w + 0.012f, 0.0f, bottom + height + 0.012f}, frame);
  scene_.picture(at.moved(0, -0.019f, bottom), width, height, picture);
}

}  // namespace place_recognition::simulation
