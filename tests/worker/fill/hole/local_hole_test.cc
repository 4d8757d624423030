#include "worker/fill/hole/local_hole.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "tests/support/mesh_builders.h"
#include "tests/support/patch_checks.h"

namespace tilemend {
namespace {

const std::vector<std::string> kHoleWithIsland = {"##########",  //
                                                  "#........#",  //
                                                  "#........#",  //
                                                  "#..###...#",  //
                                                  "#..###...#",  //
                                                  "#........#",  //
                                                  "#........#",  //
                                                  "##########"};

CellHoles HoleOf(const TriMesh& mesh, double width, double height) {
  const auto inside = [&](const Point3& p) { return p.x() > 0 && p.y() > 0 && p.x() < width && p.y() < height; };
  return WorkOf(mesh, false, [&](const Point3& a, const Point3& b) { return inside(a) && inside(b); });
}

TEST(LocalHoleTest, NumbersEachVertexOnce) {
  const CellHoles work = HoleOf(PictureMesh(kHoleWithIsland), 10, 8);
  const CellBand band(work);
  const LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  ASSERT_EQ(hole.segments.size(), work.holes[0].segments.size());
  EXPECT_EQ(hole.size(), 28 + 10);
  for (size_t s = 0; s < hole.segments.size(); ++s) {
    EXPECT_EQ(hole.vertices[hole.segments[s].from], work.holes[0].segments[s].from);
    EXPECT_EQ(hole.vertices[hole.segments[s].to], work.holes[0].segments[s].to);
  }
  for (int32_t v = 0; v < hole.size(); ++v) EXPECT_EQ(hole.positions[v], work.vertices[hole.vertices[v]].position);
  EXPECT_NEAR(hole.VectorArea().z(), 8 * 6 - 3 * 2, 1e-12);
}

TEST(LocalHoleTest, HasALoopForTheOutlineAndOneForTheIsland) {
  const CellHoles work = HoleOf(PictureMesh(kHoleWithIsland), 10, 8);
  const CellBand band(work);
  const LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  ASSERT_EQ(hole.loops.size(), 2u);
  EXPECT_EQ(hole.loops[0].size() + hole.loops[1].size(), hole.size());
  for (const RimLoop& loop : hole.loops) {
    for (const Eigen::Vector3d& normal : loop.outside) EXPECT_EQ(normal, Eigen::Vector3d::UnitZ());
  }
  for (const Eigen::Vector3d& normal : hole.normals) EXPECT_EQ(normal, Eigen::Vector3d::UnitZ());
}

TEST(LocalHoleTest, JoinsNoVerticesThatHaveAnEdge) {
  const CellHoles work = HoleOf(PictureMesh(kHoleWithIsland), 10, 8);
  const CellBand band(work);
  const LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  int32_t allowed = 0;
  for (int32_t a = 0; a < hole.size(); ++a) {
    EXPECT_FALSE(hole.MayJoin(a, a));
    for (int32_t b = 0; b < a; ++b) {
      EXPECT_EQ(hole.MayJoin(a, b), hole.MayJoin(b, a));
      EXPECT_EQ(hole.MayJoin(a, b), hole.TrianglesBeside(a, b) == 0);
      allowed += hole.MayJoin(a, b);
    }
  }
  EXPECT_GT(allowed, 600);
  for (const RegionSegment& s : hole.segments) EXPECT_EQ(hole.TrianglesBeside(s.from, s.to), 1);
}

TEST(LocalHoleTest, GivesVerticesWithoutASizeThatOfTheirEdges) {
  CellHoles work = HoleOf(PictureMesh(kHoleWithIsland), 10, 8);
  const CellBand band(work);
  for (RimVertex& v : work.vertices) v.size = 0;
  for (const double size : MakeLocalHole(work, band, work.holes[0]).sizes) EXPECT_DOUBLE_EQ(size, 1);
  for (RimVertex& v : work.vertices) v.size = 2.5;
  for (const double size : MakeLocalHole(work, band, work.holes[0]).sizes) EXPECT_DOUBLE_EQ(size, 2.5);
}

TEST(LocalHoleTest, HasNoEquationsAtSeams) {
  CellHoles work = HoleOf(PictureMesh(kHoleWithIsland), 10, 8);
  work.holes[0].segments[3].seam = true;
  const CellBand band(work);
  const LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  for (int32_t v = 0; v < hole.size(); ++v) {
    EXPECT_EQ(hole.has_equation[v], v != hole.segments[3].from && v != hole.segments[3].to);
  }
}

// A sheet that is folded up at x = 7: of the hole's vertices those on the fold touch both sides.
TEST(LocalHoleTest, FreesFolds) {
  const auto fold = [](const Point3& p) { return p.x() < 7 ? p : Point3(7, p.y(), 2 * (p.x() - 7)); };
  const CellHoles work = HoleOf(PictureMesh(kHoleWithIsland), 10, 8);
  CellHoles folded = work;
  for (RimVertex& v : folded.vertices) v.position = fold(v.position);
  for (Point3& p : folded.band.points) p = fold(p);
  const CellBand flat_band(work), band(folded);
  LocalHole flat = MakeLocalHole(work, flat_band, work.holes[0]);
  FreeAtFolds(flat);
  LocalHole hole = MakeLocalHole(folded, band, folded.holes[0]);
  FreeAtFolds(hole);
  for (int32_t v = 0; v < hole.size(); ++v) {
    EXPECT_TRUE(flat.has_equation[v]);
    if (hole.positions[v].x() == 7 && hole.positions[v].z() == 0) {
      EXPECT_FALSE(hole.has_equation[v]);
    }
    if (hole.positions[v].x() < 4) {
      EXPECT_TRUE(hole.has_equation[v]);
    }
  }
}

TEST(LocalHoleTest, BandHasTheTrianglesAtChosenVertices) {
  const CellHoles work = HoleOf(PictureMesh(kHoleWithIsland), 10, 8);
  const CellBand band(work);
  const LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  std::vector<bool> chosen(hole.vertices.size(), false);
  EXPECT_TRUE(BandAt(hole, chosen, 100).triangles.empty());
  chosen[5] = true;
  const BandTriangles around = BandAt(hole, chosen, 100);
  EXPECT_EQ(around.triangles.size(), band.At(hole.vertices[5]).size());
  for (const Triangle& t : around.triangles) {
    EXPECT_NE(std::find(t.begin(), t.end(), 5), t.end());
    for (const int32_t v : t) EXPECT_TRUE(v < hole.size() || (v >= 100 && v - 100 < std::ssize(around.others)));
  }
}

// The west half of a square hole, parted from the east by two new points.
TEST(LocalHoleTest, NumbersAPartOnItsOwn) {
  const std::vector<std::string> picture = {"######", "#....#", "#....#", "#....#", "#....#", "######"};
  const CellHoles work = HoleOf(PictureMesh(picture), 6, 6);
  const CellBand band(work);
  const LocalHole hole = MakeLocalHole(work, band, work.holes[0]);
  const auto vertex = [&](double x, double y) {
    for (int32_t v = 0; v < hole.size(); ++v) {
      if (hole.positions[v] == Point3(x, y, 0)) return v;
    }
    ADD_FAILURE() << x << " " << y;
    return 0;
  };
  const std::vector<Point3> new_points = {{3, 2, 0}, {3, 4, 0}};
  std::vector<PartCorner> loop;
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  loop.push_back({vertex(3, 5), up, true});
  for (int x = 2; x > 1; --x) loop.push_back({vertex(x, 5), up});
  for (int y = 5; y > 1; --y) loop.push_back({vertex(1, y), up});
  for (int x = 1; x < 3; ++x) loop.push_back({vertex(x, 1), up});
  loop.push_back({vertex(3, 1), up, true});
  loop.push_back({hole.size()});
  loop.push_back({hole.size() + 1});
  const HolePart part = MakePart(hole, new_points, {loop});
  ASSERT_EQ(part.hole.size(), std::ssize(loop));
  EXPECT_NEAR(part.hole.VectorArea().z(), 8, 1e-12);
  for (int32_t v = 0; v < part.hole.size(); ++v) {
    EXPECT_EQ(part.vertices[v], loop[v].vertex);
    const bool on_rim = loop[v].vertex < hole.size();
    EXPECT_EQ(part.hole.positions[v],
              on_rim ? hole.positions[loop[v].vertex] : new_points[loop[v].vertex - hole.size()]);
    EXPECT_EQ(part.hole.has_equation[v], on_rim && !loop[v].ends_crease);
  }
  EXPECT_DOUBLE_EQ(part.hole.sizes.back(), 1.5) << "the mean length of its segments";
}

}  // namespace
}  // namespace tilemend
