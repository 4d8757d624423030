#include "common/mesh/position_index.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <random>

namespace tilemend {
namespace {

TEST(PositionIndexTest, TakesMinusZeroForZero) {
  PositionIndex index;
  const int32_t n = index.Insert({0.0, -0.0, 5});
  EXPECT_EQ(index.Insert({-0.0, 0.0, 5}), n);
  EXPECT_EQ(index.Find({-0.0, -0.0, 5}), n);
  EXPECT_EQ(index.size(), 1);
}

TEST(PositionIndexTest, TellsNeighbouringNumbersApart) {
  PositionIndex index;
  index.Insert({1, 2, 3});
  EXPECT_EQ(index.Find({1, 2, std::nextafter(3.0, 4.0)}), -1);
}

TEST(PositionIndexTest, TellsAxesApart) {
  PositionIndex index;
  EXPECT_NE(index.Insert({1, 2, 3}), index.Insert({3, 2, 1}));
}

TEST(PositionIndexTest, FindsNothingWhenEmpty) { EXPECT_EQ(PositionIndex().Find({0, 0, 0}), -1); }

TEST(PositionIndexTest, NumbersManyPointsInOrderOfInsertion) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> coordinate(-20, 20);
  std::map<std::array<double, 3>, int32_t> expected;
  PositionIndex index;
  for (int i = 0; i < 100000; ++i) {
    const Point3 p(coordinate(random) * 0.25, coordinate(random) * 1e4, coordinate(random));
    const auto [it, fresh] = expected.try_emplace({p.x(), p.y(), p.z()}, static_cast<int32_t>(expected.size()));
    ASSERT_EQ(index.Insert(p), it->second);
  }
  ASSERT_EQ(index.size(), static_cast<int32_t>(expected.size()));
  for (const auto& [p, n] : expected) {
    ASSERT_EQ(index.Find({p[0], p[1], p[2]}), n);
    ASSERT_EQ(index.positions()[n], Point3(p[0], p[1], p[2]));
    ASSERT_EQ(index.Find({p[0] + 0.125, p[1], p[2]}), -1);
  }
}

}  // namespace
}  // namespace tilemend
