#include "common/mesh/height_tallies.h"

#include <gtest/gtest.h>

#include <vector>

namespace tilemend {
namespace {

PlanePolygon Box(double x0, double x1) { return {{{{x0, 0}, {x1, 0}, {x1, 2}, {x0, 2}}}}; }

TEST(HeightTalliesTest, AreThoseOfEachPolygon) {
  TriMesh mesh;
  for (int32_t i = 0; i < 20; ++i) {
    const double x = i;
    mesh.points.insert(mesh.points.end(), {{x, 0, 1.0 + i}, {x + 1, 0, 1.0 + i}, {x, 1, 1.0 + i}});
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const std::vector<PlanePolygon> polygons = {Box(0, 20), Box(3, 5), {}, Box(4, 9), Box(50, 60), Box(3, 5)};
  const std::vector<HeightTally> tallies = TallyHeightsIn(mesh, polygons);
  ASSERT_EQ(tallies.size(), polygons.size());
  for (size_t i = 0; i < polygons.size(); ++i) {
    EXPECT_EQ(tallies[i].area_of_bin, TallyHeights(mesh, polygons[i]).area_of_bin) << i;
  }
  EXPECT_EQ(tallies[0].area_of_bin.size(), 20U);
  EXPECT_EQ(tallies[1].area_of_bin.size(), 2U);
  EXPECT_EQ(tallies[3].area_of_bin.size(), 5U);
  EXPECT_TRUE(tallies[4].area_of_bin.empty());
}

TEST(HeightTalliesTest, WithoutPolygonsThereIsNone) { EXPECT_TRUE(TallyHeightsIn(TriMesh(), {}).empty()); }

}  // namespace
}  // namespace tilemend
