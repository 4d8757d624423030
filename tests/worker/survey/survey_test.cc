#include "worker/survey/survey.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "common/mesh/triangle_copies.h"
#include "tests/support/mesh_builders.h"

namespace tilemend {
namespace {

using ::testing::Each;
using ::testing::Ge;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;
using Xyz = std::array<double, 3>;
using DirectedEdge = std::pair<Xyz, Xyz>;

Xyz Key(const Point3& p) { return {p.x() + 0.0, p.y() + 0.0, p.z() + 0.0}; }

std::multiset<DirectedEdge> EdgesOf(const SurveyRecord& record) {
  std::multiset<DirectedEdge> edges;
  for (const BoundaryEdge& e : record.edges) {
    edges.emplace(Key(record.vertices[e.from].position), Key(record.vertices[e.to].position));
  }
  return edges;
}

// The definition itself: of the triangles with three positions, the edges that one of them has.
std::multiset<DirectedEdge> BoundaryByDefinition(const TriMesh& mesh) {
  std::map<std::set<Xyz>, std::vector<DirectedEdge>> uses;
  for (const Triangle& t : mesh.triangles) {
    const std::set<Xyz> corners = {Key(mesh.points[t[0]]), Key(mesh.points[t[1]]), Key(mesh.points[t[2]])};
    if (corners.size() < 3) continue;
    for (int k = 0; k < 3; ++k) {
      const Xyz a = Key(mesh.points[t[k]]), b = Key(mesh.points[t[(k + 1) % 3]]);
      uses[{a, b}].emplace_back(a, b);
    }
  }
  std::multiset<DirectedEdge> edges;
  for (const auto& [edge, list] : uses) {
    if (list.size() == 1) edges.insert(list[0]);
  }
  return edges;
}

// How many loops the edges form; -1 if some vertex has not one edge in and one out.
int CountLoops(const SurveyRecord& record) {
  std::map<int32_t, int32_t> next;
  std::set<int32_t> reached;
  for (const BoundaryEdge& e : record.edges) {
    if (!next.emplace(e.from, e.to).second || !reached.insert(e.to).second) return -1;
  }
  int loops = 0;
  while (!next.empty()) {
    ++loops;
    for (auto at = next.begin(); at != next.end();) {
      const int32_t to = at->second;
      next.erase(at);
      at = next.find(to);
    }
  }
  return loops;
}

TEST(SurveyTileTest, FindsTheOneLoopOfADisc) {
  const SurveyRecord record = SurveyTile(DiscMesh(3, 12), true);
  EXPECT_EQ(record.edges.size(), 12u);
  EXPECT_EQ(CountLoops(record), 1);
}

TEST(SurveyTileTest, DirectsBoundaryEdgesLikeTheirTriangles) {
  const SurveyRecord record = SurveyTile(DiscMesh(3, 12), true);
  for (const BoundaryEdge& e : record.edges) {
    const Point3 a = record.vertices[e.from].position, b = record.vertices[e.to].position;
    EXPECT_GT(a.x() * b.y() - a.y() * b.x(), 0) << "counter-clockwise about the disc's middle: surface on the left";
  }
}

TEST(SurveyTileTest, FindsTheLoopsOfOutlineHoleAndIsland) {
  const SurveyRecord record = SurveyTile(PictureMesh({"#######",  //
                                                      "#.....#",  //
                                                      "#.....#",  //
                                                      "#..#..#",  //
                                                      "#.....#",  //
                                                      "#######"}),
                                         true);
  EXPECT_EQ(CountLoops(record), 3);
  EXPECT_EQ(record.edges.size(), 26u + 18u + 4u);
}

TEST(SurveyTileTest, TakesNoTextureSeamForABoundary) {
  const TriMesh whole = DiscMesh(3, 12);
  const SurveyRecord record = SurveyTile(Unwelded(whole), true);
  EXPECT_EQ(EdgesOf(record), EdgesOf(SurveyTile(whole, true)));
  EXPECT_GT(record.doubled_vertices, 0);
}

TEST(SurveyTileTest, NamesTheLowestVertexOfADoubledPosition) {
  const TriMesh mesh = Unwelded(DiscMesh(2, 6));
  const SurveyRecord record = SurveyTile(mesh, true);
  for (const BoundaryVertex& v : record.vertices) {
    const auto lowest = std::find(mesh.points.begin(), mesh.points.end(), v.position);
    EXPECT_EQ(v.index, lowest - mesh.points.begin());
  }
}

TEST(SurveyTileTest, CountsAnEdgeWithThreeTrianglesAndLeavesItOut) {
  TriMesh fins;
  fins.points = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}};
  fins.triangles = {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}};
  const SurveyRecord record = SurveyTile(fins, true);
  EXPECT_EQ(record.nonmanifold_edges, 1);
  EXPECT_EQ(record.edges.size(), 6u);
  EXPECT_FALSE(EdgesOf(record).contains({Key(fins.points[0]), Key(fins.points[1])}));
  EXPECT_FALSE(EdgesOf(record).contains({Key(fins.points[1]), Key(fins.points[0])}));
}

