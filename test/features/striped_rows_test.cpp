// The striped row layout, compared with its definition pixel by pixel, and the ring of rows.
#include "features/striped_rows.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>
#include <vector>

#include "features/row_ring.h"

namespace place_recognition {
namespace {

constexpr int kLanes = StripedRows::kLanes;

/// Pixel x has the value x + 1.
std::vector<float> ascending(int pixels, int size) {
  std::vector<float> row(size, 0);
  std::iota(row.begin(), row.begin() + pixels, 1.f);
  return row;
}

TEST(StripedRows, HoldEachPixelOnceAndOneStepBesideTheNext) {
  for (const int pixels : {1, 2, 15, 16, 17, 31, 100, 610, 640}) {
    const StripedRows lanes(pixels);
    ASSERT_GE(lanes.size(), pixels);
    ASSERT_LT(lanes.size(), pixels + kLanes);
    const int length = lanes.size() / kLanes;
    std::vector<float> laid(lanes.size());
    lanes.lay(ascending(pixels, lanes.size()).data(), laid.data());
    for (int x = 0; x < lanes.size(); ++x) {
      ASSERT_EQ(laid[x % length * kLanes + x / length], x < pixels ? x + 1 : 0);
    }
  }
}

TEST(StripedRows, AreLengthenedByWhatFollows) {
  for (const int pixels : {1, 17, 40, 100, 626}) {
    for (const int n : {1, 2, 7, 16, 31}) {
      const StripedRows lanes(pixels);
      const int length = lanes.size() / kLanes;
      std::vector<float> laid(lanes.size() + n * kLanes + 1, 77);
      lanes.lay(ascending(pixels, lanes.size()).data(), laid.data());
      lanes.lengthen(n, laid.data());
      for (int k = 0; k < kLanes; ++k) {
        for (int i = 0; i < length + n; ++i) {
          const int x = k * length + i;
          // The padding of the last lanes is unspecified.
          if (x < pixels) {
            ASSERT_EQ(laid[i * kLanes + k], x + 1);
          }
        }
      }
      ASSERT_EQ(laid.back(), 77);
    }
  }
}

TEST(StripedRows, GiveTheFirstPixelsWithoutPadding) {
  for (const int pixels : {1, 2, 16, 17, 40, 100, 626, 640}) {
    const StripedRows lanes(pixels);
    const int length = lanes.size() / kLanes;
    std::vector<std::uint32_t> laid(lanes.size());
    for (int x = 0; x < lanes.size(); ++x) laid[x % length * kLanes + x / length] = x;
    for (int taken = 1; taken <= pixels; taken += taken < 20 ? 1 : 7) {
      std::vector<std::uint32_t> expected;
      for (const std::uint32_t x : laid) {
        if (x < static_cast<std::uint32_t>(taken)) expected.push_back(x);
      }
      std::vector<std::uint32_t> row(lanes.size() + 1, 12345);
      lanes.take(taken, laid.data(), row.data());
      ASSERT_EQ(row.back(), 12345u);
      row.resize(taken);
      ASSERT_EQ(row, expected);

      std::vector<std::uint32_t> in_place = laid;
      lanes.take(taken, in_place.data(), in_place.data());
      in_place.resize(taken);
      ASSERT_EQ(in_place, expected);
    }
  }
}

TEST(RowRing, HoldsTheLastRowsInOrderAtEqualDistances) {
  RowRing ring;
  for (const int width : {1, 16, 33}) {
    for (const int rows : {1, 2, 5}) {
      ring.start(rows, width);
      ASSERT_GE(ring.step(), width);
      for (int y = 0; y < 13; ++y) {
        for (int x = 0; x < width; ++x) ring.next()[x] = static_cast<float>(100 * y + x);
        ring.push();
        for (int ago = 0; ago < rows && ago <= y; ++ago) {
          ASSERT_EQ(ring.row(ago), ring.row(0) - ago * ring.step());
          for (int x = 0; x < width; ++x) ASSERT_EQ(ring.row(ago)[x], 100 * (y - ago) + x);
        }
      }
    }
  }
}

}  // namespace
}  // namespace place_recognition
