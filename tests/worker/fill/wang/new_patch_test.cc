#include "worker/fill/wang/new_patch.h"

#include <gtest/gtest.h>

#include "tests/worker/fill/wang/wang_patches.h"

namespace tilemend {
namespace {

NewPatch OnePoint() {
  return SquarePatch(2, [](double, double) { return 0.0; });
}

TEST(PointMoverTest, MovesAPointWhereNothingTurnsOver) {
  NewPatch patch = OnePoint();
  PointMover(patch).Move(8, Point3(1.2, 0.9, 5));
  EXPECT_EQ(patch.points[8], Point3(1.2, 0.9, 5));
}

TEST(PointMoverTest, MovesAPointHalfTheWayWhereThatTurnsNothingOver) {
  NewPatch patch = OnePoint();
  PointMover(patch).Move(8, Point3(2.5, 1, 4));
  EXPECT_EQ(patch.points[8], Point3(1.75, 1, 2));
}

TEST(PointMoverTest, MovesAPointInHeightWhereAllElseTurnsSomethingOver) {
  NewPatch patch = OnePoint();
  PointMover mover(patch);
  mover.Move(8, Point3(9, 1, 3));
  EXPECT_EQ(patch.points[8], Point3(1, 1, 3));
  EXPECT_TRUE(mover.TurnsLeftAround(8));
}

TEST(PointMoverTest, MovesAPointAnywhereInSpace) {
  NewPatch patch = OnePoint();
  patch.projects = false;
  PointMover mover(patch);
  mover.Move(8, Point3(9, 1, 3));
  EXPECT_EQ(patch.points[8], Point3(9, 1, 3));
  EXPECT_FALSE(mover.TurnsLeftAround(8));
}

}  // namespace
}  // namespace tilemend
