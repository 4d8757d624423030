#include "worker/check/mesh_defects.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "tests/support/round_meshes.h"
#include "tests/support/space_meshes.h"

namespace tilemend {
namespace {

using ::testing::IsEmpty;
using ::testing::Pair;
using ::testing::UnorderedElementsAre;

// The kinds that were found, with their numbers.
std::map<Defect, int64_t> Found(const TriMesh& mesh, const CheckLimits& limits = {}) {
  std::map<Defect, int64_t> counts;
  for (const auto& [defect, finding] : FindDefects(mesh, limits)) {
    if (finding.count > 0) counts[defect] = finding.count;
  }
  return counts;
}

int32_t VertexAt(const TriMesh& mesh, const Point3& p) {
  return static_cast<int32_t>(std::ranges::find(mesh.points, p) - mesh.points.begin());
}

TEST(FindDefectsTest, FindsNothingWrongWithSoundBodiesAndSheets) {
  EXPECT_THAT(Found(BoxMesh(4)), IsEmpty());
  EXPECT_THAT(Found(Unwelded(BoxMesh(4))), IsEmpty()) << "doubled vertices are one";
  EXPECT_THAT(Found(SphereBelt(0, 90)), IsEmpty());
  EXPECT_THAT(Found(SquaresMesh(0, 5, 0, 5, [](int32_t i, int32_t j) { return i != 2 || j != 2; })), IsEmpty());
}

TEST(FindDefectsTest, DoesNotDependOnSizeAndDirection) {
  TriMesh mesh = BoxMesh(4);
  AddMesh(Tetrahedron(Point3(4.1, 2.13, 2.27), 1), mesh);
  const auto plain = Found(mesh);
  EXPECT_GT(plain.at(Defect::kSelfIntersection), 0);
  for (const double factor : {1e-6, 1e3}) {
    TriMesh other = Turned(mesh, 5);
    for (Point3& p : other.points) p *= factor;
    EXPECT_EQ(Found(other), plain);
  }
}

TEST(FindDefectsTest, FindsAFin) {
  TriMesh mesh = BoxMesh(5);
  mesh.triangles.push_back(
      {VertexAt(mesh, {5, 2, 2}), VertexAt(mesh, {5, 3, 2}), static_cast<int32_t>(mesh.points.size())});
  mesh.points.emplace_back(7, 2.5, 2);
  EXPECT_THAT(Found(mesh), UnorderedElementsAre(Pair(Defect::kNonManifoldEdge, 1)));
}

TEST(FindDefectsTest, FindsWhereBodiesTouchAtAVertex) {
  TriMesh mesh = BoxMesh(2), other = BoxMesh(2);
  for (Point3& p : other.points) p += Point3(2, 2, 2);
  AddMesh(other, mesh);
  EXPECT_THAT(Found(mesh), UnorderedElementsAre(Pair(Defect::kNonManifoldVertex, 1)));
}

TEST(FindDefectsTest, FindsTurnedDuplicateAndFlatTriangles) {
  TriMesh mesh = SquaresMesh(0, 5, 0, 5, [](int32_t, int32_t) { return true; });
  std::swap(mesh.triangles[24][0], mesh.triangles[24][1]);
  mesh.triangles.push_back(mesh.triangles[3]);
  mesh.triangles.push_back({VertexAt(mesh, {0, 0, 0}), VertexAt(mesh, {1, 0, 0}), VertexAt(mesh, {2, 0, 0})});
  EXPECT_THAT(Found(mesh), UnorderedElementsAre(Pair(Defect::kTurnedEdge, 3), Pair(Defect::kDuplicateTriangle, 1),
                                                Pair(Defect::kFlatTriangle, 1)));
}

TEST(FindDefectsTest, FindsCreasesAboveTheLimit) {
  const TriMesh roof = Moved(SquaresMesh(-3, 3, 0, 4, [](int32_t, int32_t) { return true; }),
                             [](const Point3& p) { return Point3(p.x(), p.y(), -3 * std::abs(p.x())); });
  EXPECT_THAT(Found(roof), UnorderedElementsAre(Pair(Defect::kCreasedEdge, 4))) << "turns by 143 degrees";
  CheckLimits limits;
  limits.crease_degrees = 150;
  EXPECT_THAT(Found(roof, limits), IsEmpty());
}

TEST(FindDefectsTest, FindsSpikesAndSmallComponents) {
  TriMesh mesh = SquaresMesh(0, 30, 0, 30, [](int32_t, int32_t) { return true; });
  mesh.points[VertexAt(mesh, {15, 15, 0})].z() = 12;
  CheckLimits limits;
  limits.crease_degrees = 179;
  EXPECT_THAT(Found(mesh, limits), UnorderedElementsAre(Pair(Defect::kSpike, 1)));
  TriMesh two = BoxMesh(20);
  AddMesh(Tetrahedron(Point3(40, 0, 0), 1), two);
  EXPECT_THAT(Found(two), UnorderedElementsAre(Pair(Defect::kSmallComponent, 1)));
}

TEST(HasAreaTest, IsNotOfNeedlesAlone) {
  TriMesh mesh;
  mesh.points = {Point3(0, 0, 0), Point3(1, 0, 0), Point3(2, 0, 0), Point3(0, 1e-9, 0)};
  mesh.triangles = {{0, 1, 2}};
  EXPECT_FALSE(HasArea(mesh));
  mesh.triangles.push_back({0, 1, 3});
  EXPECT_TRUE(HasArea(mesh));
}

}  // namespace
}  // namespace tilemend
