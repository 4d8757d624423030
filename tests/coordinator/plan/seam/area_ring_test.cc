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
  const Ring outer = {{0, 0}, {9, 0}, {9, 9}, {0, 9}}, hole = {{3, 3}, {6, 3}, {6, 6}, {3, 6}};
  for (const bool turned : {false, true}) {
    PlanePolygon area{{outer, hole}};
    if (turned) {
      for (Ring& ring : area.rings) std::reverse(ring.begin(), ring.end());
    }
    const std::vector<Ring> rings = OrientedRings(area);
    EXPECT_EQ(TwiceArea(rings[0]), -162);
    EXPECT_EQ(TwiceArea(rings[1]), 18);
  }
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

}  // namespace
}  // namespace tilemend
