#include "common/mesh/ring_polygons.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

std::vector<Point2> RingOf(double low, double high) { return {{low, low}, {high, low}, {high, high}, {low, high}}; }
std::vector<Point2> Turned(std::vector<Point2> ring) { return {ring.rbegin(), ring.rend()}; }

TEST(PolygonsOfTest, IslandsBelongToTheOutlineAroundThem) {
  for (const bool turned : {false, true}) {
    std::vector<std::vector<Point2>> rings = {Turned(RingOf(42, 43)), RingOf(0, 20), RingOf(40, 50),
                                              Turned(RingOf(5, 6))};
    if (turned) std::transform(rings.begin(), rings.end(), rings.begin(), Turned);
    const auto polygons = PolygonsOf(rings);
    ASSERT_THAT(polygons, SizeIs(2));
    EXPECT_EQ(polygons[0].outline, 2);
    EXPECT_THAT(polygons[0].islands, ElementsAre(0));
    EXPECT_EQ(polygons[1].outline, 1);
    EXPECT_THAT(polygons[1].islands, ElementsAre(3));
  }
}

TEST(PolygonsOfTest, ARingWithoutAreaIsAPolygonAllTheSame) {
  EXPECT_THAT(PolygonsOf({{{0, 0}, {1, 1}, {2, 2}}}), SizeIs(1)) << "a hole in a wall, seen from above";
  EXPECT_THAT(PolygonsOf({}), IsEmpty());
}

TEST(PolygonsOfTest, DirectionsDoNotMatter) {
  const auto polygons = PolygonsOf({RingOf(40, 50), Turned(RingOf(0, 20)), Turned(RingOf(2, 9)), RingOf(4, 5)});
  ASSERT_THAT(polygons, SizeIs(3));
  EXPECT_EQ(polygons[0].outline, 3) << "an outline in a hole";
  EXPECT_EQ(polygons[1].outline, 0);
  EXPECT_EQ(polygons[2].outline, 1);
  EXPECT_THAT(polygons[2].islands, ElementsAre(2));
}

}  // namespace
}  // namespace tilemend