TEST(SurveyTileTest, LooksThroughDegenerateTriangles) {
  TriMesh mesh = DiscMesh(1, 6);
  const auto expected = EdgesOf(SurveyTile(mesh, true));
  mesh.points.push_back(mesh.points[2]);
  mesh.triangles.push_back({1, 2, static_cast<int32_t>(mesh.points.size()) - 1});
  mesh.triangles.push_back({3, 3, 4});
  const SurveyRecord record = SurveyTile(mesh, true);
  EXPECT_EQ(EdgesOf(record), expected);
  EXPECT_EQ(record.degenerate_triangles, 2);
}

TEST(SurveyTileTest, TakesNoEdgeBetweenTrianglesThatFaceOppositeWaysForABoundary) {
  TriMesh mesh = DiscMesh(2, 8);
  const size_t before = SurveyTile(mesh, true).edges.size();
  std::swap(mesh.triangles[0][1], mesh.triangles[0][2]);
  EXPECT_EQ(SurveyTile(mesh, true).edges.size(), before);
}

TEST(SurveyTileTest, HasNoBoundaryOnAClosedSurface) {
  TriMesh tetrahedron;
  tetrahedron.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  tetrahedron.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  const SurveyRecord record = SurveyTile(tetrahedron, true);
  EXPECT_THAT(record.edges, IsEmpty());
  EXPECT_THAT(record.vertices, IsEmpty());
  EXPECT_THAT(record.band.triangles, IsEmpty());
}

TEST(SurveyTileTest, KeepsOneVertexWhereTwoHolesPinch) {
  const SurveyRecord record = SurveyTile(PictureMesh({"####",  //
                                                      "#.##",  //
                                                      "##.#",  //
                                                      "####"}),
                                         true);
  EXPECT_EQ(record.edges.size(), 16u + 8u);
  EXPECT_EQ(record.vertices.size(), 16u + 7u) << "the pinch is one vertex of four edges";
}

TEST(SurveyTileTest, TellsWhichEdgeGoesOnAroundTheSameFanWhereSeveralDo) {
  const SurveyRecord record = SurveyTile(PictureMesh({"####", "#.##", "##.#", "####"}), false);
  ASSERT_EQ(record.edge_after.size(), record.edges.size());
  int told = 0;
  for (size_t e = 0; e < record.edges.size(); ++e) {
    const int32_t after = record.edge_after[e];
    const Point3& end = record.vertices[record.edges[e].to].position;
    EXPECT_EQ(after >= 0, end == Point3(2, 2, 0)) << end.transpose();
    if (after < 0) continue;
    ++told;
    EXPECT_EQ(record.edges[after].from, record.edges[e].to);
    // A fan is a quarter here: from the edge that leaves, counter-clockwise to the one that arrives.
    const Point3 &from = record.vertices[record.edges[e].from].position,
                 &to = record.vertices[record.edges[after].to].position;
    EXPECT_GT((to - end).cross(from - end).z(), 0);
  }
  EXPECT_EQ(told, 2);
}

// A mesh followed by all its triangles again, with vertices of their own or not, as copies or as backs.
TriMesh Twice(const TriMesh& once, bool own_vertices, bool back) {
  TriMesh twice = once;
  const auto first = static_cast<int32_t>(own_vertices ? once.points.size() : 0);
  if (own_vertices) twice.points.insert(twice.points.end(), once.points.begin(), once.points.end());
  for (Triangle t : once.triangles) {
    if (back) std::swap(t[0], t[1]);
    twice.triangles.push_back({t[1] + first, t[2] + first, t[0] + first});
  }
  return twice;
}

