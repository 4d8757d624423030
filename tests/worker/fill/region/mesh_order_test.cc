#include "worker/fill/region/mesh_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <tuple>
#include <vector>

#include "tests/worker/fill/region/scattered_region.h"

namespace tilemend::internal {
namespace {

using testing::CheckTopology;
using testing::Scattered;
using testing::ScatteredRegion;

constexpr int kSide = 30;

ScatteredRegion Sorted(ScatteredRegion region) {
  SortMesh(region.mesh(), region.first, region.size);
  return region;
}

// Each with a size of its own.
ScatteredRegion Numbered() {
  ScatteredRegion region = Scattered(kSide, 1, 2);
  for (size_t v = 0; v < region.size.size(); ++v) region.size[v] = static_cast<double>(v);
  return region;
}

using SizedPoint = std::tuple<int32_t, int32_t, double>;

std::vector<SizedPoint> SizedPoints(const ScatteredRegion& region) {
  std::vector<SizedPoint> points;
  for (size_t v = 0; v < region.size.size(); ++v) {
    points.emplace_back(region.mesh().points[v].x, region.mesh().points[v].y, region.size[v]);
  }
  return points;
}

// The corners of all triangles by where they lie, each from its first corner on, in an order of their own.
std::vector<std::array<int32_t, 6>> Places(const DelaunayMesh& mesh) {
  std::vector<std::array<int32_t, 6>> places;
  for (const MeshTriangle& t : mesh.triangles) {
    const Point32 a = mesh.points[t.corner[0]], b = mesh.points[t.corner[1]], c = mesh.points[t.corner[2]];
    places.push_back({a.x, a.y, b.x, b.y, c.x, c.y});
  }
  std::sort(places.begin(), places.end());
  return places;
}

double MeanStep(const ScatteredRegion& region) {
  double sum = 0, count = 0;
  for (const MeshTriangle& t : region.mesh().triangles) {
    for (int k = 0; k < 3; ++k) {
      const int32_t a = t.corner[k], b = t.corner[Next(k)];
      if (std::min(a, b) < static_cast<int32_t>(region.first)) continue;
      sum += std::abs(a - b);
      count += 1;
    }
  }
  return sum / count;
}

TEST(MeshOrderTest, KeepsEachPointWithItsSize) {
  std::vector<SizedPoint> before = SizedPoints(Numbered()), after = SizedPoints(Sorted(Numbered()));
  EXPECT_NE(before, after);
  std::sort(before.begin(), before.end());
  std::sort(after.begin(), after.end());
  EXPECT_EQ(before, after);
}

TEST(MeshOrderTest, LeavesTheFirstPointsAtTheirPlaces) {
  const ScatteredRegion before = Numbered(), after = Sorted(before);
  for (size_t v = 0; v < before.first; ++v) {
    EXPECT_EQ(after.mesh().points[v], before.mesh().points[v]);
    EXPECT_EQ(after.size[v], before.size[v]);
  }
}

TEST(MeshOrderTest, KeepsEachTriangleAndWhatLiesAcrossItsEdges) {
  const ScatteredRegion before = Numbered(), after = Sorted(before);
  EXPECT_EQ(Places(after.mesh()), Places(before.mesh()));
  CheckTopology(after.Points(), after.segments, ExportRegion(after.region, after.segments.size()));
  for (int32_t t = 0; t < static_cast<int32_t>(after.mesh().triangles.size()); ++t) {
    for (int32_t e = 4 * t; e < 4 * t + 3; ++e) {
      if (const int32_t twin = after.mesh().Twin(e); twin >= 0) {
        EXPECT_EQ(after.mesh().Twin(twin), e);
      }
    }
  }
}

TEST(MeshOrderTest, NeighboursComeNearEachOther) {
  const ScatteredRegion before = Numbered(), after = Sorted(before);
  EXPECT_LT(MeanStep(after), MeanStep(before) / 4);
}

TEST(MeshOrderTest, TrianglesComeByTheirLowestCorner) {
  const ScatteredRegion after = Sorted(Numbered());
  EXPECT_TRUE(std::is_sorted(after.mesh().triangles.begin(), after.mesh().triangles.end(),
                             [](const MeshTriangle& a, const MeshTriangle& b) {
                               return std::ranges::min(a.corner) < std::ranges::min(b.corner);
                             }));
}

TEST(MeshOrderTest, TheOrderOfThePointsBeforeDoesNotMatter) {
  EXPECT_EQ(Sorted(Scattered(kSide, 1, 2)).mesh().points, Sorted(Scattered(kSide, 1, 3)).mesh().points);
}

TEST(MeshOrderTest, ASortedMeshStaysAsItIs) {
  const ScatteredRegion once = Sorted(Numbered()), twice = Sorted(once);
  EXPECT_EQ(SizedPoints(twice), SizedPoints(once));
  for (size_t t = 0; t < once.mesh().triangles.size(); ++t) {
    EXPECT_EQ(twice.mesh().triangles[t].corner, once.mesh().triangles[t].corner);
    EXPECT_EQ(twice.mesh().triangles[t].twin, once.mesh().triangles[t].twin);
  }
}

}  // namespace
}  // namespace tilemend::internal
