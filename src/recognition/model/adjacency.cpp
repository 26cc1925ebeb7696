#include "place_recognition/adjacency.h"

#include <algorithm>
#include <cassert>

#include "base/options.h"
#include "base/place_name.h"
#include "base/text.h"

namespace place_recognition {
namespace {

const char* const kForm = "give 'rooms: {kitchen: [corridor], ...}'";

int indexOf(const std::string& name, const std::string& where,
            const std::vector<std::string>& places) {
  const auto found = std::find(places.begin(), places.end(), placeName(name));
  if (found != places.end()) return static_cast<int>(found - places.begin());
  throw Error("Room '" + name + "' in '" + where +
              "' is not one of the model's: " + listed(places) + ".");
}

std::string scalar(const YAML::Node& node, const std::string& where) {
  if (node.IsScalar()) return node.Scalar();
  throw Error("'" + where + "' has a list or mapping in place of a room's name; " + kForm + ".");
}

void joinAll(const std::string& name, const YAML::Node& neighbours, const std::string& where,
             const std::vector<std::string>& places, Adjacency& adjacency) {
  if (!neighbours.IsSequence()) {
    throw Error("Room '" + name + "' in '" + where + "' has no list of rooms; " + kForm + ".");
  }
  const int place = indexOf(name, where, places);
  for (const YAML::Node& neighbour : neighbours) {
    const int other = indexOf(scalar(neighbour, where), where, places);
    if (other == place) {
      throw Error("Room '" + name + "' in '" + where + "' adjoins itself; remove it there.");
    }
    adjacency.join(place, other);
  }
}

Adjacency fromYaml(const YAML::Node& root, const std::string& where,
                   const std::vector<std::string>& places) {
  if (!root.IsMap() || root.size() != 1 || !root["rooms"] || !root["rooms"].IsMap()) {
    throw Error("'" + where + "' is not a map of rooms; " + kForm + ".");
  }
  Adjacency adjacency(places.size());
  for (const auto& entry : root["rooms"]) {
    joinAll(scalar(entry.first, where), entry.second, where, places, adjacency);
  }
  return adjacency;
}

/// The labelled frames at which a room is entered, including the first one.
std::vector<std::size_t> entries(const std::vector<PlaceAt>& recording) {
  std::vector<std::size_t> found;
  int current = -1;
  for (std::size_t i = 0; i < recording.size(); ++i) {
    if (recording[i].place < 0 || recording[i].place == current) continue;
    current = recording[i].place;
    found.push_back(i);
  }
  return found;
}

bool comesBack(const std::vector<PlaceAt>& recording, const std::vector<std::size_t>& entries,
               std::size_t places) {
  std::vector<bool> seen(places, false);
  for (const std::size_t i : entries) {
    if (seen[recording[i].place]) return true;
    seen[recording[i].place] = true;
  }
  return false;
}

}  // namespace

Adjacency::Adjacency(std::size_t places) : joined_(places, std::vector<bool>(places, false)) {}

void Adjacency::join(int a, int b) {
  assert(a != b);
  joined_[a][b] = joined_[b][a] = true;
}

bool Adjacency::adjoin(int a, int b) const {
  return a != b && (joined_[a][b] || !isKnown(a) || !isKnown(b));
}

bool Adjacency::empty() const {
  for (std::size_t place = 0; place < places(); ++place) {
    if (isKnown(static_cast<int>(place))) return false;
  }
  return true;
}

bool Adjacency::isKnown(int place) const {
  return std::find(joined_[place].begin(), joined_[place].end(), true) != joined_[place].end();
}

Adjacency readAdjacency(const std::string& path, const std::vector<std::string>& places) {
  return fromYaml(readYamlFile(path), path, places);
}

std::string writeAdjacency(const Adjacency& adjacency, const std::vector<std::string>& places) {
  assert(adjacency.places() == places.size());
  YAML::Emitter out;
  out << YAML::BeginMap << YAML::Key << "rooms" << YAML::Value << YAML::BeginMap;
  for (int a = 0; a < static_cast<int>(places.size()); ++a) {
    out << YAML::Key << places[a] << YAML::Value << YAML::Flow << YAML::BeginSeq;
    for (int b = 0; b < static_cast<int>(places.size()); ++b) {
      if (adjacency.joined(a, b)) out << places[b];
    }
    out << YAML::EndSeq;
  }
  out << YAML::EndMap << YAML::EndMap;
  return std::string(out.c_str()) + "\n";
}

bool learnAdjacency(const std::vector<PlaceAt>& recording, Adjacency& adjacency,
                    double longest_gap) {
  const std::vector<std::size_t> entered = entries(recording);
  if (!comesBack(recording, entered, adjacency.places())) return false;
  std::size_t last_labelled = 0;
  for (std::size_t i = 0; i < recording.size(); ++i) {
    if (recording[i].place < 0) continue;
    const PlaceAt& before = recording[last_labelled];
    const bool changed = before.place >= 0 && before.place != recording[i].place;
    if (changed && recording[i].stamp - before.stamp <= longest_gap) {
      adjacency.join(before.place, recording[i].place);
    }
    last_labelled = i;
  }
  return true;
}

}  // namespace place_recognition
