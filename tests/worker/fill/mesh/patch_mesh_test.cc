#include "worker/fill/mesh/patch_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <OpenMesh/Tools/Utils/MeshCheckerT.hh>
#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <utility>

namespace tilemend {

void PrintTo(const RefusedTriangle& r, std::ostream* out) { *out << r.triangle << "/" << static_cast<int>(r.reason); }
bool operator==(const RefusedTriangle& a, const RefusedTriangle& b) {
  return a.triangle == b.triangle && a.reason == b.reason;
}

namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;
using ::testing::UnorderedElementsAreArray;

using Triangles = std::vector<Triangle>;
using VertexHandle = PatchMesh::VertexHandle;
using FaceHandle = PatchMesh::FaceHandle;
using EdgeHandle = PatchMesh::EdgeHandle;

// Connectivity alone: all points at one place.
PatchMesh MeshOf(int vertices, const Triangles& triangles) {
  return {std::vector<Point3>(static_cast<size_t>(vertices), Point3::Zero()), triangles};
}

// What OpenMesh finds wrong with its own links; empty if nothing.
std::string FaultsOf(const PatchMesh& mesh) {
  std::ostringstream faults;
  const bool sound =
      OpenMesh::Utils::MeshCheckerT<PatchMesh>(mesh).check(OpenMesh::Utils::MeshCheckerT<PatchMesh>::CHECK_ALL, faults);
  return sound ? "" : faults.str() + "unsound";
}

// Squares of two triangles each.
Triangles Grid(int columns, int rows) {
  Triangles triangles;
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const int a = y * (columns + 1) + x, b = a + 1, c = a + columns + 1, d = c + 1;
      triangles.push_back({a, b, d});
      triangles.push_back({a, d, c});
    }
  }
  return triangles;
}

// Triangles around vertex 0, over vertices 1 to n.
Triangles ClosedFan(int n, int first = 1) {
  Triangles triangles;
  for (int k = 0; k < n; ++k) triangles.push_back({0, first + k, first + (k + 1) % n});
  return triangles;
}

std::vector<int> Neighbours(const PatchMesh& mesh, int v) {
  std::vector<int> result;
  for (const VertexHandle n : mesh.vv_range(VertexHandle(v))) result.push_back(n.idx());
  return result;
}

std::vector<int> FacesAround(const PatchMesh& mesh, int v) {
  std::vector<FaceHandle> faces;
  mesh.FacesAround(VertexHandle(v), faces);
  std::vector<int> result;
  for (const FaceHandle f : faces) result.push_back(f.idx());
  return result;
}

// Triangles that begin with their least corner, sorted.
Triangles Normalized(Triangles triangles) {
  for (Triangle& t : triangles) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

TEST(PatchMeshTest, GivesBackTheTrianglesThatWentIn) {
  const Triangles triangles = {{3, 1, 0}, {0, 2, 3}, {2, 4, 3}};
  const PatchMesh mesh = MeshOf(5, triangles);
  EXPECT_EQ(mesh.Triangles(), triangles);
  EXPECT_TRUE(mesh.IsManifold());
  EXPECT_EQ(FaultsOf(mesh), "");
}

TEST(PatchMeshTest, KeepsPositionsInDouble) {
  const Point3 far(4.5e6 + 1.0 / 1024, -1e7 / 3, 0.1);
  PatchMesh mesh(std::vector<Point3>{far, Point3::Zero()}, {});
  EXPECT_EQ(mesh.Position(VertexHandle(0)), far);
  mesh.SetPosition(VertexHandle(1), far / 7);
  EXPECT_EQ(mesh.Position(VertexHandle(1)), Point3(far / 7));
}

TEST(PatchMeshTest, IsEmptyWithoutTriangles) {
  const PatchMesh mesh;
  EXPECT_TRUE(mesh.IsManifold());
  EXPECT_THAT(mesh.Triangles(), IsEmpty());
  EXPECT_THAT(mesh.BoundaryEdges(), IsEmpty());
}

TEST(PatchMeshTest, HasNoFacesAroundAnIsolatedVertex) {
  const PatchMesh mesh = MeshOf(4, {{0, 1, 3}});
  EXPECT_TRUE(mesh.is_isolated(VertexHandle(2)));
  EXPECT_THAT(FacesAround(mesh, 2), IsEmpty());
  EXPECT_THAT(Neighbours(mesh, 2), IsEmpty());
}

TEST(PatchMeshTest, FindsEdgesInTheDirectionOfTheirTriangles) {
  const PatchMesh mesh = MeshOf(5, {{0, 1, 2}, {0, 2, 3}});
  EXPECT_EQ(mesh.Apex(mesh.HalfEdge(0, 2)), 3);
  EXPECT_EQ(mesh.Apex(mesh.HalfEdge(2, 0)), 1);
  EXPECT_TRUE(mesh.is_boundary(mesh.HalfEdge(1, 0)));
  EXPECT_FALSE(mesh.HalfEdge(1, 3).is_valid());
  EXPECT_FALSE(mesh.HalfEdge(1, 4).is_valid());
}

TEST(PatchMeshTest, RefusesTheThirdTriangleAtAnEdge) {
  const PatchMesh mesh = MeshOf(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {2, 1, 4}});
  EXPECT_THAT(mesh.refused(), ElementsAre(RefusedTriangle{2, TriangleRefusal::kEdge}));
  EXPECT_FALSE(mesh.IsManifold());
  EXPECT_EQ(mesh.Triangles(), (Triangles{{0, 1, 2}, {1, 0, 3}, {2, 1, 4}}));
  EXPECT_EQ(FaultsOf(mesh), "");
}