TEST(SurveyTileTest, TakesAMeshThatIsThereTwiceForOne) {
  const TriMesh once = PictureMesh({"####", "#..#", "####"});
  const SurveyRecord expected = SurveyTile(once, false);
  for (const bool own_vertices : {false, true}) {
    const TriMesh twice = Twice(once, own_vertices, false);
    const SurveyRecord record = SurveyTile(twice, false);
    EXPECT_EQ(EdgesOf(record), EdgesOf(expected));
    EXPECT_EQ(record.band.triangles, expected.band.triangles);
    EXPECT_EQ(record.piece_areas, expected.piece_areas);
    EXPECT_EQ(record.copied_triangles, std::ssize(once.triangles));
    EXPECT_EQ(record.triangle_count, std::ssize(twice.triangles));
    EXPECT_EQ(record.repeated_edges, 0);
    const std::multiset<DirectedEdge> of_tile = EdgesOf(SurveyTile(twice, false, PieceAreas::kNo));
    EXPECT_EQ(of_tile, own_vertices ? std::multiset<DirectedEdge>() : EdgesOf(expected))
        << "pieces of tiles are surveyed as they are";
  }
}

TEST(SurveyTileTest, CopiesOfSingleTrianglesAtTheBoundaryDoNotCount) {
  const TriMesh once = PictureMesh({"####", "#..#", "####"});
  for (const PieceAreas areas : {PieceAreas::kYes, PieceAreas::kNo}) {
    const SurveyRecord expected = SurveyTile(once, false, areas);
    TriMesh mesh = once;
    for (const size_t t : {0, 3, 3}) mesh.triangles.push_back(once.triangles[t]);
    const SurveyRecord record = SurveyTile(mesh, false, areas);
    EXPECT_EQ(EdgesOf(record), EdgesOf(expected));
    EXPECT_EQ(record.band.triangles, expected.band.triangles);
    EXPECT_EQ(record.copied_triangles, 3);
    EXPECT_EQ(record.triangle_count, std::ssize(mesh.triangles));
  }
}

TEST(SurveyTileTest, CountsTheEdgesThatBacksCover) {
  const TriMesh once = PictureMesh({"####", "#..#", "####"});
  const auto boundary = std::ssize(SurveyTile(once, false).edges);
  EXPECT_EQ(SurveyTile(once, false).repeated_edges, 0);
  for (const bool own_vertices : {false, true}) {
    const SurveyRecord record = SurveyTile(Twice(once, own_vertices, true), false);
    EXPECT_THAT(record.edges, IsEmpty());
    EXPECT_EQ(record.repeated_edges, boundary) << own_vertices;
  }
}

TEST(SurveyTileTest, ParsPiecesThatMeetInAVertex) {
  TriMesh mesh = SquaresMesh(0, 4, 0, 4, [](int32_t x, int32_t y) { return (x < 2) == (y < 2); });
  const SurveyRecord record = SurveyTile(mesh, true);
  const auto is_south_west = [&](const BoundaryEdge& e) {
    const Point3 sum = record.vertices[e.from].position + record.vertices[e.to].position;
    return sum.x() + sum.y() < 8;
  };
  for (const BoundaryEdge& e : record.edges) {
    EXPECT_EQ(e.piece == record.edges[0].piece, is_south_west(e) == is_south_west(record.edges[0]));
  }
}

TEST(SurveyTileTest, KeepsOnePieceAroundAHole) {
  const SurveyRecord record =
      SurveyTile(SquaresMesh(0, 5, 0, 5, [](int32_t x, int32_t y) { return x != 2 || y != 2; }), true);
  for (const BoundaryEdge& e : record.edges) EXPECT_EQ(e.piece, 0);
}

TEST(SurveyTileTest, KeepsTwoRingsOfTrianglesAsBand) {
  const int32_t sectors = 12;
  const TriMesh disc = DiscMesh(5, sectors);
  const SurveyRecord record = SurveyTile(disc, true);
  std::vector<double> radii;
  for (const Triangle& t : record.band.triangles) {
    double least = 10;
    for (const int32_t v : t) least = std::min(least, record.band.points[v].norm());
    radii.push_back(least);
  }
  EXPECT_EQ(record.band.triangles.size(), 4u * sectors) << "two rings of two triangles a sector";
  EXPECT_THAT(radii, Each(Ge(3 - 1e-9)));
}

