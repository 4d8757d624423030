#include "coordinator/report/ring_chains.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::UnorderedElementsAre;

TEST(RingsOfTest, FollowsSegmentsInAnyOrder) {
  EXPECT_THAT(RingsOf({{3, 0}, {1, 2}, {0, 1}, {2, 3}, {8, 9}, {7, 8}, {9, 7}}),
              UnorderedElementsAre(ElementsAre(0, 1, 2, 3), ElementsAre(7, 8, 9)));
}

TEST(RingsOfTest, ASeamBetweenTwoHolesBoundsNothing) {
  const auto rings = RingsOf({{0, 1}, {1, 2}, {2, 0}, {2, 1}, {1, 3}, {3, 2}});
  ASSERT_THAT(rings, SizeIs(1));
  EXPECT_THAT(rings[0], ElementsAre(0, 1, 3, 2));
}

TEST(RingsOfTest, RingsThatTouchAtAVertexAreTwo) {
  EXPECT_THAT(RingsOf({{0, 1}, {1, 2}, {2, 0}, {0, 3}, {3, 4}, {4, 0}}), SizeIs(2));
}

TEST(RingsOfTest, AWalkThatEndsNowhereIsLeftOut) {
  EXPECT_THAT(RingsOf({{0, 1}, {1, 2}}), IsEmpty());
  EXPECT_THAT(RingsOf({}), IsEmpty());
}

std::vector<Point2> Square(double low, double high) { return {{low, low}, {high, low}, {high, high}, {low, high}}; }
std::vector<Point2> Turned(std::vector<Point2> ring) { return {ring.rbegin(), ring.rend()}; }

TEST(PolygonsOfTest, IslandsBelongToTheOutlineAroundThem) {
  for (const bool turned : {false, true}) {
    std::vector<std::vector<Point2>> rings = {Turned(Square(42, 43)), Square(0, 20), Square(40, 50),
                                              Turned(Square(5, 6))};
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

}  // namespace
}  // namespace tilemend
