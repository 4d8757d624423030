#include "worker/papers/front/svm_patch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "tests/support/front_rims.h"

namespace tilemend {
namespace {

class SvmPatchTest : public testing::Test {
 protected:
  double HeightWith(std::span<const LaplacianSample> samples) {
    std::vector<Point3> points = patch_.points;
    EXPECT_TRUE(ShapeByLaplacians(samples, {}, 1, patch_.triangles, 24, points));
    double most = 0;
    for (const Point3& p : points) most = std::abs(p.z()) > std::abs(most) ? p.z() : most;
    return most;
  }

  const FrontRim rim_ = FlatRim(24);
  const FrontPatch patch_ = AdvanceFront(rim_, PlainRule(), EnoughFor(rim_));
};

std::vector<LaplacianSample> SamplesOf(double laplacian) {
  std::vector<LaplacianSample> samples;
  for (int x = -6; x <= 6; ++x) samples.push_back({Point3(x, -x, 0), Eigen::Vector3d(0, 0, laplacian)});
  return samples;
}

TEST_F(SvmPatchTest, WithoutSamplesAFlatRimGivesAFlatPatch) { EXPECT_NEAR(HeightWith({}), 0, 1e-12); }

TEST_F(SvmPatchTest, BendsAsTheSurfaceAroundItDoes) {
  const double radius = 24 / (2 * std::numbers::pi);
  EXPECT_NEAR(HeightWith(SamplesOf(-0.1)), 0.1 * radius * radius / 4, 0.02);
  EXPECT_NEAR(HeightWith(SamplesOf(0.1)), -0.1 * radius * radius / 4, 0.02);
}

// What eq. 4 says is the same for triangles of any size; what eq. 2 says grows with their edges.
TEST_F(SvmPatchTest, ScalesLaplaciansAsTheyWereLearnt) {
  const auto samples = SamplesOf(-0.1);
  const auto top = [&](LaplacianScale scale, double size) {
    std::vector<Point3> points;
    for (const Point3& p : patch_.points) points.push_back(size * p);
    FillerOptions options;
    options.scale = scale;
    EXPECT_TRUE(ShapeByLaplacians(samples, options, 1, patch_.triangles, 24, points));
    return std::ranges::max(points, {}, [](const Point3& p) { return p.z(); }).z();
  };
  EXPECT_NEAR(top(LaplacianScale::kMean, 0.5) / top(LaplacianScale::kMean, 1), 1, 0.2);
  EXPECT_NEAR(top(LaplacianScale::kArea, 0.5) / top(LaplacianScale::kArea, 1), 0.25, 0.05);
}

TEST_F(SvmPatchTest, ManySamplesAreThinned) {
  std::vector<LaplacianSample> many;
  for (int i = 0; i < 4001; ++i) many.push_back({Point3(0.001 * i, 0, 0), Eigen::Vector3d(0, 0, -0.1)});
  EXPECT_GT(HeightWith(many), 0.3);
}

}  // namespace
}  // namespace tilemend