TEST(SurveyTileTest, PutsTheBoundaryVerticesFirstIntoTheBand) {
  const SurveyRecord record = SurveyTile(Unwelded(DiscMesh(4, 9)), true);
  ASSERT_GE(record.band.points.size(), record.vertices.size());
  for (size_t i = 0; i < record.vertices.size(); ++i) {
    EXPECT_EQ(record.band.points[i], record.vertices[i].position);
  }
}

TEST(SurveyTileTest, MeansCentroidHeightsAndNormalsOfTheTrianglesAtAVertex) {
  TriMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 3}, {1, 1, 6}, {0, 1, 9}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  const SurveyRecord record = SurveyTile(mesh, true);
  for (const BoundaryVertex& v : record.vertices) {
    const double expected = v.index == 1 ? 3 : v.index == 3 ? 5 : 4;
    EXPECT_DOUBLE_EQ(v.centroid_height, expected) << "vertex " << v.index;
    EXPECT_NEAR(v.normal.norm(), 1, 1e-12);
    EXPECT_GT(v.normal.z(), 0);
  }
}

TEST(SurveyTileTest, TellsCountsAndBoundsOfTheTile) {
  const SurveyRecord record = SurveyTile(PictureMesh({"##.", "###"}, [](double x, double y) { return x - y; }), false);
  EXPECT_EQ(record.triangle_count, 10);
  EXPECT_EQ(record.vertex_count, 11);
  EXPECT_FALSE(record.float32);
  EXPECT_EQ(record.lo, Point3(0, 0, -2));
  EXPECT_EQ(record.hi, Point3(3, 2, 3));
}

TEST(SurveyTileTest, TellsAreasOfPiecesWhereTheyAreWanted) {
  const TriMesh mesh = PictureMesh({"#.##", "#..."});
  const SurveyRecord with = SurveyTile(mesh, true), without = SurveyTile(mesh, true, PieceAreas::kNo);
  EXPECT_THAT(with.piece_areas, UnorderedElementsAre(2, 2));
  EXPECT_THAT(without.piece_areas, IsEmpty());
  ASSERT_EQ(without.edges.size(), with.edges.size());
  for (size_t e = 0; e < with.edges.size(); ++e) EXPECT_EQ(without.edges[e].piece, with.edges[e].piece);
}

TEST(SurveyTileTest, TellsOfAnEmptyMeshThatItHasNoBounds) {
  const SurveyRecord record = SurveyTile(TriMesh{}, true);
  EXPECT_THAT(record.edges, IsEmpty());
  EXPECT_GT(record.lo.x(), record.hi.x());
}

// A soup of few positions, so that every kind of edge turns up: none, one, two either way round, three and more.
TriMesh RandomSoup(uint32_t seed) {
  std::mt19937 random(seed);
  const auto below = [&](int32_t n) { return static_cast<int32_t>(random() % static_cast<uint32_t>(n)); };
  TriMesh soup;
  const int32_t points = 4 + below(12), triangles = 1 + below(30);
  for (int32_t i = 0; i < points; ++i) soup.points.emplace_back(below(3), below(3), below(2));
  for (int32_t i = 0; i < triangles; ++i) soup.triangles.push_back({below(points), below(points), below(points)});
  soup.triangles = WithoutCopies(soup).value_or(soup.triangles);
  return soup;
}

TEST(SurveyTileTest, AgreesWithTheDefinitionOnRandomSoups) {
  for (uint32_t seed = 0; seed < 200; ++seed) {
    const TriMesh soup = RandomSoup(seed);
    const auto expected = BoundaryByDefinition(soup);
    std::multiset<DirectedEdge> found = EdgesOf(SurveyTile(soup, true, PieceAreas::kNo)), doubled;
    std::ranges::set_difference(found, expected, std::inserter(doubled, doubled.end()));
    EXPECT_EQ(found.size(), expected.size() + doubled.size()) << "seed " << seed;
    for (const DirectedEdge& e : doubled) {
      EXPECT_EQ(found.count(e), 2u) << "where two triangles lie on each other, seed " << seed;
      EXPECT_FALSE(found.contains({e.second, e.first})) << "seed " << seed;
    }
    const auto turned = EdgesOf(SurveyTile(soup, true));
    EXPECT_EQ(turned.size(), expected.size()) << "seed " << seed;
    for (const auto& [from, to] : turned) {
      EXPECT_TRUE(expected.contains({from, to}) || expected.contains({to, from}))
          << "faces may be turned, seed " << seed;
    }
  }
}

}  // namespace
}  // namespace tilemend
