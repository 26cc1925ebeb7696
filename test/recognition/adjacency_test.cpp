#include "place_recognition/adjacency.h"

#include <gtest/gtest.h>

#include "error_of.h"
#include "scratch_folder.h"

namespace place_recognition {
namespace {

const std::vector<std::string> kPlaces{"corridor", "kitchen", "office"};

std::string errorIn(const std::string& yaml) {
  const ScratchFolder folder;
  const std::string path = folder.write("map.yaml", yaml);
  return errorOf([&] { readAdjacency(path, kPlaces); });
}

TEST(Adjacency, EverythingAdjoinsUntilPairsAreKnown) {
  Adjacency adjacency(4);
  EXPECT_TRUE(adjacency.empty());
  EXPECT_TRUE(adjacency.adjoin(0, 3));
  EXPECT_FALSE(adjacency.adjoin(2, 2));

  adjacency.join(0, 1);
  adjacency.join(1, 2);
  EXPECT_FALSE(adjacency.empty());
  EXPECT_TRUE(adjacency.adjoin(1, 0));
  EXPECT_TRUE(adjacency.adjoin(1, 2));
  EXPECT_FALSE(adjacency.adjoin(0, 2));
  EXPECT_TRUE(adjacency.adjoin(0, 3)) << "nothing is known of room 3";
}

TEST(Adjacency, IsReadAndWrittenAsYaml) {
  const ScratchFolder folder;
  const std::string path = folder.write("map.yaml", "rooms: {kitchen: [corridor], office: []}\n");
  const Adjacency adjacency = readAdjacency(path, kPlaces);
  EXPECT_TRUE(adjacency.joined(0, 1));
  EXPECT_TRUE(adjacency.joined(1, 0));
  EXPECT_FALSE(adjacency.joined(0, 2));
  const std::string text = writeAdjacency(adjacency, kPlaces);
  EXPECT_EQ(text, "rooms:\n  corridor: [kitchen]\n  kitchen: [corridor]\n  office: []\n");
  EXPECT_EQ(writeAdjacency(readAdjacency(folder.write("copy.yaml", text), kPlaces), kPlaces), text);
}

TEST(Adjacency, RefusesWhatIsNoMapOfTheRooms) {
  EXPECT_NE(errorIn("rooms: {kitchen: [bathroom]}")
                .find("map.yaml' is not one of the model's: corridor, kitchen, office."),
            std::string::npos);
  EXPECT_NE(errorIn("rooms: {attic: []}").find("'attic'"), std::string::npos);
  EXPECT_NE(errorIn("rooms: {kitchen: [kitchen]}").find("adjoins itself"), std::string::npos);
  for (const char* text :
       {"", "[kitchen]", "kitchen: [corridor]", "rooms: [kitchen]", "rooms: {kitchen: corridor}",
        "rooms: {kitchen: [{a: b}]}", "rooms: {[a]: [kitchen]}", "rooms: {}\nroom: {}"}) {
    EXPECT_NE(errorIn(text).find("rooms: {kitchen: [corridor], ...}"), std::string::npos) << text;
  }
}

TEST(Adjacency, IsLearntFromADrive) {
  Adjacency adjacency(4);
  EXPECT_TRUE(learnAdjacency({{0, 0}, {1, 0}, {2, 1}, {3, -1}, {4, 2}, {5, 1}, {20, 3}, {21, 0}},
                             adjacency));
  EXPECT_TRUE(adjacency.joined(0, 1));
  EXPECT_TRUE(adjacency.joined(1, 2)) << "an unlabelled doorway lies between them";
  EXPECT_FALSE(adjacency.joined(1, 3)) << "fifteen seconds apart";
  EXPECT_TRUE(adjacency.joined(3, 0));
  EXPECT_FALSE(adjacency.joined(0, 2));
}

TEST(Adjacency, IsNotLearntFromImagesSortedByRoom) {
  Adjacency adjacency(3);
  EXPECT_FALSE(learnAdjacency({{0, 0}, {1, 0}, {2, 1}, {3, 1}, {4, 2}}, adjacency));
  EXPECT_FALSE(learnAdjacency({}, adjacency));
  EXPECT_TRUE(adjacency.empty());
}

}  // namespace
}  // namespace place_recognition
