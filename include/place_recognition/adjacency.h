#pragma once

#include <string>
#include <vector>

namespace place_recognition {

/// States between which rooms one can walk without passing through a third. The relation is
/// symmetric. A room in no pair may adjoin any room, so an empty map allows everything.
class Adjacency {
 public:
  /// Starts without pairs. `places`: number of rooms, as in Model::places.
  explicit Adjacency(std::size_t places);

  /// Records that rooms `a` and `b`, two different indices, adjoin.
  void join(int a, int b);

  /// Whether one may walk directly between `a` and `b`; false if they are the same room.
  bool adjoin(int a, int b) const;

  /// Whether this very pair was given or learned.
  bool joined(int a, int b) const { return joined_[a][b]; }

  std::size_t places() const { return joined_.size(); }

  /// Whether no pair is known.
  bool empty() const;

 private:
  bool isKnown(int place) const;

  std::vector<std::vector<bool>> joined_;  // places x places
};

/// Reads a map in YAML, `rooms: {kitchen: [corridor], ...}`. Each pair may be listed at either of
/// its rooms or at both. Throws Error, naming the file, if it cannot be read, has another form or
/// names a room that is not in `places`.
Adjacency readAdjacency(const std::string& path, const std::vector<std::string>& places);

/// Writes a map as YAML; each pair is listed at both of its rooms.
std::string writeAdjacency(const Adjacency& adjacency, const std::vector<std::string>& places);

/// The room of one frame of a recording.
struct PlaceAt {
  double stamp = 0;  ///< s
  int place = -1;    ///< -1: unlabelled
};

/// Joins the rooms that follow each other in `recording`, which is in order of time, within
/// `longest_gap` seconds. Frames between them may be unlabelled. Only a drive tells which rooms
/// adjoin. Images sorted by room never return to a room, so a run without a return is skipped, and
/// the function returns false.
bool learnAdjacency(const std::vector<PlaceAt>& recording, Adjacency& adjacency,
                    double longest_gap = 3.0);

}  // namespace place_recognition
