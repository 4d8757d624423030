#include "worker/papers/wang/fair_patch.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "tests/worker/papers/wang/wang_patches.h"

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

TEST(FairPatchTest, EndsBeforeOrInAStepOnceCancelled) {
  const auto dome = [](double x, double y) { return x * (24 - x) * y * (24 - y) / 2000; };
  NewPatch one_step = SquarePatch(24, dome);
  int asked = 0;
  ASSERT_TRUE(FairPatch(NothingAround(one_step), 1, one_step, [&] { return ++asked < 0; }));
  const int in_a_step = asked;
  for (const int more : {0, in_a_step / 2}) {
    NewPatch patch = SquarePatch(24, dome);
    asked = 0;
    EXPECT_FALSE(FairPatch(NothingAround(patch), 5, patch, [&] { return ++asked > in_a_step + more; }));
    EXPECT_EQ(asked, in_a_step + more + 1);
    EXPECT_EQ(patch.points, one_step.points);
  }
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

// The cotangent of the angle at `apex`.
double Cotangent(const Point3& apex, const Point3& a, const Point3& b) {
  const Eigen::Vector3d u = a - apex, v = b - apex;
  return u.dot(v) / u.cross(v).norm();
}

// Eq. 2 and 3 as printed, of what lies at each point; no weight is less than 0.001.
Point3 Umbrella(const NewPatch& patch, const std::vector<Point3>& at, int32_t v) {
  std::map<int32_t, double> weight;
  for (const Triangle& t : patch.triangles) {
    for (int k = 0; k < 3; ++k) {
      const int32_t apex = t[k], a = t[(k + 1) % 3], b = t[(k + 2) % 3];
      if (a != v && b != v) continue;
      weight[a == v ? b : a] += Cotangent(patch.points[apex], patch.points[a], patch.points[b]) / 2;
    }
  }
  Point3 sum = Point3::Zero();
  double weights = 0;
  for (const auto& [neighbour, w] : weight) {
    sum += std::max(w, 1e-3) * at[neighbour];
    weights += std::max(w, 1e-3);
  }
  return sum / weights - at[v];
}

// A point of the rim that is not surrounded has no first operator.
TEST(FairPatchTest, GoesAStepAgainstEquation4) {
  NewPatch patch = SquarePatch(6, [](double x, double y) { return 0.2 * std::sin(x) + 0.02 * x * y; });
  for (int32_t v = patch.rim_count; v < patch.size(); ++v) patch.points[v].z() += 0.3 * std::sin(9.0 * v);
  patch.projects = false;
  const NewPatch before = patch;  // whose weights count
  ASSERT_TRUE(FairPatch(NothingAround(patch), 1, patch));
  std::vector<Point3> first(patch.points.size(), Point3::Zero());
  for (int32_t v = patch.rim_count; v < patch.size(); ++v) first[v] = Umbrella(before, patch.points, v);
  for (int32_t v = patch.rim_count; v < patch.size(); ++v) {
    const Point3 from = patch.points[v] + kFairingStep * Umbrella(before, first, v);
    EXPECT_NEAR((from - before.points[v]).norm(), 0, 1e-6) << v;
  }
}

}  // namespace
}  // namespace tilemend