TEST(PatchMeshTest, NumbersFacesPastRefusedTriangles) {
  const PatchMesh mesh = MeshOf(5, {{0, 0, 1}, {0, 1, 2}, {0, 1, 3}, {1, 0, 3}, {2, 1, 4}});
  ASSERT_THAT(mesh.refused(),
              ElementsAre(RefusedTriangle{0, TriangleRefusal::kCorners}, RefusedTriangle{2, TriangleRefusal::kEdge}));
  EXPECT_EQ(mesh.TriangleOf(FaceHandle(0)), 1);
  EXPECT_EQ(mesh.TriangleOf(FaceHandle(1)), 3);
  EXPECT_EQ(mesh.TriangleOf(FaceHandle(2)), 4);
}

TEST(PatchMeshTest, RefusesATriangleThatIsThereTwice) {
  EXPECT_THAT(MeshOf(3, {{0, 1, 2}, {1, 2, 0}}).refused(), ElementsAre(RefusedTriangle{1, TriangleRefusal::kEdge}));
}

TEST(PatchMeshTest, TakesATriangleAndItsBackAsAClosedSurface) {
  const PatchMesh mesh = MeshOf(3, {{0, 1, 2}, {0, 2, 1}});
  EXPECT_TRUE(mesh.IsManifold());
  EXPECT_THAT(mesh.BoundaryEdges(), IsEmpty());
}

TEST(PatchMeshTest, RefusesATriangleThatTurnsOver) {
  EXPECT_THAT(MeshOf(4, {{0, 1, 2}, {1, 2, 3}}).refused(), ElementsAre(RefusedTriangle{1, TriangleRefusal::kEdge}));
}

TEST(PatchMeshTest, RefusesTheTriangleThatClosesAMoebiusStrip) {
  const Triangles strip = {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 0}, {4, 0, 1}};
  EXPECT_THAT(MeshOf(5, strip).refused(), ElementsAre(RefusedTriangle{4, TriangleRefusal::kEdge}));
}

TEST(PatchMeshTest, TakesPinchedVerticesWithOpenFansInAnyOrder) {
  Triangles triangles = {{0, 1, 2}, {0, 2, 3}, {0, 4, 5}, {0, 6, 7}, {0, 7, 8}, {0, 8, 9}};
  std::mt19937 random(5);
  for (int round = 0; round < 50; ++round) {
    std::shuffle(triangles.begin(), triangles.end(), random);
    const PatchMesh mesh = MeshOf(10, triangles);
    ASSERT_TRUE(mesh.IsManifold());
    ASSERT_EQ(FaultsOf(mesh), "");
    EXPECT_EQ(mesh.Triangles(), triangles);
    EXPECT_THAT(FacesAround(mesh, 0), ElementsAre(0, 1, 2, 3, 4, 5));
    EXPECT_THAT(Neighbours(mesh, 0), UnorderedElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 9));
  }
}

TEST(PatchMeshTest, TakesAManifoldInAnyOrder) {
  Triangles triangles = Grid(6, 6);
  std::mt19937 random(7);
  for (int round = 0; round < 50; ++round) {
    std::shuffle(triangles.begin(), triangles.end(), random);
    const PatchMesh mesh = MeshOf(49, triangles);
    ASSERT_TRUE(mesh.IsManifold());
    ASSERT_EQ(FaultsOf(mesh), "");
    EXPECT_EQ(mesh.Triangles(), triangles);
    EXPECT_EQ(mesh.BoundaryEdges().size(), 24U);
  }
}

