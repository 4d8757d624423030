#include "worker/fill/space/free_outline.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/outline_hole.h"
#include "worker/fill/space/patch_soundness.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// The vertices of the hole have the numbers that they have in the cell; 5 is a point of the patch.
class FreeOutlineTest : public testing::Test {
 protected:
  // A fan about a point in the middle.
  FreeOutlineTest() {
    patch_.new_points = {{2, 2, 5}};
    for (const RegionSegment& s : hole_.segments) patch_.triangles.push_back({s.from, s.to, 5});
  }

  const CellHoles work_ = HoleAtOutline();
  const CellBand band_{work_};
  const LocalHole hole_ = MakeLocalHole(work_, band_, work_.holes[0]);
  FreeOutline outline_{hole_};
  LocalPatch patch_;
};

TEST_F(FreeOutlineTest, IsWhatThePlanMadeOnTheOutline) {
  for (const int32_t v : {0, 2, 3, 4, 5}) EXPECT_FALSE(outline_.IsFree(v)) << v;
  EXPECT_TRUE(outline_.IsFree(1));
  EXPECT_TRUE(outline_.IsFreeEdge(0, 1));
  EXPECT_TRUE(outline_.IsFreeEdge(2, 1));
  EXPECT_FALSE(outline_.IsFreeEdge(2, 3));
  EXPECT_TRUE(outline_.IsFreeEdge(0, 5)) << "no edge of the hole";
}

TEST_F(FreeOutlineTest, NothingIsFreeWhereTilesShareTheirSeams) {
  CellHoles shared = work_;
  shared.holes[0].own_outline = false;
  const LocalHole hole = MakeLocalHole(shared, band_, shared.holes[0]);
  EXPECT_THAT(hole.free_edges, IsEmpty());
  EXPECT_FALSE(FreeOutline(hole).IsFree(1));
}

TEST_F(FreeOutlineTest, RemembersWhereThePlanHasAPoint) {
  EXPECT_EQ(outline_.PlannedPlace(1, Point3(9, 9, 9)), Point3(2, 0, 5));
  EXPECT_EQ(outline_.PlannedPlace(5, Point3(9, 9, 9)), Point3(9, 9, 9));
  outline_.Add(5, {2, 0, 5});
  EXPECT_TRUE(outline_.IsFree(5));
  EXPECT_EQ(outline_.PlannedPlace(5, Point3(9, 9, 9)), Point3(2, 0, 5));
}

TEST_F(FreeOutlineTest, WallsMayEndFurtherAsideThanGround) {
  const Point3 planned(2, 0, 5);
  EXPECT_TRUE(FreeOutline::MayLie(planned, {2, 0.04, 5.01}, true));
  EXPECT_FALSE(FreeOutline::MayLie(planned, {2, 0, 5.1}, true));
  EXPECT_FALSE(FreeOutline::MayLie(planned, {2, 0.1, 5}, true));
  EXPECT_TRUE(FreeOutline::MayLie(planned, {2, 0.1, 5.2}, false));
  EXPECT_FALSE(FreeOutline::MayLie(planned, {2, 0, 5.5}, false));
}

TEST_F(FreeOutlineTest, TellsWhichEdgesAPatchLeaves) {
  EXPECT_TRUE(outline_.TellLeft(patch_));
  EXPECT_THAT(patch_.left_edges, IsEmpty());
  // Over a new point instead of vertex 1.
  patch_.new_points.push_back({2, 0.05, 5});
  for (Triangle& t : patch_.triangles) std::ranges::replace(t, 1, 6);
  EXPECT_EQ(FaultOf(hole_, patch_), FillFailure::kNotClosed) << "not told yet";
  EXPECT_TRUE(outline_.TellLeft(patch_));
  EXPECT_THAT(patch_.left_edges, ElementsAre(VertexPair(0, 1), VertexPair(1, 2)));
  EXPECT_EQ(FaultOf(hole_, patch_), FillFailure::kNone);
  patch_.new_points[1] = {2, 1, 5};
  EXPECT_FALSE(outline_.TellLeft(patch_)) << "far from them";
}

TEST_F(FreeOutlineTest, APatchLeavesNoEdgeOfTheSurface) {
  patch_.triangles.erase(patch_.triangles.begin() + 2);
  EXPECT_FALSE(outline_.TellLeft(patch_));
}

}  // namespace
}  // namespace tilemend
