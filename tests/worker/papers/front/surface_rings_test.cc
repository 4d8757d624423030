#include "worker/papers/front/surface_rings.h"

#include <gtest/gtest.h>

#include <vector>

namespace tilemend {
namespace {

// Squares of a sheet from (0, 0) to (8, 8), two triangles each, without the one in the middle of the lower edge.
std::vector<SpaceTriangle> Sheet(double bend) {
  std::vector<SpaceTriangle> surface;
  const auto at = [&](int x, int y) { return Point3(x, y, bend * (x * x + y * y)); };
  for (int x = 0; x < 8; ++x) {
    for (int y = 0; y < 8; ++y) {
      if (x == 3 && y == 3) continue;
      surface.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
      surface.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  }
  return surface;
}

std::vector<Point3> Rim(double bend) {
  std::vector<Point3> rim;
  for (const auto& [x, y] : {std::pair{3, 3}, {4, 3}, {4, 4}, {3, 4}}) rim.emplace_back(x, y, bend * (x * x + y * y));
  return rim;
}

TEST(SurfaceRingsTest, GivesTheVerticesRingByRing) {
  EXPECT_EQ(SampleRings(Rim(0), Sheet(0), 0).size(), 0u);
  const auto first = SampleRings(Rim(0), Sheet(0), 1);
  for (const LaplacianSample& s : first) {
    EXPECT_TRUE(s.at.x() >= 2 && s.at.x() <= 5 && s.at.y() >= 2 && s.at.y() <= 5);
  }
  EXPECT_GE(first.size(), 9u);
  EXPECT_GT(SampleRings(Rim(0), Sheet(0), 2).size(), first.size());
}

TEST(SurfaceRingsTest, LeavesOutWhatIsNotSurrounded) {
  for (const LaplacianSample& s : SampleRings(Rim(0), Sheet(0), 20)) {
    EXPECT_TRUE(s.at.x() > 0 && s.at.x() < 8 && s.at.y() > 0 && s.at.y() < 8);
  }
  EXPECT_EQ(SampleRings(Rim(0), Sheet(0), 20).size(), 7u * 7 - 4);
}

TEST(SurfaceRingsTest, LaplaciansAreThoseOfTheSurface) {
  for (const LaplacianSample& s : SampleRings(Rim(0), Sheet(0), 3)) EXPECT_NEAR(s.laplacian.norm(), 0, 1e-12);
  for (const LaplacianSample& s : SampleRings(Rim(0.01), Sheet(0.01), 1)) EXPECT_GT(s.laplacian.z(), 0.005);
}

}  // namespace
}  // namespace tilemend
