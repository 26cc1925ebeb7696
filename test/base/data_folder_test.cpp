#include "base/data_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "base/sha256.h"

namespace place_recognition {
namespace {

TEST(DataFolder, IsThatOfRosUnlessToldOtherwise) {
  setenv("HOME", "/home/robot", 1);
  unsetenv("ROS_HOME");
  EXPECT_EQ(dataFolder("networks"), "/home/robot/.ros/place_recognition/networks");
  setenv("ROS_HOME", "/data", 1);
  EXPECT_EQ(dataFolder("models"), "/data/place_recognition/models");
  unsetenv("ROS_HOME");
}

TEST(FileName, HasASlashOrTheExtension) {
  EXPECT_TRUE(isFileName("./office", ".places"));
  EXPECT_TRUE(isFileName("office.places", ".places"));
  EXPECT_FALSE(isFileName("office", ".places"));
  EXPECT_FALSE(isFileName("office.onnx", ".places"));
  EXPECT_FALSE(isFileName(std::string("a/\0b", 4), ".places"));
}

TEST(PlainName, CannotBeTakenForAnOptionOrAPath) {
  for (const char* name : {"office", "Office-2", "_x", "7"}) EXPECT_TRUE(isPlainName(name)) << name;
  for (const char* name : {"", "-", "--", "-x", "--help", "a/b", "a.b", "a b"}) {
    EXPECT_FALSE(isPlainName(name)) << name;
  }
}

// The examples of FIPS 180-4 and of the empty text.
TEST(Sha256, IsThatOfTheStandard) {
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

}  // namespace
}  // namespace place_recognition
