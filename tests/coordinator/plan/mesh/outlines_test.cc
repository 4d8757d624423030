#include "coordinator/plan/mesh/outlines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/mesh_reading.h"
#include "tests/support/round_meshes.h"
#include "tests/support/space_meshes.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;

TEST(FindOutlinesTest, MeasuresHowOpenAPieceIs) {
  EXPECT_THAT(MeshReading(SquaresMesh(0, 3, 0, 3, Everywhere)).outlines, ElementsAre(true));
  EXPECT_THAT(MeshReading(Tube(16, 4, 1, 0, 2)).outlines, ElementsAre(false, false));
  EXPECT_THAT(MeshReading(SphereBelt(0, 60)).outlines, ElementsAre(true));
  EXPECT_THAT(MeshReading(SphereBelt(0, 90)).outlines, ElementsAre(false));
  EXPECT_THAT(MeshReading(SphereBelt(0, 120)).outlines, ElementsAre(false));
}

TEST(FindOutlinesTest, AddsLobesThatTouchTheOutline) {
  const auto keep = [](int32_t i, int32_t j) { return (i < 4) == (j < 4); };  // two squares that touch at a corner
  const MeshReading read(SquaresMesh(0, 8, 0, 8, keep));
  for (const bool outline : read.outlines) EXPECT_TRUE(outline);
}

// Two sheets share every second vertex of a line; the other ones of the upper sheet lie a little below it.
TEST(FindOutlinesTest, TakesSlitsWhoseSidesOverlapForHoles) {
  for (const double overlap : {1e-15, 0.01}) {
    TriMesh mesh = SquaresMesh(0, 8, 0, 2, Everywhere);
    const TriMesh upper = SquaresMesh(0, 4, 2, 4, Everywhere);
    const auto first = static_cast<int32_t>(mesh.points.size());
    for (Point3& p : mesh.points) {
      if (p.y() == 2 && static_cast<int>(p.x()) % 2 == 1) p.y() += overlap;
    }
    for (const Point3& p : upper.points) mesh.points.emplace_back(2 * p.x(), p.y(), 0);
    for (const Triangle& t : upper.triangles) mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    const MeshReading read(mesh);
    EXPECT_EQ(std::ranges::count(read.outlines, true), 1);
    EXPECT_EQ(read.outlines.size(), 5);
  }
}

}  // namespace
}  // namespace tilemend
