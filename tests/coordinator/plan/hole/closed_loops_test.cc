#include "coordinator/plan/hole/closed_loops.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/hole_scene.h"

namespace tilemend {
namespace {

ClosedLoop Read(const HoleScene& scene, size_t loop = 0) {
  const HoleSite site = scene.Site();
  PieceBoundaries pieces(site, scene.boundary);
  return ReadLoop(site, scene.boundary.closed_loops[loop], pieces);
}

void SetNormals(const Eigen::Vector3d& normal, HoleScene& scene) {
  for (RimPoint& p : scene.rim.points) p.normal = normal;
}

TEST(ReadLoopTest, TellsAHoleFromTheOutlineOfAPiece) {
  const HoleScene scene({HoleLoop(1, 1, 4, 3), PieceLoop(6, 6, 8, 8)});
  const ClosedLoop hole = Read(scene, 0), piece = Read(scene, 1);
  EXPECT_FALSE(hole.outer_rim);
  EXPECT_TRUE(hole.faces_up);
  EXPECT_EQ(hole.vector_area.z(), 6);
  EXPECT_TRUE(piece.outer_rim);
  EXPECT_EQ(piece.vector_area.z(), -4);
}

TEST(ReadLoopTest, TellsThemOnAWall) {
  // In the plane y = 5 that faces south.
  const Loop3 hole = {{1, 5, 1}, {1, 5, 3}, {4, 5, 3}, {4, 5, 1}};
  const Loop3 piece(hole.rbegin(), hole.rend());
  HoleScene scene({hole, piece});
  SetNormals({0, -1, 0}, scene);
  EXPECT_FALSE(Read(scene, 0).outer_rim);
  EXPECT_FALSE(Read(scene, 0).faces_up);
  EXPECT_TRUE(Read(scene, 1).outer_rim);
}

TEST(ReadLoopTest, TakesAnOverhangThatTheNormalsMakeDoubtfulByItsWayAroundFromAbove) {
  // Rough ground whose normals along the rim point every way, but up.
  HoleScene scene({{{1, 1, 0}, {1, 3, 2}, {1, 5, -1}, {3, 5, 2}, {5, 5, 0}, {5, 3, -2}, {5, 1, 1}, {3, 1, -1}}});
  for (size_t i = 0; i < scene.rim.points.size(); ++i) {
    scene.rim.points[i].normal = Eigen::Vector3d(i % 2 == 0 ? 1 : -1, 0, 0.01).normalized();
  }
  const ClosedLoop loop = Read(scene);
  EXPECT_TRUE(loop.faces_up);
  EXPECT_FALSE(loop.outer_rim);
}

// A hole of four edges in a rough wall that is a height field all the same: its normals happen to contradict its way
// around.
TEST(ReadLoopTest, TakesALoopOfAPieceWhoseBoundaryReachesBeyondForAHole) {
  HoleScene scene({{{1, 1, 0}, {1, 2, 30}, {2, 2, 30}, {2, 1, 0}}, PieceLoop(0, 0, 9, 9)});
  SetNormals(Eigen::Vector3d(0, 1, 0.1).normalized(), scene);
  EXPECT_TRUE(Read(scene).outer_rim) << "the pieces are not known";
  SurveyRecord record;
  for (const RimPoint& p : scene.rim.points) record.vertices.push_back({p.index, p.position, p.normal, 0});
  for (const RimEdge& e : scene.rim.edges) record.edges.push_back({e.from, e.to, 0});
  const StoredRecord stored(&record);
  scene.boundary.surface = &stored;
  EXPECT_FALSE(Read(scene).outer_rim);
  EXPECT_TRUE(Read(scene).faces_up);
  for (size_t e = 0; e < 4; ++e) record.edges[e].piece = 1;
  EXPECT_TRUE(Read(scene).outer_rim) << "it has all of its piece's boundary";
}

// One triangle at the foot of a crown is missing, which faces another way than what is around it.
TEST(ReadLoopTest, TakesAShortOutlineOfAPieceThatReachesBeyondForAHole) {
  HoleScene scene({{{1, 1, 5}, {2.2, 2, 0}, {2, 1.4, 0}}, PieceLoop(0, 0, 9, 9)});
  SetNormals(Eigen::Vector3d(-0.7, 0.7, 0.1).normalized(), scene);
  scene.rim.points[0].normal = Eigen::Vector3d(-0.7, 0.7, -0.1).normalized();
  EXPECT_TRUE(Read(scene).outer_rim) << "the pieces are not known";
  SurveyRecord record;
  for (const RimPoint& p : scene.rim.points) record.vertices.push_back({p.index, p.position, p.normal, 0});
  for (const RimEdge& e : scene.rim.edges) record.edges.push_back({e.from, e.to, 0});
  const StoredRecord stored(&record);
  scene.boundary.surface = &stored;
  EXPECT_FALSE(Read(scene).outer_rim);
  for (size_t e = 0; e < 3; ++e) record.edges[e].piece = 1;
  EXPECT_TRUE(Read(scene).outer_rim) << "it has all of its piece's boundary";
}

TEST(ReadLoopTest, DoesNotDependOnTheStart) {
  HoleScene scene({HoleLoop(1, 1, 4, 3)});
  const ClosedLoop before = Read(scene);
  std::vector<RimSegment>& loop = scene.boundary.closed_loops[0];
  std::rotate(loop.begin(), loop.begin() + 2, loop.end());
  const ClosedLoop after = Read(scene);
  EXPECT_TRUE(after.vector_area.isApprox(before.vector_area));
  EXPECT_EQ(after.outer_rim, before.outer_rim);
}

bool PieceLiesIn(const Loop3& piece, const Loop3& hole, const Eigen::Vector3d& piece_normal = {0, 0, 1}) {
  HoleScene scene({hole, piece});
  for (size_t i = hole.size(); i < scene.rim.points.size(); ++i) scene.rim.points[i].normal = piece_normal;
  return LiesIn(scene.Site(), Read(scene, 1), Read(scene, 0));
}

TEST(LiesInTest, HoldsForAPieceWithinTheHole) { EXPECT_TRUE(PieceLiesIn(PieceLoop(4, 4, 5, 5), HoleLoop(2, 2, 8, 8))); }

TEST(LiesInTest, DoesNotHoldBesideTheHole) { EXPECT_FALSE(PieceLiesIn(PieceLoop(9, 4, 9.5, 5), HoleLoop(2, 2, 8, 8))); }

TEST(LiesInTest, DoesNotHoldFarOffItsPlane) {
  EXPECT_TRUE(PieceLiesIn(PieceLoop(4, 4, 5, 5, 3), HoleLoop(2, 2, 8, 8))) << "within an edge's length";
  EXPECT_FALSE(PieceLiesIn(PieceLoop(4, 4, 5, 5, 30), HoleLoop(2, 2, 8, 8)));
  EXPECT_FALSE(PieceLiesIn(PieceLoop(4, 4, 5, 5, -30), HoleLoop(2, 2, 8, 8)));
}

TEST(LiesInTest, DoesNotHoldForAPieceThatFacesAwayOrIsLarger) {
  EXPECT_FALSE(PieceLiesIn(PieceLoop(4, 4, 5, 5), HoleLoop(2, 2, 8, 8), {0, 0, -1}));
  EXPECT_FALSE(PieceLiesIn(PieceLoop(1, 1, 9, 9), HoleLoop(2, 2, 8, 8)));
}

TEST(LiesInTest, GoesAsHighAsASurfaceThatLeansInFromTheRimRises) {
  const Loop3 hole = HoleLoop(2, 2, 8, 8), tip = PieceLoop(4.5, 4.5, 5.5, 5.5, 9);
  HoleScene scene({hole, tip});
  EXPECT_FALSE(LiesIn(scene.Site(), Read(scene, 1), Read(scene, 0)));
  for (size_t i = 0; i < hole.size(); ++i) {  // as on a pyramid around the hole
    const Eigen::Vector3d outward = (hole[i] - Point3(5, 5, 0)).normalized();
    scene.rim.points[i].normal = (2 * outward + Eigen::Vector3d(0, 0, 1)).normalized();
  }
  EXPECT_TRUE(LiesIn(scene.Site(), Read(scene, 1), Read(scene, 0)));
}

TEST(LiesInTest, APieceThatIsCurvedAsACLiesInTheHoleThatItsVerticesLieIn) {
  // The hole is a C, and the piece a thinner one within; the middle of either lies in its mouth.
  const Loop3 hole = {{0, 0, 0}, {0, 9, 0}, {9, 9, 0}, {9, 6, 0}, {3, 6, 0}, {3, 3, 0}, {9, 3, 0}, {9, 0, 0}};
  const Loop3 piece = {{1, 1, 0}, {8, 1, 0}, {8, 2, 0}, {2, 2, 0}, {2, 7, 0}, {8, 7, 0}, {8, 8, 0}, {1, 8, 0}};
  const Loop3 mouth = PieceLoop(5, 4, 6, 5);
  const HoleScene scene({hole, piece, mouth});
  const HoleSite site = scene.Site();
  EXPECT_TRUE(LiesIn(site, Read(scene, 1), Read(scene, 0)));
  EXPECT_FALSE(LiesIn(site, Read(scene, 2), Read(scene, 0))) << "what lies in the mouth is outside";
}

}  // namespace
}  // namespace tilemend
