#include "worker/fill/plane/upright_walls.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

// A square hole of 8 m whose vertices 0 to 3 are at the given heights; the patch has one new point in its middle.
class UprightWallsTest : public ::testing::Test {
 protected:
  UprightWallsTest() {
    cell_.lattice_step = 1.0 / 1024;
    cell_.vertices.resize(4);
    hole_.cell = &cell_;
    hole_.band = &band_;
    hole_.own_outline = true;
    hole_.has_equation.assign(5, true);
    hole_.positions = {{0, 0, 5}, {8, 0, 5.25}, {8, 8, 2}, {0, 8, 1}};
    hole_.on_object = {true, true, false, false};
    for (int32_t v = 0; v < 4; ++v) {
      hole_.vertices.push_back(v);
      hole_.sizes.push_back(2);
      hole_.segments.push_back({v, (v + 1) % 4});
      hole_.boundary.push_back(Undirected(v, (v + 1) % 4));
      patch_.triangles.push_back({v, (v + 1) % 4, 4});
    }
    std::sort(hole_.boundary.begin(), hole_.boundary.end());
    patch_.new_points = {{4, 4, 1}};
  }

  // Of each directed edge, less those of the other direction.
  std::map<std::pair<int32_t, int32_t>, int> OpenEdges() const {
    std::map<std::pair<int32_t, int32_t>, int> open;
    for (const Triangle& t : patch_.triangles) {
      for (int k = 0; k < 3; ++k) {
        const int32_t a = t[k], b = t[(k + 1) % 3];
        if (--open[{b, a}] == 0) open.erase({b, a});
        if (++open[{a, b}] == 0) open.erase({a, b});
      }
    }
    std::erase_if(open, [](const auto& edge) { return edge.second < 0; });
    return open;
  }

  // Twice, seen from above.
  double AreaFromAbove(const Triangle& t) const {
    std::vector<Point3> p;
    for (const int32_t v : t) p.push_back(v < 4 ? hole_.positions[v] : patch_.new_points[v - 4]);
    return (p[1] - p[0]).cross(p[2] - p[0]).z();
  }

  CellHoles cell_;
  static CellHoles WithoutHoles() {
    CellHoles cell;
    cell.vertices.resize(4);
    return cell;
  }

  const CellHoles alone_ = WithoutHoles();
  const CellBand band_{alone_};
  LocalHole hole_;
  LocalPatch patch_;
  const std::vector<double> ground_ = {1.3, 1.7, 2, 1};
};

TEST_F(UprightWallsTest, StandStraightUnderObjects) {
  EXPECT_THAT(RaiseWalls(hole_, ground_, patch_), ElementsAre(5, 6, -1, -1));
  ASSERT_THAT(patch_.new_points, SizeIs(3));
  EXPECT_EQ(patch_.new_points[1].head<2>(), hole_.positions[0].head<2>());
  EXPECT_EQ(patch_.new_points[2].head<2>(), hole_.positions[1].head<2>());
  EXPECT_NEAR(patch_.new_points[1].z(), 1.3, cell_.lattice_step);
  EXPECT_NEAR(patch_.new_points[2].z(), 1.7, cell_.lattice_step);
  EXPECT_THAT(patch_.triangles, SizeIs(4 + 1 + 2 + 1));
}

// Where no other tile has to find the same feet.
TEST_F(UprightWallsTest, LeanALittleSoThatTheyFaceUp) {
  hole_.own_outline = false;
  hole_.level = 1.25;
  RaiseWalls(hole_, std::vector<double>(4, 1.25), patch_);
  ASSERT_THAT(patch_.new_points, SizeIs(3));
  for (const Triangle& t : patch_.triangles) {
    EXPECT_GT(AreaFromAbove(t), 0) << t[0] << " " << t[1] << " " << t[2];
  }
  for (int32_t v = 0; v < 2; ++v) {
    const Point3& foot = patch_.new_points[v + 1];
    EXPECT_LT((foot - hole_.positions[v]).head<2>().norm(), 0.01);
    EXPECT_EQ(foot.z(), 1.25);
  }
}

// A triangle beside vertex 0 has no room for a foot inside it.
TEST_F(UprightWallsTest, StandStraightWhereTheyWouldFold) {
  hole_.own_outline = false;
  hole_.level = 1.25;
  patch_.new_points[0] = {1.0 / 1024, 4, 1.25};
  RaiseWalls(hole_, std::vector<double>(4, 1.25), patch_);
  EXPECT_EQ(patch_.new_points[1].head<2>(), hole_.positions[0].head<2>());
  EXPECT_NE(patch_.new_points[2].head<2>(), hole_.positions[1].head<2>());
  for (const Triangle& t : patch_.triangles) EXPECT_GE(AreaFromAbove(t), 0);
}