TEST(PatchMeshTest, RefusesASecondFanAtASurroundedVertex) {
  Triangles triangles = ClosedFan(4);
  triangles.push_back({0, 5, 6});
  EXPECT_THAT(MeshOf(7, triangles).refused(), ElementsAre(RefusedTriangle{4, TriangleRefusal::kVertex}));
  std::rotate(triangles.begin(), triangles.end() - 1, triangles.end());  // now the other fan comes first
  const PatchMesh mesh = MeshOf(7, triangles);
  EXPECT_THAT(mesh.refused(), ElementsAre(RefusedTriangle{4, TriangleRefusal::kVertex}));
  EXPECT_EQ(FaultsOf(mesh), "");
}

TEST(PatchMeshTest, WalksAroundVerticesInsideAndOnTheBoundary) {
  const PatchMesh inside = MeshOf(6, ClosedFan(5));
  EXPECT_FALSE(inside.is_boundary(VertexHandle(0)));
  EXPECT_THAT(Neighbours(inside, 0), UnorderedElementsAre(1, 2, 3, 4, 5));
  EXPECT_THAT(FacesAround(inside, 0), ElementsAre(0, 1, 2, 3, 4));
  EXPECT_TRUE(inside.is_boundary(VertexHandle(3)));
  EXPECT_THAT(Neighbours(inside, 3), UnorderedElementsAre(0, 2, 4));
  EXPECT_THAT(FacesAround(inside, 3), ElementsAre(1, 2));
}

TEST(PatchMeshTest, ListsBoundaryEdgesInTheOrderOfTheTriangles) {
  const PatchMesh mesh = MeshOf(4, {{2, 0, 1}, {0, 2, 3}});
  EXPECT_THAT(mesh.BoundaryEdges(), ElementsAre(std::pair(0, 1), std::pair(1, 2), std::pair(2, 3), std::pair(3, 0)));
}

TEST(PatchMeshTest, TakesTheBandAfterThePatch) {
  PatchMesh mesh = MeshOf(6, {{0, 1, 2}});
  mesh.AddTriangles(Triangles{{1, 0, 3}, {0, 1, 4}, {2, 1, 5}});
  EXPECT_THAT(mesh.refused(), ElementsAre(RefusedTriangle{2, TriangleRefusal::kEdge}));
  EXPECT_EQ(mesh.Apex(mesh.HalfEdge(2, 1)), 5);
}

TEST(PatchMeshTest, IsLinkedTheSameAtOnceAndTriangleByTriangle) {
  Triangles triangles = Grid(7, 5);
  std::erase_if(triangles, [](const Triangle& t) { return t[0] == 9 || t[0] == 18 || t[1] == 29; });  // pinches some
  const PatchMesh at_once = MeshOf(48, triangles);
  PatchMesh one_by_one = MeshOf(48, {});
  for (const Triangle& t : triangles) one_by_one.AddTriangles(std::span(&t, 1));
  EXPECT_EQ(FaultsOf(at_once), "");
  EXPECT_EQ(at_once.n_edges(), one_by_one.n_edges());
  EXPECT_EQ(at_once.Triangles(), one_by_one.Triangles());
  EXPECT_EQ(at_once.BoundaryEdges(), one_by_one.BoundaryEdges());
  for (int v = 0; v < 48; ++v) {
    EXPECT_THAT(Neighbours(at_once, v), UnorderedElementsAreArray(Neighbours(one_by_one, v)));
    EXPECT_EQ(FacesAround(at_once, v), FacesAround(one_by_one, v));
  }
}

TEST(PatchMeshTest, PutsTheNewCornerWhereTheOldOneWas) {
  const std::vector<Triangle> near = {{2, 0, 1}, {0, 1, 2}, {1, 2, 0}}, far = {{3, 1, 0}, {1, 0, 3}, {0, 3, 1}};
  for (const Triangle& s : near) {
    for (const Triangle& t : far) {
      for (const bool swapped : {false, true}) {
        PatchMesh mesh = MeshOf(4, swapped ? Triangles{t, s} : Triangles{s, t});
        mesh.FlipEdge(mesh.edge_handle(mesh.HalfEdge(0, 1)));
        Triangle flipped_near = s, flipped_far = t;
        std::replace(flipped_near.begin(), flipped_near.end(), 1, 3);
        std::replace(flipped_far.begin(), flipped_far.end(), 0, 2);
        EXPECT_EQ(mesh.Corners(FaceHandle(swapped ? 1 : 0)), flipped_near);
        EXPECT_EQ(mesh.Corners(FaceHandle(swapped ? 0 : 1)), flipped_far);
        EXPECT_EQ(FaultsOf(mesh), "");
      }
    }
  }
}

