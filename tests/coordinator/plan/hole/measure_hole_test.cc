#include "coordinator/plan/hole/measure_hole.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

TEST(MeasureHoleTest, CountsOriginalEdgesAlone) {
  const std::vector<Point3> position = {{0, 0, 0}, {3, 0, 4}, {3, 2, 4}, {0, 2, 0}};
  const PlannedHole hole = MeasureHole({1, 2}, {{0, 1, false}, {1, 2, false}, {2, 3, true}, {3, 0, true}}, position);
  EXPECT_EQ(hole.cell, (CellId{1, 2}));
  EXPECT_EQ(hole.perimeter, 5 + 2);
  EXPECT_EQ(hole.boundary_vertices, 2);
  EXPECT_EQ(hole.centre, Point2(1.5, 1));
  EXPECT_EQ(hole.segments.size(), 4U);
}

TEST(MeasureHoleTest, FindsNoPerimeterBetweenSeams) {
  const std::vector<Point3> position = {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}};
  const PlannedHole hole = MeasureHole({}, {{0, 1, true}, {1, 2, true}, {2, 0, true}}, position);
  EXPECT_EQ(hole.perimeter, 0);
  EXPECT_EQ(hole.boundary_vertices, 0);
}

}  // namespace
}  // namespace tilemend
