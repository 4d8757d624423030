#include "worker/papers/front/poisson_patch.h"

#include <gtest/gtest.h>

#include "tests/support/front_rims.h"

namespace tilemend {
namespace {

TEST(PoissonPatchTest, BendsAPatchTheWayTheRimFaces) {
  const FrontRim rim = SphereRim(40, 9);
  FrontPatch patch = AdvanceFront(rim, PlainRule(), EnoughFor(rim));
  ASSERT_TRUE(patch.closed());
  // Flat at first.
  for (Point3& p : patch.points) p.z() = rim.points[0].z();
  ASSERT_TRUE(ShapeByNormals(rim.areas, patch.triangles, patch.points));
  double highest = 0;
  for (const Point3& p : patch.points) highest = std::max(highest, p.z());
  EXPECT_GT(highest - rim.points[0].z(), 0.6 * (9 - rim.points[0].z()));
  EXPECT_LT(highest, 9.5);
}

TEST(PoissonPatchTest, LeavesAFlatPatchFlat) {
  const FrontRim rim = FlatRim(20);
  FrontPatch patch = AdvanceFront(rim, PlainRule(), EnoughFor(rim));
  ASSERT_TRUE(patch.closed());
  const std::vector<Point3> before = patch.points;
  ASSERT_TRUE(ShapeByNormals(rim.areas, patch.triangles, patch.points));
  for (size_t v = 0; v < before.size(); ++v) EXPECT_LT((patch.points[v] - before[v]).norm(), 1e-9);
}

TEST(PoissonPatchTest, ATriangleStays) {
  FrontRim rim = FlatRim(3);
  std::vector<Point3> points = rim.points;
  const std::vector<Triangle> triangles = {{0, 1, 2}};
  EXPECT_TRUE(ShapeByNormals(rim.areas, triangles, points));
  EXPECT_EQ(points, rim.points);
}

}  // namespace
}  // namespace tilemend
