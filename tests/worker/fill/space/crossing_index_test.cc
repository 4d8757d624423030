#include "worker/fill/space/crossing_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <span>
#include <vector>

#include "worker/fill/space/patch_crossings.h"

namespace tilemend {
namespace {

std::vector<SpaceTriangle> RandomTriangles(size_t count, double size, uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0, 1);
  const auto point = [&] { return Point3(share(random), share(random), share(random)); };
  std::vector<SpaceTriangle> triangles;
  while (triangles.size() < count) {
    const Point3 middle = point();
    triangles.push_back({middle, middle + size * point(), middle + size * point()});
  }
  return triangles;
}

TEST(CrossingIndexTest, AgreesWithComparingAllHoweverManyAreAdded) {
  const std::vector<SpaceTriangle> all = RandomTriangles(300, 0.2, 1), probes = RandomTriangles(40, 0.4, 2);
  CrossingIndex index(std::span<const SpaceTriangle>(all).first(50));
  for (size_t count = 50; count < all.size(); ++count) {
    index.Add(all[count]);
    const SpaceTriangle& probe = probes[count % probes.size()];
    const bool crossed = std::any_of(all.begin(), all.begin() + static_cast<ptrdiff_t>(count) + 1,
                                     [&](const SpaceTriangle& t) { return TrianglesCross(probe, t); });
    EXPECT_EQ(index.IsCrossedBy(probe), crossed) << count;
  }
  EXPECT_EQ(index.triangles().size(), all.size());
}

TEST(CrossingIndexTest, LeavesOutTrianglesWithoutArea) {
  const SpaceTriangle line = {Point3(0, 0, -1), Point3(0, 0, 1), Point3(0, 0, 3)};
  const CrossingIndex index(std::span<const SpaceTriangle>(&line, 1));
  EXPECT_FALSE(index.IsCrossedBy({Point3(-1, -1, 0), Point3(2, -1, 0), Point3(0, 2, 0)}));
}

}  // namespace
}  // namespace tilemend
