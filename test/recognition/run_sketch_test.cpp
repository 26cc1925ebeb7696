#include "place_recognition/run_sketch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace place_recognition {
namespace {

using Hashes = std::vector<std::uint64_t>;

/// Returns `count` hashes as of the images of one run; other seeds give other runs.
Hashes imagesOf(unsigned seed, std::size_t count) {
  std::mt19937_64 random(seed);
  Hashes hashes(count);
  std::generate(hashes.begin(), hashes.end(), random);
  return hashes;
}

Hashes part(const Hashes& images, std::size_t begin, std::size_t end) {
  return {images.begin() + static_cast<std::ptrdiff_t>(begin),
          images.begin() + static_cast<std::ptrdiff_t>(end)};
}

Hashes together(Hashes images, const Hashes& others) {
  images.insert(images.end(), others.begin(), others.end());
  return images;
}

RunSketch sketchOf(const Hashes& images) {
  RunSketch sketch;
  for (const std::uint64_t hash : images) sketch.add(hash);
  return sketch;
}

bool isLearned(const Hashes& images, const std::vector<Hashes>& learned) {
  std::vector<RunSketch> sketches;
  for (const Hashes& run : learned) sketches.push_back(sketchOf(run));
  return isLearned(sketchOf(images), sketches);
}

TEST(RunSketch, HoldsTheSmallestHashesWhateverTheirOrder) {
  Hashes images = imagesOf(1, 1000);
  const RunSketch sketch = sketchOf(images);
  std::sort(images.begin(), images.end());
  EXPECT_EQ(sketch.hashes(), part(images, 0, 64));
  EXPECT_EQ(sketch.limit(), images[63]);
  EXPECT_EQ(sketchOf(together(images, images)), sketch);

  const RunSketch few = sketchOf(part(images, 5, 8));
  EXPECT_EQ(few.hashes(), part(images, 5, 8));
  EXPECT_EQ(few.limit(), ~std::uint64_t{0});
}

TEST(RunSketch, KnowsARunAgainInWholeAndInPart) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Hashes run = imagesOf(seed, 2000);
    EXPECT_TRUE(isLearned(run, {run}));
    EXPECT_TRUE(isLearned(part(run, 1200, 1500), {run})) << "a part of the recording";
    EXPECT_TRUE(isLearned(part(run, 0, 1200), {run}));
    Hashes one_camera;
    for (std::size_t i = 0; i < run.size(); i += 2) one_camera.push_back(run[i]);
    EXPECT_TRUE(isLearned(one_camera, {run})) << "one of two cameras";
    EXPECT_TRUE(isLearned(together(imagesOf(100 + seed, 400), run), {run})) << "a grown folder";
    EXPECT_TRUE(isLearned(run, {imagesOf(200, 50), part(run, 0, 900), part(run, 900, 2000)}))
        << "of which the parts were learned";
  }
}

TEST(RunSketch, TellsAnotherRunApart) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Hashes run = imagesOf(seed, 2000), other = imagesOf(100 + seed, 2000);
    EXPECT_FALSE(isLearned(other, {run}));
    EXPECT_FALSE(isLearned(together(part(run, 0, 200), other), {run}))
        << "a simulator that starts each run alike";
    EXPECT_FALSE(isLearned(run, {part(run, 0, 400), other})) << "a fifth of it was learned";
  }
}

TEST(RunSketch, RunsOfFewImages) {
  const Hashes run = imagesOf(1, 10), other = imagesOf(2, 10);
  EXPECT_TRUE(isLearned(run, {run}));
  EXPECT_TRUE(isLearned(part(run, 3, 5), {run}));
  EXPECT_TRUE(isLearned(together(run, part(other, 0, 9)), {run})) << "10 of 19 images";
  EXPECT_FALSE(isLearned(together(run, other), {run})) << "10 of 20 images";
  EXPECT_FALSE(isLearned(other, {run}));
  EXPECT_TRUE(isLearned(run, {imagesOf(3, 5000), run})) << "beside a long run";
}

TEST(RunSketch, NothingIsKnownOfARunWithoutImages) {
  const Hashes run = imagesOf(1, 10);
  EXPECT_FALSE(isLearned(Hashes(), {run}));
  EXPECT_FALSE(isLearned(run, {Hashes()}));
  EXPECT_FALSE(isLearned(run, {}));
  EXPECT_FALSE(isLearned(Hashes(), {Hashes()}));
  EXPECT_TRUE(RunSketch().empty());
}

}  // namespace
}  // namespace place_recognition
