#include "coordinator/plan/seam/area_ring.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/seam_scene.h"

namespace tilemend {
namespace {

using Ring = std::vector<Point2>;

double TwiceArea(const Ring& ring) {
  double area = 0;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Point2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
    area += a.x() * b.y() - b.x() * a.y();
  }
  return area;
}

TEST(OrientedRingsTest, HaveTheInsideOnTheirRight) {
  const SeamScene s({"####", "####", "####", "####"}, 4);
  const Ring outer = {{0, 0}, {9, 0}, {9, 9}, {0, 9}}, hole = {{3, 3}, {6, 3}, {6, 6}, {3, 6}};
  for (const bool turned : {false, true}) {
    PlanePolygon area{{outer, hole}};
    if (turned) {
      for (Ring& ring : area.rings) std::reverse(ring.begin(), ring.end());
    }
    const std::vector<Ring> rings = OrientedRings(area, s.Site());
    EXPECT_EQ(TwiceArea(rings[0]), -162);
    EXPECT_EQ(TwiceArea(rings[1]), 18);
  }
}

// A hole of 2 x 2 squares.
const std::vector<std::string> kPond = {"######", "######", "##..##", "##..##", "######", "######"};

TEST(OrientedRingsTest, TheOutlineOfAHoleMovesOnToTheSurface) {
  const SeamScene s(kPond, 6);
  const std::vector<Ring> rings = OrientedRings({{{{2, 2}, {4, 2}, {4, 4}, {2, 4}}}}, s.Site());
  ASSERT_EQ(rings.size(), 1U);
  ASSERT_EQ(rings[0].size(), 4U);
  for (const Point2& p : rings[0]) {
    EXPECT_TRUE(s.index.InSurface(p, 1e-6)) << p.transpose();
    EXPECT_GT(s.index.Distance(p, 1), 0.1) << p.transpose();
  }
}

TEST(OrientedRingsTest, RingsAlongTheRimOfWhatTheyLeaveOutStay) {
  const SeamScene s(kPond, 6);
  const Ring end = {{0, 0}, {6, 0}, {6, 6}, {0, 6}}, pond = {{2, 2}, {4, 2}, {4, 4}, {2, 4}};
  const std::vector<Ring> rings = OrientedRings({{end, pond}}, s.Site());
  EXPECT_EQ(TwiceArea(rings[0]), -72);
  EXPECT_EQ(TwiceArea(rings[1]), 8);
}

// A hole of 6 x 6 squares over the border of two cells of 8.
const std::vector<std::string> kLake = {"########|########", "#####...|...#####", "#####...|...#####",
                                        "#####...|...#####", "#####...|...#####", "#####...|...#####",
                                        "#####...|...#####", "########|########"};

TEST(RingSpacerTest, HasAVertexWhereTheLineCrossesAGridLine) {
  const SeamScene s(kLake, 8);
  const std::vector<RingVertex> along = RingSpacer(s.Site()).Along({{5.5, 4.25}, {10.5, 4.25}});
  EXPECT_TRUE(std::any_of(along.begin(), along.end(), [](const RingVertex& v) { return v.position.x() == 8; }));
  for (const RingVertex& v : along) EXPECT_EQ(v.position.y(), 4.25);
}

TEST(RingSpacerTest, KeepsCornersAndLeavesOutWhatIsNearTheRim) {
  const SeamScene s(kLake, 8);
  const std::vector<RingVertex> along = RingSpacer(s.Site()).Along({{3, 4}, {7, 4}, {7, 0}});
  EXPECT_TRUE(std::any_of(along.begin(), along.end(), [](const RingVertex& v) { return v.position == Point2(7, 4); }));
  for (const RingVertex& v : along) EXPECT_GT(s.index.Distance(v.position, 1), 0.2) << v.position.transpose();
}

TEST(RingSpacerTest, KeepsTheCornersOfARingThatIsSmall) {
  const SeamScene s(kLake, 8);
  const Ring ring = {{7, 4}, {7.0625, 4}, {7.0625, 4.0625}};
  const std::vector<RingVertex> around = RingSpacer(s.Site()).Around(ring);
  ASSERT_EQ(around.size(), 3U);
  for (size_t i = 0; i < 3; ++i) EXPECT_EQ(around[i].position, ring[i]);
}

TEST(RingSpacerTest, KeepsACornerNearTheRimThatTheLineCannotDoWithout) {
  const SeamScene s(kLake, 8);
  const std::vector<RingVertex> along = RingSpacer(s.Site()).Along({{7, 3}, {5.03125, 4}, {7, 5}});
  EXPECT_TRUE(std::ranges::any_of(along, [](const RingVertex& v) { return v.position == Point2(5.03125, 4); }));
}

}  // namespace
}  // namespace tilemend
