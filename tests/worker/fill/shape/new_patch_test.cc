#include "worker/fill/shape/new_patch.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/worker/papers/wang/wang_patches.h"

namespace tilemend {
namespace {

NewPatch OnePoint() {
  return SquarePatch(2, [](double, double) { return 0.0; });
}

TEST(PointMoverTest, MovesAPointWhereNothingTurnsOver) {
  NewPatch patch = OnePoint();
  PointMover(patch).Move(8, Point3(1.2, 0.9, 1.25));
  EXPECT_EQ(patch.points[8], Point3(1.2, 0.9, 1.25));
}

TEST(PointMoverTest, MovesAPointHalfTheWayWhereThatTurnsNothingOver) {
  NewPatch patch = OnePoint();
  PointMover(patch).Move(8, Point3(2.5, 1, 1));
  EXPECT_EQ(patch.points[8], Point3(1.75, 1, 0.5));
}

TEST(PointMoverTest, MovesAPointInHeightWhereAllElseTurnsSomethingOver) {
  NewPatch patch = OnePoint();
  PointMover mover(patch);
  mover.Move(8, Point3(1.9, 1, 0));
  mover.Move(8, Point3(3, 1, 1.25));
  EXPECT_EQ(patch.points[8], Point3(1.9, 1, 1.25));
  EXPECT_TRUE(mover.TurnsLeftAround(8));
}

// The square has a diagonal of 2.83.
TEST(PointMoverTest, MovesAPointNoFartherThanItsReach) {
  for (const bool projects : {true, false}) {
    NewPatch patch = OnePoint();
    patch.projects = projects;
    PointMover(patch).Move(8, Point3(1, 1, -50));
    EXPECT_EQ(patch.points[8], Point3(1, 1, -std::sqrt(2)));
  }
}

TEST(PointMoverTest, MovesAPointAnywhereInSpace) {
  NewPatch patch = OnePoint();
  patch.projects = false;
  PointMover mover(patch);
  mover.Move(8, Point3(3, 1, 1.25));
  EXPECT_EQ(patch.points[8], Point3(3, 1, 1.25));
  EXPECT_FALSE(mover.TurnsLeftAround(8));
}

}  // namespace
}  // namespace tilemend
