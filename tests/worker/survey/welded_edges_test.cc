#include "worker/survey/welded_edges.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "tests/support/mesh_builders.h"
#include "worker/survey/survey.h"

namespace tilemend {
namespace {

using ::testing::Each;

// How many edges lead from one place of a flat mesh to another.
int CountOf(const SurveyRecord& record, const Point2& from, const Point2& to) {
  int count = 0;
  for (const BoundaryEdge& e : record.edges) {
    count += record.vertices[e.from].position.head<2>() == from && record.vertices[e.to].position.head<2>() == to;
  }
  return count;
}

TEST(WeldedEdgesTest, PiecesThatLieOnEachOtherHaveAnOutlineEach) {
  const SurveyRecord record = SurveyTile(PiecesOfOneSurface(), true, PieceAreas::kNo);
  EXPECT_EQ(record.edges.size(), 2U * 14);
  EXPECT_EQ(CountOf(record, {2, 0}, {3, 0}), 2) << "where both end";
  EXPECT_EQ(CountOf(record, {0, 0}, {1, 0}), 1);
  EXPECT_EQ(record.disagreeing_edges, 0);
  std::vector<int> leaving(record.vertices.size());
  for (const BoundaryEdge& e : record.edges) ++leaving[e.from], --leaving[e.to];
  EXPECT_THAT(leaving, Each(0));
}

TEST(WeldedEdgesTest, ASingleMeshHasNoDoubleEdges) {
  EXPECT_EQ(CountOf(SurveyTile(PiecesOfOneSurface(), true), {2, 0}, {3, 0}), 0);
}

// One of two squares faces down: the edge between them is no boundary, though that does not close.
TEST(WeldedEdgesTest, SurfacesThatFaceOppositeWaysHaveNoBoundaryBetweenThem) {
  TriMesh mesh = SquaresMesh(0, 2, 0, 1, [](int32_t, int32_t) { return true; });
  for (Triangle& t : mesh.triangles) {
    const Point3 middle = (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3;
    if (middle.x() > 1) std::swap(t[1], t[2]);
  }
  const SurveyRecord record = SurveyTile(mesh, true, PieceAreas::kNo);
  EXPECT_EQ(record.edges.size(), 6U);
  EXPECT_EQ(record.disagreeing_edges, 1);
}

// Two tiles that are there twice, edge for edge, close as they are.
TEST(WeldedEdgesTest, ABoundaryThatClosesHasNoDoubleEdges) {
  TriMesh mesh = SquaresMesh(0, 2, 0, 2, [](int32_t, int32_t) { return true; });
  const TriMesh once = mesh;
  const auto base = static_cast<int32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), once.points.begin(), once.points.end());
  for (const Triangle& t : once.triangles) mesh.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  EXPECT_TRUE(SurveyTile(mesh, true, PieceAreas::kNo).edges.empty());
}

}  // namespace
}  // namespace tilemend
