#include "simulation/furnishing.h"

#include "simulation/building.h"

namespace place_recognition::simulation {
namespace {

constexpr float kPi = 3.14159265f;

/// Adds curtains on both sides of every window of a room, and radiators below.
void dressWindows(Furniture& f, const Room& room, int cloth) {
  for (const Opening& opening : openings()) {
    const cv::Rect2f& g = opening.gap;
    const bool along_x = g.width > g.height;
    const float middle_x = g.x + g.width / 2.0f, middle_y = g.y + g.height / 2.0f;
    if (opening.kind != Opening::kWindow || &roomAt(middle_x, middle_y) != &room) continue;
    const float half = (along_x ? g.width : g.height) / 2.0f;
    const Placement at = along_x ? against(room, Side::kPlusY, middle_x - room.floor.x)
                                 : against(room, Side::kMinusX, middle_y - room.floor.y);
    const float width = f.random().uniform(0.22f, 0.34f);
    f.curtain(at.moved(-half + 0.08f, 0.0f), width, 0.2f, 2.42f, cloth);
    f.curtain(at.moved(half - 0.08f + width, 0.0f), width, 0.2f, 2.42f, cloth);
    f.radiator(at, 1.6f * half);
  }
}

void furnishOfficeA(Furniture& f) {
  const Palette& p = f.palette();
  const Room& r = room("office_a");
  const int wood = p.woods[0];
  f.desk(against(r, Side::kMinusX, 3.1f), 1.6f, wood);
  f.bookshelf(against(r, Side::kPlusX, 2.4f), 0.9f, 6, wood);
  f.bookshelf(against(r, Side::kPlusX, 3.3f), 0.9f, 6, wood);
  f.cupboard(against(r, Side::kMinusY, 0.6f), 1.0f, 0.8f, 0.42f, wood, 2);
  f.bookPile(against(r, Side::kMinusY, 0.4f, 0.2f, 0.8f), 5);
  f.hang(against(r, Side::kMinusY, 0.65f), 1.15f, 0.6f, 0.84f, p.posters[0], p.white);
  f.hang(against(r, Side::kMinusX, 1.3f), 0.95f, 1.6f, 0.9f, p.whiteboards[0], p.steel);
  f.hang(against(r, Side::kMinusX, 3.1f), 1.3f, 0.42f, 0.58f, p.calendars[0], p.white);
  f.hang(against(r, Side::kPlusX, 1.2f), 1.2f, 0.6f, 0.84f, p.posters[1], p.black);
  f.plant(against(r, Side::kPlusY, 3.85f, 0.35f), 1.3f);
  f.coatRack(against(r, Side::kMinusY, 1.9f));
  f.lightSwitch(against(r, Side::kMinusY, 2.75f));
  dressWindows(f, r, p.curtains[1]);
}

void furnishOfficeB(Furniture& f) {
  const Palette& p = f.palette();
  const Room& r = room("office_b");
  const int wood = p.woods[1];
  f.desk(against(r, Side::kMinusX, 3.4f), 1.6f, wood);
  f.desk(against(r, Side::kPlusX, 3.3f), 1.8f, wood);
  f.bookshelf(against(r, Side::kMinusX, 1.75f), 1.0f, 5, wood);
  f.bookshelf(against(r, Side::kPlusX, 0.6f), 0.9f, 6, wood);
  f.bookshelf(against(r, Side::kPlusX, 1.5f), 0.9f, 6, wood);
  f.sofa(against(r, Side::kMinusY, 1.05f), 1.7f, p.fabrics[1]);
  f.hang(against(r, Side::kMinusY, 1.05f), 1.2f, 1.1f, 0.8f, p.paintings[0], p.woods[2]);
  f.hang(against(r, Side::kMinusY, 4.95f), 1.0f, 0.6f, 0.84f, p.posters[2], p.white);
  f.hang(against(r, Side::kMinusX, 3.4f), 1.25f, 0.9f, 0.66f, p.paintings[1], p.white);
  f.hang(against(r, Side::kPlusX, 3.3f), 1.05f, 1.4f, 0.8f, p.whiteboards[1], p.steel);
  f.hang(against(r, Side::kPlusY, 2.8f), 1.3f, 0.42f, 0.58f, p.posters[3], p.black);
  f.plant(against(r, Side::kPlusY, 0.4f, 0.35f), 1.5f);
  f.bin(against(r, Side::kPlusX, 2.2f, 0.25f), p.black);
  f.lightSwitch(against(r, Side::kMinusY, 2.05f));
  dressWindows(f, r, p.curtains[0]);
}

void furnishKitchen(Furniture& f) {
  const Palette& p = f.palette();
  const Room& r = room("kitchen");
  f.kitchenUnit(against(r, Side::kMinusY, 2.2f), 3.3f, p.white);
  f.fridge(against(r, Side::kMinusY, 4.25f));
  f.cupboard(against(r, Side::kMinusY, 5.15f), 1.0f, 2.1f, 0.55f, p.woods[0], 2);
  const Placement middle{1.9f, -1.9f, 0.0f, 0.0f};
  f.table(middle, 1.4f, 0.8f, 0.74f, p.woods[0]);
  const Placement side = against(r, Side::kPlusX, 2.6f, 0.05f);
  f.table(side, 1.3f, 0.8f, 0.74f, p.woods[0]);
  for (const float x : {-0.35f, 0.35f}) {
    f.seat(middle.moved(x, -0.95f, 0.0f, kPi), false);
    f.seat(middle.moved(x, 0.15f), false);
    f.seat(side.moved(x, -0.95f, 0.0f, kPi), false);
  }
  f.sofa(against(r, Side::kPlusY, 1.4f), 1.9f, p.fabrics[2]);
  f.hang(against(r, Side::kPlusY, 1.4f), 1.25f, 1.2f, 0.8f, p.paintings[2], p.woods[2]);
  f.hang(against(r, Side::kPlusX, 2.6f), 1.15f, 1.2f, 0.8f, p.paintings[3], p.black);
  f.hang(against(r, Side::kPlusX, 1.2f), 1.2f, 0.42f, 0.58f, p.calendars[1], p.white);
  f.hang(against(r, Side::kPlusX, 3.9f), 1.0f, 0.6f, 0.84f, p.posters[4], p.white);
  f.plant(against(r, Side::kPlusX, 4.25f, 0.3f), 1.2f);
  f.bin(against(r, Side::kMinusY, 0.3f, 0.25f), p.steel);
  f.hang(against(r, Side::kPlusY, 2.8f), 1.9f, 0.3f, 0.3f, p.clock, p.black);
  f.lightSwitch(against(r, Side::kPlusY, 3.05f));
  dressWindows(f, r, p.curtains[2]);
}

void furnishCorridor(Furniture& f) {
  const Palette& p = f.palette();
  const Room& r = room("corridor");
  f.hang(against(r, Side::kPlusY, 1.3f), 1.1f, 0.6f, 0.84f, p.posters[5], p.black);
  f.hang(against(r, Side::kPlusY, 5.1f), 1.0f, 1.8f, 0.9f, p.notices[0], p.woods[2]);
  f.hang(against(r, Side::kPlusY, 9.4f), 1.1f, 0.6f, 0.84f, p.posters[6], p.white);
  f.closedDoor(against(r, Side::kPlusY, 11.0f));
  f.hang(against(r, Side::kMinusY, 1.5f), 1.1f, 0.6f, 0.84f, p.posters[1], p.white);
  f.hang(against(r, Side::kMinusY, 2.4f), 1.1f, 0.6f, 0.84f, p.posters[4], p.white);
  f.closedDoor(against(r, Side::kMinusY, 7.1f));
  f.bookshelf(against(r, Side::kMinusY, 8.6f), 1.2f, 3, p.woods[2]);
  f.hang(against(r, Side::kMinusY, 8.6f), 1.4f, 0.9f, 0.66f, p.paintings[1], p.woods[2]);
  f.closedDoor(against(r, Side::kMinusY, 10.2f));
  f.coatRack(against(r, Side::kMinusY, 6.0f));
  f.plant(against(r, Side::kMinusX, 0.28f, 0.3f), 1.1f);
  f.radiator(against(r, Side::kMinusX, 1.1f), 1.1f);
  f.extinguisher(against(r, Side::kMinusY, 11.3f));
  f.hang(against(r, Side::kPlusY, 8.95f), 1.9f, 0.3f, 0.3f, p.clock, p.black);
  f.lightSwitch(against(r, Side::kPlusY, 4.0f));
  f.lightSwitch(against(r, Side::kPlusY, 10.3f));
}

void furnishPrinterArea(Furniture& f) {
  const Palette& p = f.palette();
  const Room& r = room("printer_area");
  f.copier(against(r, Side::kPlusX, 1.1f));
  const Placement mail = against(r, Side::kPlusX, 2.75f);
  f.cupboard(mail, 1.3f, 0.8f, 0.4f, p.woods[0], 2);
  f.hang(mail, 0.85f, 1.2f, 1.2f, p.pigeonholes, p.woods[0]);
  f.table(against(r, Side::kPlusY, 2.3f, 0.15f), 2.0f, 0.6f, 0.72f, p.beige);
  f.deskPrinter(against(r, Side::kPlusY, 1.8f, 0.2f, 0.72f));
  f.cupboard(against(r, Side::kMinusY, 1.0f), 1.5f, 0.75f, 0.45f, p.beige, 3);
  f.deskPrinter(against(r, Side::kMinusY, 0.7f, 0.0f, 0.75f));
  f.tops.push_back({against(r, Side::kMinusY, 1.3f, 0.22f, 0.75f), 0.3f, 0.1f});
  f.hang(against(r, Side::kMinusY, 1.0f), 1.3f, 1.5f, 0.75f, p.notices[1], p.woods[2]);
  f.bookshelf(against(r, Side::kMinusY, 2.6f), 1.0f, 5, p.beige);
  f.hang(against(r, Side::kMinusY, 3.7f), 1.0f, 0.6f, 0.84f, p.posters[3], p.white);
  f.hang(against(r, Side::kMinusX, 1.1f), 1.1f, 1.4f, 0.7f, p.notices[2], p.woods[2]);
  f.bin(against(r, Side::kPlusX, 0.25f, 0.3f), p.mugs[1]);
  f.bin(against(r, Side::kMinusY, 3.4f, 0.25f), p.mugs[0]);
  f.bin(against(r, Side::kMinusY, 3.75f, 0.25f), p.grey);
  dressWindows(f, r, p.curtains[2]);
}

}  // namespace

void furnish(Furniture& furniture) {
  furnishOfficeA(furniture);
  furnishOfficeB(furniture);
  furnishKitchen(furniture);
  furnishCorridor(furniture);
  furnishPrinterArea(furniture);
}

}  // namespace place_recognition::simulation
