#include "worker/fill/front/svm_patch.h"

#include <gtest/gtest.h>

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
  EXPECT_GT(HeightWith(SamplesOf(-0.1)), 0.5);
  EXPECT_LT(HeightWith(SamplesOf(0.1)), -0.5);
}

TEST_F(SvmPatchTest, ManySamplesAreThinned) {
  std::vector<LaplacianSample> many;
  for (int i = 0; i < 4001; ++i) many.push_back({Point3(0.001 * i, 0, 0), Eigen::Vector3d(0, 0, -0.1)});
  EXPECT_GT(HeightWith(many), 0.5);
}

}  // namespace
}  // namespace tilemend
