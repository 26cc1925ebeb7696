#pragma once

#include <vector>

#include "simulation/palette.h"
#include "simulation/random.h"
#include "simulation/scene.h"

namespace place_recognition::simulation {

/// An occupied rectangle on the floor.
struct Footprint {
  Placement at;
  float half_width;   ///< m, along x of `at`
  float front, back;  ///< m, along y of `at`

  /// Metres from a point to the rectangle; 0 inside.
  float distance(float x, float y) const;
};

/// A table top that may carry small things.
struct Top {
  Placement at;                  ///< its middle, at its height
  float half_width, half_depth;  ///< m
};

/// Position of a chair before someone moves it; its front faces -y.
struct Seat {
  Placement at;
  bool office;  ///< a chair on castors
};

/// Adds single pieces to a scene. A placement is the middle of a piece's back, on the floor; its
/// front faces -y.
class Furniture {
 public:
  Furniture(Scene& scene, const Palette& palette, Random random)
      : scene_(scene), palette_(palette), random_(random) {}

  void desk(const Placement& at, float width, int wood);
  void table(const Placement& at, float width, float depth, float height, int wood);
  void officeChair(const Placement& at, int fabric);
  void chair(const Placement& at, int wood, int fabric);
  void sofa(const Placement& at, float width, int fabric);
  void bookshelf(const Placement& at, float width, int shelves, int wood);
  void cupboard(const Placement& at, float width, float height, float depth, int wood, int doors);
  void kitchenUnit(const Placement& at, float width, int wood);
  void fridge(const Placement& at);
  void copier(const Placement& at);
  void deskPrinter(const Placement& at);
  void plant(const Placement& at, float height);
  void bin(const Placement& at, int material);
  void seat(const Placement& at, bool office);  ///< keeps the floor free for a chair
  void radiator(const Placement& at, float width);
  void coatRack(const Placement& at);
  void computer(const Placement& at, bool on);
  void floorLamp(const Placement& at, bool on);
  void pendant(const Placement& at, float drop, bool on);
  void tube(const Placement& at, bool on);  ///< hangs under `at`, along its x
  /// To the left of `at`, from a rail `top` metres above the floor down to `bottom`.
  void curtain(const Placement& at, float width, float bottom, float top, int cloth);
  void blind(const Placement& at, float width, float height, int cloth);  ///< hangs under `at`
  void doorLeaf(const Placement& hinge, float width, bool paned);
  void closedDoor(const Placement& at);
  void lightSwitch(const Placement& at);
  void extinguisher(const Placement& at);
  void cardboardBox(const Placement& at, float side);
  void mug(const Placement& at);
  void sheets(const Placement& at, int count);
  void bookPile(const Placement& at, int count);
  void person(const Placement& at, bool seated);

  /// A picture on a wall, `bottom` metres above the floor, in a thin frame.
  void hang(const Placement& at, float bottom, float width, float height, int picture, int frame);

  int pick(const Palette::Choice& choice);
  Random& random() { return random_; }
  const Palette& palette() const { return palette_; }

  std::vector<Footprint> footprints;  ///< of everything on the floor
  std::vector<Top> tops;
  std::vector<Seat> seats;
  std::vector<Placement> computers;  ///< positions on the desks

 private:
  void stand(const Placement& at, float half_width, float front, float back);
  void legs(const Placement& at, float half_width, float front, float back, float height,
            float thickness, int material);
  void limb(const Placement& at, const Vec3& from, const Vec3& to, float start, float end,
            int material);
  void lowerBody(const Placement& at, float hip, bool seated, int cloth);
  void upperBody(const Placement& at, float hip, float shoulder, bool seated, int cloth, int skin);
  void head(const Placement& at, float neck, int skin);

  Scene& scene_;
  const Palette& palette_;
  Random random_;
};

}  // namespace place_recognition::simulation
