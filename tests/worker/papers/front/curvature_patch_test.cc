#include "worker/papers/front/curvature_patch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support/front_rims.h"

namespace tilemend {
namespace {

// A fan of twelve triangles on the top of a sphere.
TEST(AbsoluteCurvaturesTest, IsThatOfASphere) {
  const double radius = 3;
  std::vector<Point3> points = {Point3(0, 0, radius)};
  std::vector<Triangle> triangles;
  for (int i = 0; i < 12; ++i) {
    points.emplace_back(0.3 * std::cos(i * std::numbers::pi / 6), 0.3 * std::sin(i * std::numbers::pi / 6),
                        std::sqrt(radius * radius - 0.09));
    triangles.push_back({0, 1 + i, 1 + (i + 1) % 12});
  }
  EXPECT_NEAR(AbsoluteCurvatures(points, triangles, 1)[0], 1 / (radius * radius), 0.02);
}

TEST(AbsoluteCurvaturesTest, IsNothingOnAPlane) {
  const std::vector<Point3> points = {Point3(0, 0, 0), Point3(1, 0, 0), Point3(0, 1, 0), Point3(-1, -1, 0)};
  const std::vector<Triangle> triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}};
  EXPECT_EQ(AbsoluteCurvatures(points, triangles, 1)[0], 0);
  const std::vector<Point3> odd = {Point3(0.1, 0.3, 0), Point3(1.7, 0.2, 0), Point3(0.3, 1.9, 0),
                                   Point3(-1.1, -0.7, 0)};
  EXPECT_EQ(AbsoluteCurvatures(odd, triangles, 1)[0], 0) << "but for rounding";
}

class CurvaturePatchTest : public testing::Test {
 protected:
  CurvaturePatch Refined(const FillerOptions& options) const {
    CurvaturePatch patch{front_.points, 30, front_.triangles};
    RefineByCurvature({rim_.points, {}}, options, rim_.may_join, patch);
    return patch;
  }

  const FrontRim rim_ = SphereRim(30, 7);
  const FrontPatch front_ = AdvanceFront(rim_, NormalCurvatureRule({}), EnoughFor(rim_));
};

TEST_F(CurvaturePatchTest, WithoutHalvingsNoPointIsNew) {
  FillerOptions options;
  options.halvings = 0;
  EXPECT_EQ(Refined(options).points.size(), front_.points.size());
}

TEST_F(CurvaturePatchTest, RefinesWhereItIsMoreCurvedThanTheRim) {
  // Flat but for one point that stands out.
  RimSurface around{FlatRim(30).points, {}};
  for (int32_t v = 0; v < 30; ++v) {
    const int32_t next = (v + 1) % 30;
    around.points.emplace_back(1.2 * around.points[v]);
    around.triangles.push_back({next, v, 30 + v});
    around.triangles.push_back({next, 30 + v, 30 + next});
  }
  FrontPatch flat = AdvanceFront(FlatRim(30), PlainRule(), EnoughFor(rim_));
  flat.points[40].z() = 1.5;
  CurvaturePatch patch{flat.points, 30, flat.triangles};
  RefineByCurvature(around, {}, rim_.may_join, patch);
  EXPECT_GT(patch.points.size(), flat.points.size());
}

TEST_F(CurvaturePatchTest, TheRimStays) {
  const CurvaturePatch patch = Refined({});
  for (int32_t v = 0; v < 30; ++v) EXPECT_EQ(patch.points[v], rim_.points[v]);
}

TEST_F(CurvaturePatchTest, CentroidsMovePoints) {
  FillerOptions still;
  still.centroid_steps = 0;
  EXPECT_NE(Refined(still).points, Refined({}).points);
}

}  // namespace
}  // namespace tilemend
