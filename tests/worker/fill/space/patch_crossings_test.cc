#include "worker/fill/space/patch_crossings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace tilemend {
namespace {

const SpaceTriangle kFlat = {Point3(0, 0, 0), Point3(4, 0, 0), Point3(0, 4, 0)};
const SpaceTriangle kThrough = {Point3(1, 1, -1), Point3(1, 1, 1), Point3(9, 9, 0)};
const SpaceTriangle kAbove = {Point3(0, 0, 3), Point3(4, 0, 3), Point3(0, 4, 3)};
const SpaceTriangle kNeighbour = {Point3(4, 0, 0), Point3(0, 0, 0), Point3(2, -3, 1)};
const SpaceTriangle kFoldedBack = {Point3(4, 0, 0), Point3(0, 0, 0), Point3(1, 3, 0)};
const SpaceTriangle kAtACorner = {Point3(0, 0, 0), Point3(-3, 1, 0), Point3(-3, -1, 2)};
const SpaceTriangle kThroughFromACorner = {Point3(0, 0, 0), Point3(1, 1, 2), Point3(2, 2, -2)};

bool Crosses(const std::vector<SpaceTriangle>& patch, const std::vector<SpaceTriangle>& surface = {}) {
  return PatchCrosses(patch, surface);
}

TEST(PatchCrossingsTest, SeesAnEdgeThatPassesThrough) {
  EXPECT_TRUE(Crosses({kFlat, kThrough}));
  EXPECT_TRUE(Crosses({kThrough, kFlat}));
  EXPECT_TRUE(Crosses({kFlat}, {kThrough}));
  EXPECT_TRUE(Crosses({kFlat, kThroughFromACorner}));
}

TEST(PatchCrossingsTest, SeesATriangleFoldedOntoItsNeighbour) { EXPECT_TRUE(Crosses({kFlat, kFoldedBack})); }

TEST(PatchCrossingsTest, LetsNeighboursBe) {
  EXPECT_FALSE(Crosses({kFlat, kAbove, kNeighbour, kAtACorner}));
  EXPECT_FALSE(Crosses({kFlat}, {kAbove, kNeighbour, kAtACorner}));
}

// Triangles that a plane parts are told apart without exact signs: the answers stay those of the edges.
TEST(TrianglesCrossTest, AnswersAsTheEdgesDo) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> place(-2, 2);
  const auto point = [&] { return Point3(place(random), place(random), place(random)); };
  const auto meets = [](const SpaceTriangle& a, const SpaceTriangle& b) {
    for (int k = 0; k < 3; ++k) {
      const Point3 &p = a[k], &q = a[(k + 1) % 3];
      if (std::ranges::count(b, p) + std::ranges::count(b, q) == 0 && SegmentCrosses(p, q, b)) return true;
    }
    return false;
  };
  int apart = 0, crossing = 0;
  for (int i = 0; i < 200000; ++i) {
    const SpaceTriangle a = {point(), point(), point()}, b = {i % 2 == 0 ? a[0] : point(), point(), point()};
    if (!HasArea(a) || !HasArea(b)) continue;
    const auto shared = std::ranges::count_if(a, [&](const Point3& p) { return std::ranges::count(b, p) > 0; });
    if (shared > 1) continue;
    const bool expected = meets(a, b) || meets(b, a);
    ASSERT_EQ(TrianglesCross(a, b), expected) << i;
    ++(expected ? crossing : apart);
  }
  EXPECT_GT(std::min(apart, crossing), 10000);
}

TEST(PatchCrossingsTest, LeavesTheSurfaceToItself) { EXPECT_FALSE(Crosses({kAbove}, {kFlat, kThrough})); }

TEST(PatchCrossingsTest, SeesTrianglesThatOverlapInOnePlane) {
  EXPECT_TRUE(Crosses({kFlat}, {{Point3(1, 1, 0), Point3(9, 1, 0), Point3(9, 2, 0)}})) << "a corner inside";
  EXPECT_TRUE(Crosses({kFlat}, {{Point3(-9, -9, 0), Point3(19, -9, 0), Point3(-9, 19, 0)}})) << "around";
  EXPECT_TRUE(Crosses({kFlat}, {{Point3(-1, 1, 0), Point3(9, 1, 0), Point3(9, 1.5, 0)}})) << "across";
  EXPECT_TRUE(Crosses({kFlat}, {{Point3(0, 0, 0), Point3(9, 1, 0), Point3(1, 9, 0)}})) << "from a corner";
  EXPECT_FALSE(Crosses({kFlat}, {{Point3(0, 0, 0), Point3(-9, -1, 0), Point3(-1, -9, 0)}})) << "beyond a corner";
  EXPECT_FALSE(Crosses({kFlat}, {{Point3(5, 5, 0), Point3(9, 5, 0), Point3(5, 9, 0)}})) << "beside";
}

TEST(PatchCrossingsTest, SeesABareTouch) {
  EXPECT_TRUE(Crosses({kFlat}, {{Point3(1, 1, 0), Point3(1, 2, 3), Point3(2, 1, 3)}})) << "inside";
  EXPECT_TRUE(Crosses({kFlat}, {{Point3(2, 0, 0), Point3(1, -2, 3), Point3(2, -1, 3)}})) << "on an edge";
  EXPECT_TRUE(Crosses({kFlat}, {{Point3(1, 0, 0), Point3(2, 0, 0), Point3(1, -1, 1)}})) << "along an edge";
  EXPECT_TRUE(Crosses({kFlat, kFlat})) << "twice the same";
}

// A fan of triangles about a point, turned so that rounding puts none of them exactly on the plane of another.
TEST(PatchCrossingsTest, LetsAFlatFanBe) {
  std::vector<SpaceTriangle> fan;
  const auto at = [](int k) {
    const double a = 0.7 * k;
    return Point3(1.1 + std::cos(a) * 0.8 - std::sin(a) * 0.36, 0.3 + std::sin(a) * 0.8,
                  std::cos(a) * 0.6 + std::sin(a) * 0.48);
  };
  for (int k = 0; k < 8; ++k) fan.push_back({Point3(1.1, 0.3, 0), at(k), at(k + 1)});
  EXPECT_FALSE(Crosses(fan));
}

TEST(PatchCrossingsTest, NamesTheTrianglesThatCross) {
  EXPECT_THAT(SelfCrossings(std::vector{kThrough, kAbove, kFlat}), testing::ElementsAre(testing::Pair(0, 2)));
}

TEST(PatchCrossingsTest, NamesTheSurfaceThatIsCrossed) {
  EXPECT_THAT(SurfaceCrossings(std::vector{kAbove, kFlat}, std::vector{kAbove, kThrough}),
              testing::ElementsAre(testing::Pair(0, 0), testing::Pair(1, 1)));
}

TEST(PatchCrossingsTest, SeesASegmentThatMeetsATriangle) {
  EXPECT_TRUE(SegmentCrosses(Point3(1, 1, -1), Point3(1, 1, 1), kFlat));
  EXPECT_TRUE(SegmentCrosses(Point3(-1, 1, 0), Point3(9, 1, 0), kFlat));
  EXPECT_FALSE(SegmentCrosses(Point3(3, 3, -1), Point3(3, 3, 1), kFlat));
  EXPECT_FALSE(SegmentCrosses(Point3(1, 1, -1), Point3(1, 1, 1), {Point3(0, 0, 0), Point3(1, 1, 0), Point3(2, 2, 0)}));
}

}  // namespace
}  // namespace tilemend
