#pragma once

#include <cstdint>
#include <vector>

#include "simulation/scene.h"
#include "simulation/simulation.h"

namespace place_recognition::simulation {

/// The materials of a building, as indices into Scene::materials.
struct Palette {
  using Choice = std::vector<int>;

  Choice walls, floors;  ///< one per room, in the order of rooms()
  int ceiling, skirting, door, frame, outdoors;
  int glass;
  Choice woods;  ///< light, reddish, dark
  int white, black, grey, beige, steel, porcelain;
  int wall_tiles, worktop;
  Choice fabrics, curtains, blinds, clothes, skins, hairs, mugs;
  Choice books, posters, paintings, notices, whiteboards, calendars;  ///< shown once per facet
  Choice papers, screens, keyboards;
  int pigeonholes, control_panel, clock;
  int leaf, pot, cardboard, red;
  int tube_on, tube_off, shade_on, shade_off;
};

/// Paints the materials of the building `seed`; only the outdoors depend on the condition.
Palette makePalette(Scene& scene, std::uint64_t seed, Condition condition);

}  // namespace place_recognition::simulation
