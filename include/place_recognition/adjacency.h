#pragma once

#include <string>
#include <vector>

namespace place_recognition {

/// Which rooms one can walk between without passing through a third. Symmetric. Of a room in no
/// pair nothing is known: it may adjoin any room, so that an empty map allows everything.
class Adjacency {
 public:
  /// No pair is known. `places`: number of rooms, as in Model::places.
  explicit Adjacency(std::size_t places);

  /// Rooms `a` and `b`, two different indices, adjoin.
  void join(int a, int b);

  /// Whether one may walk between `a` and `b`; false if they are the same room.
  bool adjoin(int a, int b) const;

  /// Whether the pair itself was given or learned.
  bool joined(int a, int b) const { return joined_[a][b]; }

  std::size_t places() const { return joined_.size(); }

  /// Whether no pair is known.
  bool empty() const;

 private:
  bool isKnown(int place) const;

  std::vector<std::vector<bool>> joined_;  // places x places
};

/// A map as YAML text, `rooms: {kitchen: [corridor], ...}`; it is enough to give a pair at one of
/// its rooms. Throws Error, naming `where`, if the text has another form or names a room that is
/// not in `places`.
Adjacency parseAdjacency(const std::string& text, const std::string& where,
                         const std::vector<std::string>& places);

/// The same from a file.
Adjacency readAdjacency(const std::string& path, const std::vector<std::string>& places);

/// A map as YAML text, each pair at both of its rooms.
std::string writeAdjacency(const Adjacency& adjacency, const std::vector<std::string>& places);

/// The room of one frame of a recording.
struct PlaceAt {
  double stamp = 0;  ///< s
  int place = -1;    ///< -1: unlabelled
};

/// Joins the rooms that follow each other in `recording`, which is in order of time, within
/// `longest_gap` seconds; between them frames may be unlabelled. Only a drive tells which rooms
/// adjoin. Images sorted by room never come back to one, so a run that does not is passed over, and
/// false returned.
bool learnAdjacency(const std::vector<PlaceAt>& recording, Adjacency& adjacency,
                    double longest_gap = 3.0);

}  // namespace place_recognition