TEST(PatchMeshTest, ComesBackAfterFourFlipsOfAnEdge) {
  const Triangles triangles = {{0, 1, 2}, {1, 0, 3}};
  PatchMesh mesh = MeshOf(4, triangles);
  for (int k = 0; k < 4; ++k) mesh.FlipEdge(mesh.edge_handle(mesh.HalfEdge(k % 2 == 0 ? 0 : 2, k % 2 == 0 ? 1 : 3)));
  EXPECT_EQ(Normalized(mesh.Triangles()), Normalized(triangles));
}

TEST(PatchMeshTest, DoesNotFlipAnEdgeOverAnotherOne) {
  const PatchMesh tetrahedron = MeshOf(4, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}});
  for (const EdgeHandle edge : tetrahedron.all_edges()) EXPECT_FALSE(tetrahedron.is_flip_ok(edge));
}

// The links of a mesh, told by its triangles alone: the apex beside each directed edge.
std::map<std::pair<int, int>, int> ApexesOf(const Triangles& triangles) {
  std::map<std::pair<int, int>, int> apexes;
  for (const Triangle& t : triangles) {
    for (int k = 0; k < 3; ++k) apexes[{t[k], t[(k + 1) % 3]}] = t[(k + 2) % 3];
  }
  return apexes;
}

void ExpectLinkedLike(const PatchMesh& mesh, const Triangles& triangles) {
  const auto apexes = ApexesOf(triangles);
  ASSERT_EQ(apexes.size(), 3 * triangles.size());
  for (const auto& [edge, apex] : apexes) {
    const auto half_edge = mesh.HalfEdge(edge.first, edge.second);
    ASSERT_TRUE(half_edge.is_valid());
    EXPECT_EQ(mesh.Apex(half_edge), apex);
    EXPECT_EQ(mesh.is_boundary(mesh.opposite_halfedge_handle(half_edge)), !apexes.contains({edge.second, edge.first}));
  }
  for (int v = 0; v < static_cast<int>(mesh.n_vertices()); ++v) {
    std::set<int> expected;
    for (const auto& [edge, apex] : apexes) {
      if (edge.first == v) expected.insert({edge.second, apex});
    }
    const std::vector<int> found = Neighbours(mesh, v);
    EXPECT_EQ(std::set<int>(found.begin(), found.end()), expected);
    EXPECT_EQ(found.size(), expected.size());
  }
}

TEST(PatchMeshTest, StaysLinkedThroughRandomFlips) {
  PatchMesh mesh = MeshOf(36, Grid(5, 5));
  std::mt19937 random(11);
  int flips = 0;
  for (int step = 0; step < 2000; ++step) {
    const EdgeHandle edge(static_cast<int>(random() % mesh.n_edges()));
    if (!mesh.is_flip_ok(edge)) continue;
    mesh.FlipEdge(edge);
    ++flips;
    if (step % 50 == 0) ExpectLinkedLike(mesh, mesh.Triangles());
  }
  EXPECT_GT(flips, 500);
  EXPECT_EQ(FaultsOf(mesh), "");
  const PatchMesh again = MeshOf(36, mesh.Triangles());  // flips have made no edge with three triangles
  EXPECT_TRUE(again.IsManifold());
  ExpectLinkedLike(again, mesh.Triangles());
}

TEST(PatchMeshTest, StaysLinkedThroughRandomSplits) {
  PatchMesh mesh = MeshOf(9, Grid(2, 2));
  std::mt19937 random(13);
  for (int step = 0; step < 60; ++step) {
    const VertexHandle middle = mesh.add_vertex(PatchMesh::Point(0, 0, 0));
    if (step % 3 == 0) {
      mesh.split(FaceHandle(static_cast<int>(random() % mesh.n_faces())), middle);
    } else {
      mesh.split(EdgeHandle(static_cast<int>(random() % mesh.n_edges())), middle);
    }
    ASSERT_EQ(FaultsOf(mesh), "");
    ExpectLinkedLike(mesh, mesh.Triangles());
  }
  EXPECT_TRUE(MeshOf(static_cast<int>(mesh.n_vertices()), mesh.Triangles()).IsManifold());
}

TEST(PatchMeshTest, ForgetsDeletedFacesOnCollection) {
  PatchMesh mesh = MeshOf(9, Grid(2, 2));
  mesh.delete_face(FaceHandle(0), false);
  mesh.garbage_collection();
  EXPECT_EQ(mesh.n_vertices(), 9U);
  Triangles expected = Grid(2, 2);
  expected.erase(expected.begin());
  EXPECT_EQ(Normalized(mesh.Triangles()), Normalized(expected));
  EXPECT_EQ(FaultsOf(mesh), "");
}

}  // namespace
}  // namespace tilemend
