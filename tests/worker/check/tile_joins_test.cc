#include "worker/check/tile_joins.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/mesh_builders.h"

namespace tilemend {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

OpenEdge Edge(int32_t before, int32_t after, double x = 0) { return {{x, 0, 0}, {x, 1, 0}, before, after, after > 0}; }

TEST(JoinedEdgesTest, AnEdgeThatTwoTilesHaveIsClosed) {
  JoinedEdges edges;
  edges.Add(0, 0, {Edge(0, 1)});
  edges.Add(1, 0, {Edge(0, 1)});
  EXPECT_THAT(edges.ReleaseBelow(1).open, IsEmpty());
}

TEST(JoinedEdgesTest, AnEdgeThatWasOpenIsNotNew) {
  JoinedEdges edges;
  edges.Add(0, 0, {Edge(1, 1)});
  edges.Add(0, 0, {Edge(1, 2, 5), Edge(1, 0, 6)});
  const JoinedEdges::Released released = edges.ReleaseBelow(1);
  EXPECT_THAT(released.open, IsEmpty());
  EXPECT_THAT(released.rims, SizeIs(2)) << "but for the edge that is gone";
}

TEST(JoinedEdgesTest, TellsTheTileOfANewOpenEdge) {
  JoinedEdges edges;
  edges.Add(0, 0, {Edge(1, 0)});  // its triangle was cleared
  edges.Add(1, 0, {Edge(1, 1)});
  edges.Add(2, 0, {Edge(0, 1, 5)});
  const JoinedEdges::Released released = edges.ReleaseBelow(1);
  ASSERT_THAT(released.open, SizeIs(2));
  EXPECT_EQ(released.open[0].tile, 1);
  EXPECT_EQ(released.open[1].tile, 2);
}

TEST(JoinedEdgesTest, TellsTheHoleOfANewOpenEdge) {
  JoinedEdges edges;
  OpenEdge filled = Edge(0, 1);
  filled.hole = 7;
  edges.Add(0, 0, {filled});
  edges.Add(1, 0, {Edge(1, 0)});
  edges.Add(2, 0, {Edge(0, 1, 5)});
  const JoinedEdges::Released released = edges.ReleaseBelow(1);
  ASSERT_THAT(released.open, SizeIs(1));
  EXPECT_EQ(released.open[0].edge.hole, -1);
  ASSERT_THAT(released.rims, SizeIs(1));
  EXPECT_EQ(released.rims[0].edge.hole, 7);
}

TEST(JoinedEdgesTest, WaitsForTheRowsAndForgetsWhatItReleased) {
  JoinedEdges edges;
  edges.Add(0, 3, {Edge(0, 1)});
  EXPECT_THAT(edges.ReleaseBelow(3).open, IsEmpty());
  EXPECT_THAT(edges.ReleaseBelow(4).open, SizeIs(1));
  EXPECT_THAT(edges.ReleaseBelow(4).open, IsEmpty());
}

TEST(JoinedEdgesTest, TrianglesOfTwoTilesGoRoundInOppositeDirections) {
  const auto turned = [](int32_t one, int32_t other, bool is_added) {
    OpenEdge a = Edge(0, 1), b = Edge(0, 1);
    a.forward = one;
    b.forward = other;
    a.is_added = b.is_added = is_added;
    JoinedEdges edges;
    edges.Add(0, 0, {a});
    edges.Add(1, 0, {b});
    return edges.ReleaseBelow(1).turned.size();
  };
  EXPECT_EQ(turned(1, 0, true), 0U);
  EXPECT_EQ(turned(1, 1, true), 1U);
  EXPECT_EQ(turned(0, 0, true), 1U);
  EXPECT_EQ(turned(1, 1, false), 0U) << "the scene has it so";
}

TEST(JoinedEdgesTest, AThirdTileAtAnEdgeIsCrowded) {
  JoinedEdges edges;
  edges.Add(0, 0, {Edge(1, 1)});
  edges.Add(1, 0, {Edge(1, 1)});
  edges.Add(2, 0, {Edge(0, 1)});
  EXPECT_THAT(edges.ReleaseBelow(1).crowded, SizeIs(1));
}

BorderStrip SheetAt(double height) {
  const SpaceTriangle a = {Point3(0, 0, height), Point3(4, 0, height), Point3(0, 4, height)};
  return {{a}, {true}};
}

TEST(BorderStripTest, GivesTheHeightOfTheNearestSurface) {
  const BorderStrip::Nearest nearest = SheetAt(2).NearestTo({1, 1, 1.5});
  EXPECT_TRUE(nearest.is_covered);
  EXPECT_TRUE(nearest.is_inner);
  EXPECT_DOUBLE_EQ(nearest.height, 0.5);
  EXPECT_FALSE(SheetAt(2).NearestTo({3, 3, 2}).is_covered);
}

TEST(BorderStripTest, AWallCoversWhatIsBesideIt) {
  const BorderStrip wall({{Point3(0, 0, 0), Point3(4, 0, 0), Point3(2, 0, 4)}}, {false});
  EXPECT_TRUE(wall.NearestTo({2, 0.04, 1}).is_covered);
  EXPECT_FALSE(wall.NearestTo({2, 0.5, 1}).is_covered);
}

TEST(BorderStripTest, AnEdgeEndsAtSurfaceAboveOrBelowIt) {
  EXPECT_TRUE(SheetAt(2).EndsAt({1, 1, 1.1}));
  EXPECT_TRUE(SheetAt(2).EndsAt({1, 1, 2.9}));
  EXPECT_FALSE(SheetAt(2).EndsAt({1, 1, 3.1}));
  EXPECT_FALSE(SheetAt(2).EndsAt({-0.1, 1, 2})) << "a gap in the ground";
}

TEST(BorderStripTest, AnEdgeEndsAtAnObjectOrAWallBesideIt) {
  const BorderStrip leaning({{Point3(0, 0, 0), Point3(4, 0, 0), Point3(2, 0.5, 4)}}, {false});
  EXPECT_TRUE(leaning.EndsAt({2, 0.8, 1}));
  EXPECT_TRUE(leaning.EndsAt({2, -0.6, 1}));
  EXPECT_TRUE(leaning.EndsAt({4.9, 0, 0})) << "beside its corner";
  EXPECT_FALSE(leaning.EndsAt({2, 1.3, 1}));
  EXPECT_FALSE(leaning.EndsAt({5.1, 0, 0}));
}

bool IsNew(const OpenEdge& e) { return e.before != 1; }

TEST(CoverOpenEdgesTest, OnlyEdgesThatAreAskedForAreMarked) {
  TriMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-5, -5, 0.3}, {5, -5, 0.3}, {0, 5, 0.3}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  std::vector<OpenEdge> edges = {{{0, 0, 0}, {1, 0, 0}, 1, 1, false}};
  CoverOpenEdges(mesh, IsNew, edges);
  EXPECT_FALSE(edges[0].is_covered);
  CoverOpenEdges(
      mesh, [](const OpenEdge&) { return true; }, edges);
  EXPECT_TRUE(edges[0].is_covered);
}

