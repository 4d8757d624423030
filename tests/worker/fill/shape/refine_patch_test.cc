#include "worker/fill/shape/refine_patch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/mesh/triangle_shape.h"
#include "worker/fill/mesh/patch_mesh.h"

namespace tilemend {
namespace {

// A fan over a circle of `n` points.
NewPatch Fan(int32_t n, double radius) {
  NewPatch patch;
  for (int32_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    patch.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), std::cos(3 * angle));
    if (i >= 2) patch.triangles.push_back({0, i - 1, i});
  }
  patch.rim_count = n;
  patch.sizes.assign(static_cast<size_t>(n), 2 * std::numbers::pi * radius / n);
  return patch;
}

RefineOptions Uniform() {
  RefineOptions options;
  options.uniform = true;
  return options;
}

const auto kAnyEdge = [](int32_t, int32_t) { return true; };

TEST(RefinePatchTest, ComesToTheDensityOfTheRim) {
  NewPatch patch = Fan(60, 10);
  RefinePatch(Uniform(), kAnyEdge, patch);
  double area = 0;
  for (const Triangle& t : patch.triangles) {
    EXPECT_GT(TwiceVectorArea(patch.points, t).z(), 0);
    area += TwiceVectorArea(patch.points, t).z() / 2;
  }
  EXPECT_NEAR(area, 60 * 0.5 * 100 * std::sin(2 * std::numbers::pi / 60), 1e-9);
  EXPECT_TRUE(PatchMesh(patch.points, patch.triangles).IsManifold());
  const double mean = area / static_cast<double>(patch.triangles.size());
  const double of_rim = std::sqrt(3.0) / 4 * patch.sizes[0] * patch.sizes[0];
  EXPECT_GT(mean, 0.4 * of_rim);
  EXPECT_LT(mean, 1.6 * of_rim);
}

TEST(RefinePatchTest, GrowsInwardWhereTheOptionsSaySo) {
  NewPatch even = Fan(120, 30), graded = even;
  RefinePatch(Uniform(), kAnyEdge, even);
  RefinePatch(RefineOptions(), kAnyEdge, graded);
  EXPECT_LT(2 * graded.size(), even.size());
}

// Beside an edge of the rim that stays long, points would come ever closer to it.
TEST(RefinePatchTest, MakesNoTriangleFlatterThanTheOutputHolds) {
  for (const double least : {0.0, 0.02}) {
    NewPatch patch;
    patch.points = {{0, 0, 0}, {40, 0, 0}, {30, 9, 0}, {20, 10, 0}, {10, 9, 0}};
    patch.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}};
    patch.rim_count = 5;
    patch.sizes.assign(5, 0.3);
    patch.least_height = least;
    RefinePatch(Uniform(), kAnyEdge, patch);
    double lowest = 1;
    for (const Triangle& t : patch.triangles) {
      double longest = 0;
      for (int k = 0; k < 3; ++k) {
        longest = std::max(longest, (patch.points[t[(k + 1) % 3]] - patch.points[t[k]]).norm());
      }
      lowest = std::min(lowest, TwiceVectorArea(patch.points, t).z() / longest);
    }
    EXPECT_GT(patch.size(), 100);
    if (least > 0) {
      EXPECT_GE(lowest, least * (1 - 1e-9));
    } else {
      EXPECT_LT(lowest, 0.002);
    }
  }
}

TEST(RefinePatchTest, LeavesTrianglesOfTheWantedSize) {
  NewPatch patch = Fan(4, 1);
  RefinePatch(Uniform(), kAnyEdge, patch);
  EXPECT_EQ(patch.size(), 4);
  EXPECT_EQ(patch.triangles.size(), 2U);
}

TEST(RefinePatchTest, KeepsAFixedEdge) {
  NewPatch patch;
  patch.points = {{0, 0, 0}, {10, -1, 0}, {20, 0, 0}, {10, 1, 0}};
  patch.sizes.assign(4, 30);
  patch.rim_count = 4;
  patch.triangles = {{0, 1, 2}, {0, 2, 3}};
  NewPatch fixed = patch;
  fixed.fixed_edges = {{0, 2}};
  RefinePatch(Uniform(), kAnyEdge, fixed);
  EXPECT_EQ(fixed.triangles, patch.triangles);
  RefinePatch(Uniform(), kAnyEdge, patch);
  EXPECT_NE(fixed.triangles, patch.triangles);
}

TEST(RefinePatchTest, LeavesTrianglesInAStripAsTheyAre) {
  NewPatch patch;
  patch.points = {{0, 0, 0}, {9, 0, 0}, {18, 0, 0}, {18, 9, 0}, {9, 9, 0}, {0, 9, 0}};
  patch.sizes.assign(6, 1);
  patch.rim_count = 6;
  patch.triangles = {{0, 1, 4}, {0, 4, 5}, {1, 2, 3}, {1, 3, 4}};
  patch.fixed_edges = {{1, 4}};
  patch.strips = {1, 3, 2, 2, 3, 1};
  NewPatch part = patch;
  part.strips[2] = 0;  // this corner of the eastern half bounds no strip
  RefinePatch(Uniform(), kAnyEdge, patch);
  EXPECT_EQ(patch.size(), 6);
  RefinePatch(Uniform(), kAnyEdge, part);
  ASSERT_GT(part.size(), 6);
  for (int32_t v = 6; v < part.size(); ++v) EXPECT_GT(part.points[v].x(), 9);
}

TEST(RefinePatchTest, SplitsAForbiddenEdge) {
  NewPatch patch = Fan(5, 1);
  RefinePatch(
      Uniform(), [](int32_t a, int32_t b) { return a + b != 2; }, patch);
  EXPECT_TRUE(PatchMesh(patch.points, patch.triangles).IsManifold());
  EXPECT_FALSE(PatchMesh(patch.points, patch.triangles).HalfEdge(0, 2).is_valid());
  EXPECT_GT(patch.size(), 5);
}

TEST(RefinePatchTest, MakesNoForbiddenEdge) {
  NewPatch patch;
  patch.points = {{0, 0, 0}, {10, -1, 0}, {20, 0, 0}, {10, 1, 0}};
  patch.sizes.assign(4, 30);
  patch.rim_count = 4;
  patch.triangles = {{0, 1, 2}, {0, 2, 3}};
  NewPatch kept = patch;
  RefinePatch(
      Uniform(), [](int32_t a, int32_t b) { return std::min(a, b) != 1 || std::max(a, b) != 3; }, kept);
  EXPECT_EQ(kept.triangles, patch.triangles);
  RefinePatch(Uniform(), kAnyEdge, patch);
  EXPECT_NE(kept.triangles, patch.triangles) << "the short diagonal";
}

}  // namespace
}  // namespace tilemend
