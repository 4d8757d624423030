#include "worker/fill/wang/fair_patch.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/worker/fill/wang/wang_patches.h"

namespace tilemend {
namespace {

double Roughness(const NewPatch& patch) {
  double sum = 0;
  for (int32_t v = patch.rim_count; v < patch.size(); ++v) sum += std::abs(patch.points[v].z());
  return sum;
}

TEST(FairPatchTest, KeepsAPlane) {
  NewPatch patch = SquarePatch(6, [](double x, double y) { return 0.3 * x - 0.2 * y; });
  ASSERT_TRUE(FairPatch(NothingAround(patch), 5, patch));
  for (const Point3& p : patch.points) EXPECT_NEAR(p.z(), 0.3 * p.x() - 0.2 * p.y(), 1e-9);
}

TEST(FairPatchTest, EveryStepTakesOutRoughness) {
  const auto bumps = [](double x, double y) { return std::fmod(3 * x + 5 * y, 2) - 0.5; };
  double last = 1e9;
  for (const int32_t steps : {0, 1, 3}) {
    NewPatch patch =
        SquarePatch(8, [&](double x, double y) { return x == 0 || y == 0 || x == 8 || y == 8 ? 0 : bumps(x, y); });
    ASSERT_TRUE(FairPatch(NothingAround(patch), steps, patch));
    EXPECT_LT(Roughness(patch), last);
    last = Roughness(patch);
  }
}

TEST(FairPatchTest, LeavesOfTheStartWhatIsBroad) {
  const auto dome = [](double x, double y) { return x * (24 - x) * y * (24 - y) / 2000; };
  NewPatch patch = SquarePatch(24, dome);
  ASSERT_TRUE(FairPatch(NothingAround(patch), 1, patch));
  EXPECT_GT(Roughness(patch), 1) << "a solution of U^2 = 0 alone would be flat";
}

TEST(FairPatchTest, GoesOnWithTheSlopeAround) {
  NewPatch patch = SquarePatch(4, [](double, double) { return 0.0; });
  NewPatch freely = patch;
  PatchSurroundings around = NothingAround(patch);
  // Ground that falls away to the south of points 1 to 3.
  for (int32_t x = 0; x <= 4; ++x) around.points.emplace_back(x, -1, -2);
  const int32_t first = patch.size();
  for (int32_t x = 0; x < 4; ++x) {
    around.triangles.push_back({first + x, first + x + 1, x + 1});
    around.triangles.push_back({first + x, x + 1, x});
  }
  for (const int32_t v : {1, 2, 3}) around.has_equation[v] = true;
  ASSERT_TRUE(FairPatch(around, 3, patch));
  ASSERT_TRUE(FairPatch(NothingAround(freely), 3, freely));
  EXPECT_NEAR(Roughness(freely), 0, 1e-9);
  EXPECT_GT(patch.points[patch.rim_count + 1].z(), 0.1) << "it rises beyond an edge that the ground rises to";
}

}  // namespace
}  // namespace tilemend