TEST(CoverOpenEdgesTest, OnlyOtherSurfaceNearbyCovers) {
  TriMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-5, -5, 0.3}, {5, -5, 0.3}, {0, 5, 0.3}};
  mesh.triangles = {{0, 1, 2}};
  std::vector<OpenEdge> edges = {{{0, 0, 0}, {1, 0, 0}, 0, 1, true}};
  CoverOpenEdges(mesh, IsNew, edges);
  EXPECT_FALSE(edges[0].is_covered);
  mesh.triangles.push_back({3, 4, 5});
  CoverOpenEdges(mesh, IsNew, edges);
  EXPECT_TRUE(edges[0].is_covered);
  for (int v = 3; v < 6; ++v) mesh.points[static_cast<size_t>(v)].z() = 5;  // a tree
  CoverOpenEdges(mesh, IsNew, edges);
  EXPECT_FALSE(edges[0].is_covered);
}

// A fill ends in the strip of two pieces, at an edge that begins at a corner of the piece that goes on beyond it.
TEST(CoverOpenEdgesTest, SurfaceThatHasACornerAtTheEdgeCoversItAsWell) {
  TriMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 4, 0.1}, {4, -1, 0.1}};
  mesh.triangles = {{0, 1, 2}, {0, 3, 4}};
  std::vector<OpenEdge> edges = {{{0, 0, 0}, {1, 0, 0}, 0, 1, true}};
  CoverOpenEdges(mesh, IsNew, edges);
  EXPECT_TRUE(edges[0].is_covered);
}

TEST(CoverOpenEdgesTest, SurfaceThatEndsAtTheEdgeDoesNotCoverIt) {
  TriMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0.6, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 3, 4}, {3, 1, 5}};  // a T-junction
  std::vector<OpenEdge> edges = {{{0, 0, 0}, {1, 0, 0}, 0, 1, true}};
  CoverOpenEdges(mesh, IsNew, edges);
  EXPECT_FALSE(edges[0].is_covered);
}

TEST(CoverOpenEdgesTest, AWallOnAnEndOfTheEdgeDoesNotCoverIt) {
  TriMesh mesh;
  mesh.points = {{0, 0, 0}, {0.06, 0, 0}, {0, -1, 0}, {0, 0.2, 3}, {0, -0.2, 3}};
  mesh.triangles = {{0, 1, 2}, {0, 3, 4}};
  std::vector<OpenEdge> edges = {{{0, 0, 0}, {0.06, 0, 0}, 0, 1, true}};
  CoverOpenEdges(mesh, IsNew, edges);
  EXPECT_FALSE(edges[0].is_covered);
}

}  // namespace
}  // namespace tilemend
