#include "recognition/over_time/room_answer.h"

#include <cassert>

namespace place_recognition {

RoomAnswer roomAnswer(const FilteredAnswer& answer) {
  assert(answer.probabilities.size() > 1);
  const Eigen::Index rooms = answer.probabilities.size() - 1;
  RoomAnswer among_rooms;
  among_rooms.known = answer.place >= 0;
  among_rooms.probabilities = answer.probabilities.head(rooms);
  among_rooms.evidence = among_rooms.probabilities.sum();
  if (among_rooms.evidence > 0) {
    among_rooms.probabilities /= among_rooms.evidence;
  } else {
    among_rooms.probabilities.setConstant(1 / static_cast<double>(rooms));
  }
  among_rooms.confidence = among_rooms.probabilities.maxCoeff(&among_rooms.place);
  return among_rooms;
}

}  // namespace place_recognition