// The edge from vertex 0 to 1 is above the water at its begin and below it at its end.
TEST_F(UprightWallsTest, GoAroundWhereTheRimPassesThroughLevelWater) {
  hole_.level = 5.125;
  patch_.new_points = {{4, 4, 5.125}};
  RaiseWalls(hole_, std::vector<double>(4, 5.125), patch_);
  ASSERT_THAT(patch_.new_points, SizeIs(4));
  const Point3 beside = patch_.new_points[3];
  EXPECT_NEAR(beside.x(), 4, 1e-9);
  EXPECT_NEAR(beside.y(), 0.02, cell_.lattice_step);
  EXPECT_NEAR(beside.z(), 5.125, cell_.lattice_step);
  std::map<std::pair<int32_t, int32_t>, int> rim;
  for (const RegionSegment& s : hole_.segments) rim[{s.from, s.to}] = 1;
  EXPECT_EQ(OpenEdges(), rim);
  // No two upright triangles lie in the plane of the edge.
  int in_plane = 0;
  for (const Triangle& t : patch_.triangles) {
    const SpaceTriangle at = InSpace(hole_, patch_, t);
    in_plane += at[0].y() == 0 && at[1].y() == 0 && at[2].y() == 0 ? 1 : 0;
  }
  EXPECT_EQ(in_plane, 0);
}

TEST_F(UprightWallsTest, CloseOnTheSameBoundary) {
  RaiseWalls(hole_, ground_, patch_);
  std::map<std::pair<int32_t, int32_t>, int> rim;
  for (const RegionSegment& s : hole_.segments) rim[{s.from, s.to}] = 1;
  EXPECT_EQ(OpenEdges(), rim);
}

TEST_F(UprightWallsTest, AreNotNeededWhereTheSurfaceIsClose) {
  RaiseWalls(hole_, std::vector<double>{4.9, 5.2, 2, 1}, patch_);
  EXPECT_THAT(patch_.new_points, SizeIs(1));
  EXPECT_THAT(patch_.triangles, SizeIs(4));
}

TEST_F(UprightWallsTest, StandAtLevelWaterWhereverTheRimIsOffIt) {
  hole_.positions[0].z() = 1.33;
  hole_.positions[1].z() = 1.29;
  const std::vector<double> level(4, 1.3);
  RaiseWalls(hole_, level, patch_);
  EXPECT_THAT(patch_.new_points, SizeIs(1));
  hole_.level = 1.3;
  RaiseWalls(hole_, level, patch_);
  EXPECT_THAT(patch_.new_points, SizeIs(2)) << "vertex 1 is close enough";
}

TEST_F(UprightWallsTest, StandNowhereAtTheEndsOfSharedSeams) {
  hole_.own_outline = false;
  hole_.has_equation[0] = false;
  RaiseWalls(hole_, ground_, patch_);
  EXPECT_THAT(patch_.new_points, SizeIs(2)) << "under vertex 1 only";
}

TEST_F(UprightWallsTest, AreNoHigherThanTheHoleIsWide) {
  hole_.positions[0].z() = 20;
  RaiseWalls(hole_, ground_, patch_);
  EXPECT_THAT(patch_.new_points, SizeIs(2)) << "under the other object only";
}

TEST_F(UprightWallsTest, StandNotWhereAnotherHoleTouchesTheRim) {
  CellHoles touching;
  touching.vertices.resize(4);
  touching.holes.resize(2);
  for (CellHole& hole : touching.holes) hole.segments = {{0, 2}, {2, 0}};
  touching.holes[0].segments.push_back({1, 1});
  const CellBand band(touching);
  hole_.band = &band;
  const std::vector<int32_t> feet = RaiseWalls(hole_, ground_, patch_);
  EXPECT_EQ(feet[0], -1);
  EXPECT_NE(feet[1], -1);
}

TEST_F(UprightWallsTest, StandNowhereWithoutObjects) {
  hole_.on_object = {};
  RaiseWalls(hole_, ground_, patch_);
  EXPECT_THAT(patch_.new_points, SizeIs(1));
}

// The boundary goes out from vertex 0 to a vertex beyond the square, and back.
TEST_F(UprightWallsTest, LeaveOutWhatTheBoundaryPassesToAndFro) {
  hole_.positions.emplace_back(-2, -2, 6);
  hole_.vertices.push_back(4);
  hole_.sizes.push_back(2);
  hole_.on_object.push_back(true);
  for (Triangle& t : patch_.triangles) t[2] = 5;
  for (const RegionSegment& s : {RegionSegment{0, 4}, RegionSegment{4, 0}}) {
    hole_.segments.push_back(s);
    hole_.boundary.push_back(Undirected(s.from, s.to));
  }
  std::sort(hole_.boundary.begin(), hole_.boundary.end());
  RaiseWalls(hole_, std::vector<double>{1.3, 1.7, 2, 1, 1}, patch_);
  EXPECT_THAT(patch_.new_points, SizeIs(2)) << "under vertex 1 only";
}

}  // namespace
}  // namespace tilemend
