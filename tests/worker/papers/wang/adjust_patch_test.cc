#include "worker/papers/wang/adjust_patch.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/worker/papers/wang/wang_patches.h"

namespace tilemend {
namespace {

// Equation 1, written down once more.
Point3 Expected(const NewPatch& patch, int32_t v) {
  std::set<int32_t> near;
  for (int round = 0; round < 2; ++round) {
    std::set<int32_t> more = near;
    for (const Triangle& t : patch.triangles) {
      for (const int32_t a : t) {
        if (a != v && !near.contains(a)) continue;
        more.insert(t.begin(), t.end());
      }
    }
    near = more;
  }
  Point3 sum = Point3::Zero();
  double weights = 0;
  for (const int32_t n : near) {
    if (n == v) continue;
    const double weight = 1 / (patch.points[n] - patch.points[v]).norm();
    sum += weight * patch.points[n];
    weights += weight;
  }
  return sum / weights;
}

TEST(AdjustPatchTest, TakesTheMeanByEquation1) {
  NewPatch patch = SquarePatch(2, [](double x, double y) { return x == 1 && y == 1 ? 3.0 : 0.2 * x * y; });
  const Point3 expected = Expected(patch, 8);
  AdjustPatch(NothingAround(patch), patch);
  EXPECT_LT((patch.points[8] - expected).norm(), 1e-12);
}

TEST(AdjustPatchTest, GoesFromTheRimInward) {
  NewPatch patch = SquarePatch(4, [](double x, double y) { return x == 2 && y == 2 ? 10.0 : 0.0; });
  NewPatch ring = patch;
  AdjustPatch(NothingAround(patch), patch);
  // The ring beside the rim has moved when the point in the middle does.
  for (int32_t v = ring.rim_count; v < ring.size(); ++v) {
    if (v != 20) ring.points[v] = patch.points[v];
  }
  EXPECT_LT((patch.points[20] - Expected(ring, 20)).norm(), 1e-12);
  EXPECT_GT(patch.points[16].z(), 0) << "the peak is a second neighbour of the corner of the ring";
}

TEST(AdjustPatchTest, CountsThePointsAround) {
  const auto flat = [](double, double) { return 0.0; };
  NewPatch alone = SquarePatch(2, flat), beside = alone;
  AdjustPatch(NothingAround(alone), alone);
  PatchSurroundings around = NothingAround(beside);
  around.points = {Point3(3, -1, 7)};
  around.triangles = {{1, 9, 2}};
  AdjustPatch(around, beside);
  EXPECT_NEAR(alone.points[8].z(), 0, 1e-12);
  EXPECT_GT(beside.points[8].z(), 0.1);
}

TEST(AdjustPatchTest, KeepsTheRim) {
  NewPatch patch = SquarePatch(3, [](double x, double y) { return x * x - y; });
  const NewPatch before = patch;
  AdjustPatch(NothingAround(patch), patch);
  for (int32_t v = 0; v < patch.rim_count; ++v) EXPECT_EQ(patch.points[v], before.points[v]);
}

}  // namespace
}  // namespace tilemend
