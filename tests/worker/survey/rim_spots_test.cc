#include "worker/survey/rim_spots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tests/support/mesh_builders.h"
#include "worker/survey/survey.h"

namespace tilemend {
namespace {

Point3 PlaceOf(const TriMesh& mesh, const RimSpot& spot) {
  Point3 place = Point3::Zero();
  for (int k = 0; k < 3; ++k) place += spot.weights[k] * mesh.points[mesh.triangles[spot.triangle][k]];
  return place;
}

// Whether each boundary vertex has one spot, inside its triangle and beside an edge that begins there.
void ExpectSpotsAtTheRim(const TriMesh& mesh) {
  const SurveyRecord record = SurveyTile(mesh, true);
  ASSERT_FALSE(record.edges.empty());
  std::vector<int> spots_at(record.vertices.size(), 0);
  for (const RimSpot& spot : RimSpots(mesh, record)) {
    ++spots_at[spot.vertex];
    EXPECT_DOUBLE_EQ(std::accumulate(spot.weights.begin(), spot.weights.end(), 0.0), 1);
    const Point3 place = PlaceOf(mesh, spot);
    const bool beside = std::any_of(record.edges.begin(), record.edges.end(), [&](const BoundaryEdge& e) {
      const Point3 middle = (record.vertices[e.from].position + record.vertices[e.to].position) / 2;
      return e.from == spot.vertex && (place - middle).norm() < 0.2;
    });
    EXPECT_TRUE(beside) << place.transpose();
  }
  for (const int count : spots_at) EXPECT_EQ(count, 1);
}

TEST(RimSpotsTest, LieBesideTheBoundary) {
  const TriMesh mesh = PictureMesh({"####", "#..#", "#.##", "####"});
  ExpectSpotsAtTheRim(mesh);
}

TEST(RimSpotsTest, FindTheTriangleThroughTextureSeams) {
  ExpectSpotsAtTheRim(Unwelded(PictureMesh({"####", "#..#", "####"})));
}

TEST(RimSpotsTest, AClosedSurfaceHasNone) {
  const TriMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  EXPECT_TRUE(RimSpots(mesh, SurveyTile(mesh, true)).empty());
}

}  // namespace
}  // namespace tilemend
