#include "coordinator/plan/seam/area_edge.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/plan_checks.h"
#include "tests/support/seam_scene.h"

namespace tilemend {
namespace {

using Ring = std::vector<Point2>;

Ring Box(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

AreaCut Cut(const Picture& picture, int32_t squares, const std::vector<Ring>& rings) {
  SeamScene s(picture, squares);
  s.input.area.rings = rings;
  return CutByArea(s.Site(), s.input);
}

Plan PlanIn(const SurveyedScene& scene, const std::vector<Ring>& rings) {
  PlanInput input = scene.Input();
  input.area.rings = rings;
  return MakePlan(input, {});
}

double AreaOf(const Plan& plan) {
  double area = 0;
  for (const PlannedHole& hole : plan.holes) area += hole.area;
  return area;
}

// A surface of 6 x 4 squares in the west of a cell of 8 m, with a bay of 2 x 2 at its eastern end.
const Picture kBay = {"######..", "######..", "####....", "####....", "######..", "######..", "######..", "######.."};

TEST(CutByAreaTest, LeavesNothingWhereTheSurfaceCoversThePolygon) {
  const AreaCut cut = Cut(kBay, 8, {Box(1, 1, 3.5, 7)});
  EXPECT_THAT(cut.rim.edges, testing::IsEmpty());
  EXPECT_TRUE(cut.rim.surface_beyond);
}

TEST(CutByAreaTest, ThePlanKnowsThatThereIsAPolygon) {
  const Plan plan = PlanIn(PictureScene(kBay, 8), {Box(1, 1, 3.5, 7)});
  EXPECT_TRUE(plan.remarks.has_polygon);
  EXPECT_THAT(plan.holes, testing::IsEmpty());
  EXPECT_THAT(plan.left, testing::IsEmpty());
  EXPECT_FALSE(PlanIn(PictureScene(kBay, 8), {}).remarks.has_polygon);
}

TEST(CutByAreaTest, ClosesABayAlongThePolygonAtVerticesOutsideIt) {
  const AreaCut cut = Cut(kBay, 8, {Box(1, 1, 5.5, 7)});
  EXPECT_THAT(cut.left, testing::IsEmpty());
  ASSERT_THAT(cut.rim.loops, testing::SizeIs(1));
  EXPECT_THAT(cut.rim.unlinked, testing::IsEmpty());
  int original = 0;
  for (const RimEdge& e : cut.rim.edges) {
    original += !e.area_edge;
    EXPECT_EQ(e.owner, (CellId{0, 0}));
    if (e.area_edge && cut.rim.points[e.to].index < 0) {
      EXPECT_EQ(cut.rim.points[e.to].position.x(), 5.5);
    }
  }
  EXPECT_EQ(original, 6)
      << "two edges at either side of the bay, of which the outer ones pass the polygon, and its end";
}

TEST(CutByAreaTest, TakesAPolygonThatRunsAlongTheSurfacesEndForItsOutline) {
  const Plan plan = PlanIn(PictureScene(kBay, 8), {Box(0, 0, 6, 8)});
  EXPECT_EQ(CountsOf(plan), "1 IIB");
  EXPECT_NEAR(AreaOf(plan), 4, 1e-9);
  ExpectSound(plan);
}

// As a hole's polygon of holes.geojson is.
TEST(CutByAreaTest, APolygonAlongTheRimOfAHoleHasTheWholeHoleInside) {
  const Picture ponds = {"########", "##...#.#", "##.#####", "##...###",
                         "########", "########", "########", "########"};
  const Ring ring = {{2, 4}, {5, 4}, {5, 5}, {3, 5}, {3, 6}, {5, 6}, {5, 7}, {2, 7}};
  const Plan plan = PlanIn(PictureScene(ponds, 8), {ring});
  EXPECT_EQ(CountsOf(plan), "1 closed");
  EXPECT_NEAR(AreaOf(plan), 7, 1e-9);
  ExpectSound(plan);
}

TEST(CutByAreaTest, APolygonThatLeavesAHoleOutAlongItsRimLeavesItOpen) {
  const Picture ponds = {"########", "##...#.#", "##...###", "##...###",
                         "########", "########", "########", "########"};
  const Plan plan = PlanIn(PictureScene(ponds, 8), {Box(0, 0, 8, 8), Box(2, 4, 5, 7)});
  EXPECT_EQ(CountsOf(plan), "1 closed");
  EXPECT_NEAR(AreaOf(plan), 1, 1e-9);
  ExpectSound(plan);
}

TEST(CutByAreaTest, DoesNotDependOnTheDirectionAndTheStartOfARing) {
  Ring ring = Box(1, 1, 5.5, 7);
  const double area = AreaOf(PlanIn(PictureScene(kBay, 8), {ring}));
  EXPECT_GT(area, 3);
  for (int i = 0; i < 4; ++i) {
    std::rotate(ring.begin(), ring.begin() + 1, ring.end());
    EXPECT_NEAR(AreaOf(PlanIn(PictureScene(kBay, 8), {ring})), area, 1e-9);
    EXPECT_NEAR(AreaOf(PlanIn(PictureScene(kBay, 8), {Ring(ring.rbegin(), ring.rend())})), area, 1e-9);
  }
}

// Lakes at the end of the surface, over a border; surface and polygon end inside the cells.
TEST(CutByAreaTest, CountsThePolygonsRimAsTheRimOfTheArea) {
  const Picture two = {"........|........", "########|########", "########|########", "####....|..######",
                       "####....|..######", "####....|..######", "########|########", "########|########"};
  const Plan inside = PlanIn(PictureScene(two, 8), {Box(0, 0, 16, 6.5)});
  EXPECT_EQ(CountsOf(inside), "2 IB");
  const Plan through = PlanIn(PictureScene(two, 8), {Box(0, 3.5, 16, 6.5)});
  EXPECT_EQ(CountsOf(through), "2 IIB");
  EXPECT_EQ(through.clusters, 1);
  EXPECT_GT(AreaOf(through), 1.5 * 6);
  EXPECT_LT(AreaOf(through), AreaOf(inside));
  ExpectSound(through);
  const Plan wider = PlanIn(PictureScene(two, 8), {Box(0, 0, 16, 7.5)});
  EXPECT_EQ(CountsOf(wider), "2 IB, 2 IIB") << "the surface ends 0.5 m short of the polygon";
  EXPECT_NEAR(AreaOf(wider) - AreaOf(inside), 8, 1e-9);
  ExpectSound(wider);
}

TEST(CutByAreaTest, SaysThatAPartLeftOutInsideAHoleIsFilled) {
  const Picture lake = {"########", "#......#", "#......#", "#......#", "#......#", "#......#", "#......#", "########"};
  const Plan whole = PlanIn(PictureScene(lake, 8), {Box(0, 0, 8, 8)});
  EXPECT_EQ(CountsOf(whole), "1 closed");
  const Plan ring = PlanIn(PictureScene(lake, 8), {Box(0, 0, 8, 8), Box(3, 3, 5, 5)});
  EXPECT_EQ(CountsOf(ring), "1 closed");
  EXPECT_NEAR(AreaOf(ring), 36, 1e-9);
  ASSERT_THAT(ring.left, testing::SizeIs(1));
  EXPECT_THAT(ring.left[0].reason, testing::HasSubstr("inside a hole: it is filled"));
}

TEST(CutByAreaTest, LeavesWhatMeetsNoSurface) {
  const Plan plan = PlanIn(PictureScene({"....", "....", "....", "...."}, 4), {Box(-3, -3, 2, 9)});
  EXPECT_EQ(CountsOf(plan), "none");
  ASSERT_THAT(plan.left, testing::SizeIs(1));
  EXPECT_THAT(plan.left[0].reason, testing::HasSubstr("nothing tells its height"));
}

// Two tiles that end 0.25 m beyond their cells of 100 m, the western one with a hole.
TEST(CutByAreaTest, PlansTheSameForThePolygonOfTheCells) {
  const Picture lake = {"####|####", "##..|.###", "##..|.###", "####|##.."};
  const Plan cells = PlanOf(PictureScene(lake, 4)), polygon = PlanIn(PictureScene(lake, 4), {Box(0, 0, 8, 4)});
  EXPECT_EQ(CountsOf(polygon), CountsOf(cells));
  EXPECT_NEAR(AreaOf(polygon), AreaOf(cells), 1e-9);
}

}  // namespace
}  // namespace tilemend
