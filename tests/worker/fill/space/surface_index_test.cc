#include "worker/fill/space/surface_index.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <type_traits>
#include <vector>

#include "tests/support/space_meshes.h"

namespace tilemend {
namespace {

using ::testing::IsEmpty;
using ::testing::UnorderedElementsAreArray;

static_assert(std::is_constructible_v<SurfaceIndex, const TriMesh&>);
static_assert(!std::is_constructible_v<SurfaceIndex, TriMesh>, "it would view what is gone");

std::vector<SpaceTriangle> Near(const SurfaceIndex& index, const Point3& lo, const Point3& hi) {
  std::vector<SpaceTriangle> found;
  index.AppendNear(lo, hi, found);
  return found;
}

std::vector<SpaceTriangle> LookedThrough(const TriMesh& mesh, const Point3& lo, const Point3& hi) {
  std::vector<SpaceTriangle> found;
  for (const Triangle& t : mesh.triangles) {
    const SpaceTriangle s = {mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]};
    Eigen::AlignedBox3d box(s[0]);
    box.extend(s[1]);
    box.extend(s[2]);
    if (box.intersects(Eigen::AlignedBox3d(lo, hi))) found.push_back(s);
  }
  return found;
}

TEST(SurfaceIndexTest, FindsWhatLookingThroughAllTrianglesFinds) {
  const TriMesh mesh = Turned(Shaken(BoxMesh(9), 0.2, 5), 4);
  const SurfaceIndex index(mesh);
  for (int k = 0; k < 40; ++k) {
    const Point3 lo(k % 7 - 5.0, k % 5 - 4.5, k % 3 * 3 - 4.0), hi = lo + Point3(k % 4, k % 6, k % 9);
    EXPECT_THAT(Near(index, lo, hi), UnorderedElementsAreArray(LookedThrough(mesh, lo, hi))) << k;
  }
  EXPECT_EQ(Near(index, Point3::Constant(-99), Point3::Constant(99)).size(), mesh.triangles.size());
  EXPECT_THAT(Near(index, Point3::Constant(90), Point3::Constant(99)), IsEmpty());
}

TEST(SurfaceIndexTest, TakesAWallAndNothing) {
  TriMesh wall = SquaresMesh(0, 6, 0, 4, [](int32_t, int32_t) { return true; });
  for (Point3& p : wall.points) p = {2, p.x(), p.y()};
  EXPECT_EQ(Near(SurfaceIndex(wall), {1, 0.1, 0.1}, {3, 0.4, 0.4}).size(), 2u);
  const TriMesh nothing;
  EXPECT_THAT(Near(SurfaceIndex(nothing), {0, 0, 0}, {9, 9, 9}), IsEmpty());
}

// Each is in many bins; beside them is a surface of small triangles.
TEST(SurfaceIndexTest, TakesLongThinTriangles) {
  TriMesh mesh = SquaresMesh(0, 20, 0, 20, [](int32_t, int32_t) { return true; });
  for (int32_t k = 0; k < 900; ++k) {
    const auto first = static_cast<int32_t>(mesh.points.size());
    const double y = 0.02 * k;
    mesh.points.insert(mesh.points.end(), {{-40, y, 1}, {60, y, 1}, {60, y + 0.01, 1}});
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  const SurfaceIndex index(mesh);
  for (int k = 0; k < 40; ++k) {
    const Point3 lo(11.0 * (k % 9) - 41, k % 19, k % 2), hi = lo + Point3(k % 5, 0.1 * k, 0.5);
    EXPECT_THAT(Near(index, lo, hi), UnorderedElementsAreArray(LookedThrough(mesh, lo, hi))) << k;
  }
}

}  // namespace
}  // namespace tilemend
