// The figures of Wang 2021, section 3, as pictures.
#include "coordinator/plan/plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/plan_checks.h"
#include "tests/support/surveyed_scene.h"

namespace tilemend {
namespace {

using ::testing::Each;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

// The area to the left of the segments, seen from above.
double BoundedArea(const Plan& plan, const PlannedHole& hole) {
  double sum = 0;
  for (const RimSegment& s : hole.segments) {
    const Point3 a = plan.vertices[s.from].position, b = plan.vertices[s.to].position;
    sum += (a.x() * b.y() - a.y() * b.x()) / 2;
  }
  return sum;
}

TEST(MakePlanTest, FindsNoHolesInAWholeSurface) {
  const Plan plan = PlanOf(Picture{"##|##", "##|##", "--+--", "##|##", "##|##"}, 2);
  ExpectSound(plan);
  EXPECT_EQ(CountsOf(plan), "none");
  EXPECT_THAT(plan.seams, IsEmpty());
}

TEST(MakePlanTest, TilesWithAnOpenBorderAreNotApart) {
  const Plan plan = PlanOf(Picture{"##|..", "##|.."}, 2);
  ASSERT_THAT(plan.borders, SizeIs(1));
  EXPECT_EQ(plan.borders[0].kind, BorderKind::kOpen);
}

// A triangle that faces down at the rim of a lake over two cells: the fault is in one of them.
TEST(MakePlanTest, SaysWhereAWalkAroundAHoleEnds) {
  SurveyedScene scene = PictureScene({"####|####", "##..|..##", "##..|..##", "####|####"}, 4);
  SurveyRecord& record = scene.records.at({0, 0});
  const auto is_at_lake = [&](const BoundaryEdge& e) {
    return record.vertices[e.from].position.head<2>() == Point2(2, 2);
  };
  const auto edge = std::ranges::find_if(record.edges, is_at_lake);
  ASSERT_NE(edge, record.edges.end());
  record.edges.erase(edge);
  const Plan plan = MakePlan(scene.Input(), {});
  ASSERT_EQ(plan.left.size(), 2U);
  EXPECT_THAT(plan.left[0].reason, HasSubstr("not manifold there"));
  ASSERT_TRUE(plan.left[0].at);
  EXPECT_EQ(plan.left[0].at->x(), 2);
  EXPECT_THAT(plan.left[1].reason, HasSubstr("with those of other cells"));
  EXPECT_FALSE(plan.left[1].at);
}

TEST(MakePlanTest, FindsAClosedHole) {
  const Plan plan = PlanOf(Picture{"####",  //
                                   "#..#",  //
                                   "#.##",  //
                                   "####"});
  ExpectSound(plan);
  EXPECT_EQ(CountsOf(plan), "1 closed");
  EXPECT_EQ(plan.holes[0].single, SingleType::kSimple);
  EXPECT_DOUBLE_EQ(plan.holes[0].area, 3);
  EXPECT_DOUBLE_EQ(plan.holes[0].perimeter, 8);
  EXPECT_EQ(plan.holes[0].boundary_vertices, 8);
  EXPECT_EQ(plan.layers, 0);
}

// Figure 4a.
TEST(MakePlanTest, CountsAnInternalOpenHoleOnceInEveryCellThatItReaches) {
  const Plan plan = PlanOf(Picture{"####|####",  //
                                   "##..|.###",  //
                                   "##..|.###",  //
                                   "####|####"});
  ExpectSound(plan);
  EXPECT_EQ(CountsOf(plan), "2 IB");
  EXPECT_EQ(plan.clusters, 1);
  EXPECT_EQ(plan.layers, 1);
}

// Figure 4b.
TEST(MakePlanTest, CallsAnOpenHoleExternalThatReachesTheRimOfTheArea) {
  const Plan plan = PlanOf(Picture{"####",  //
                                   "##..",  //
                                   "##..",  //
                                   "####"});
  ExpectSound(plan);
  EXPECT_EQ(CountsOf(plan), "1 IIB");
}

TEST(MakePlanTest, CallsOnlyThePartAtTheRimExternal) {
  const Plan plan = PlanOf(Picture{"####|####",  //
                                   "##..|....",  //
                                   "##..|....",  //
                                   "####|####"});
  ExpectSound(plan);
  EXPECT_EQ(CountsOf(plan), "1 IB, 1 IIC");
}

TEST(MakePlanTest, TakesTheEdgeOfAMissingCellForTheRimOfTheArea) {
  const Plan plan = PlanOf(Picture{"####|    ",  //
                                   "##..|    ",  //
                                   "##..|    ",  //
                                   "####|    ",  //
                                   "----+----",  //
                                   "####|####",  //
                                   "####|####",  //
                                   "####|####",  //
                                   "####|####"});
  ExpectSound(plan);
  EXPECT_EQ(CountsOf(plan), "1 IIB");
}

// Figure 5a: nothing in the cell; its neighbours' surfaces end at the grid lines all round, so there is no seam.
const Picture kHollow = {"##|##|##",  //
                         "##|##|##",  //
                         "--+--+--",  //
                         "##|..|##",  //
                         "##|..|##",  //
                         "--+--+--",  //
                         "##|##|##",  //
                         "##|##|##"};

TEST(MakePlanTest, FindsTypeAWhereTheCellHasNoSurface) {
  const Plan plan = PlanOf(kHollow, 2);
  ExpectSound(plan);
  EXPECT_EQ(CountsOf(plan), "1 IA");
  EXPECT_EQ(plan.holes[0].cell, (CellId{1, 1}));
}

TEST(MakePlanTest, LaysNoSeamWhereTheNeighboursSurfaceReachesTheBorder) {
  const Plan plan = PlanOf(kHollow, 2);
  EXPECT_THAT(plan.seams, IsEmpty());
  EXPECT_THAT(plan.holes[0].segments, SizeIs(8));
  EXPECT_THAT(plan.holes[0].segments, Each(Field(&RimSegment::seam, false)));
}

TEST(MakePlanTest, NamesTheVerticesOfNeighboursByTileAndIndex) {
  const SurveyedScene scene = PictureScene(kHollow, 2);
  const Plan plan = PlanOf(scene);
  for (const RimSegment& s : plan.holes.at(0).segments) {
    const PlanVertex& v = plan.vertices[s.from];
    ASSERT_GE(v.index, 0);
    EXPECT_NE(v.tile, (CellId{1, 1}));
    EXPECT_EQ(scene.tiles.at(v.tile).points.at(v.index), v.position);
  }
}

// Figure 5b.
TEST(MakePlanTest, FindsTypeBWhereOneSurfaceIsLeft) {
  EXPECT_EQ(CountsOf(PlanOf(Picture{"....",  //
                                    "....",  //
                                    "####",  //
                                    "####"})),
            "1 IIB");
}

TEST(MakePlanTest, FindsTypeBAroundAHeadland) {
  const Plan plan = PlanOf(Picture{"....",  //
                                   "....",  //
                                   ".##.",  //
                                   ".##."});
  ExpectSound(plan);
  EXPECT_EQ(CountsOf(plan), "1 IIB");
}

// Figure 5c.
TEST(MakePlanTest, FindsTypeCWhereTheSurfaceIsParted) {
  const Plan plan = PlanOf(Picture{"####|####|####",  //
                                   "##..|....|..##",  //
                                   "##..|....|..##",  //
                                   "####|####|####"});
  ExpectSound(plan);
  EXPECT_EQ(CountsOf(plan), "2 IB, 1 IC");
}

// Figure 5d.
TEST(MakePlanTest, FindsTypeDWhereAPartTouchesTwoSides) {
  const Plan plan = PlanOf(Picture{"##..",  //
                                   "#..#",  //
                                   "..##",  //
                                   ".###"});
  ExpectSound(plan);
  EXPECT_EQ(CountsOf(plan), "1 IID");
}

TEST(MakePlanTest, FindsTypeDWhereAPartTouchesOneSide) {
  const Plan plan = PlanOf(Picture{"#....",  //
                                   "#..##",  //
                                   "#..##",  //
                                   "#....",  //
                                   "#...."},
                           5);
  ExpectSound(plan);
  EXPECT_EQ(CountsOf(plan), "1 IID");
}

TEST(MakePlanTest, CountsTwoOpenHolesOfOneCellSeparately) {
  const Plan plan = PlanOf(Picture{"####",  //
                                   ".##.",  //
                                   "####",  //
                                   "####"});
  ExpectSound(plan);
  EXPECT_EQ(CountsOf(plan), "2 IIB");
  EXPECT_EQ(plan.clusters, 2);
}

// Figure 6: two clusters, one of them with a second layer.
TEST(MakePlanTest, PutsOpenHolesThatShareAGridBoundaryIntoOneCluster) {
  const Plan plan = PlanOf(Picture{"####|####|####",  //
                                   "#...|...#|##..",  //
                                   "#...|...#|##..",  //
                                   "####|####|####"});
  ExpectSound(plan);
  ASSERT_EQ(CountsOf(plan), "2 IB, 1 IIB");
  EXPECT_EQ(plan.clusters, 2);
  EXPECT_EQ(plan.holes[0].cluster, plan.holes[1].cluster);
  EXPECT_NE(plan.holes[0].cluster, plan.holes[2].cluster);
}

// A lake over 5 x 5 cells with a beach of two squares all round.
SurveyedScene BigLake() {
  const std::string beach(20, '#'), lake = "##" + std::string(16, '.') + "##";
  Picture picture(20, lake);
  picture[0] = picture[1] = picture[18] = picture[19] = beach;
  return PictureScene(picture, 4);
}

TEST(MakePlanTest, NumbersTheLayersOfALakeFromItsShoreInward) {
  const Plan plan = PlanOf(BigLake());
  ExpectSound(plan);
  ASSERT_EQ(CountsOf(plan), "9 IA, 16 IB");
  EXPECT_EQ(plan.clusters, 1);
  EXPECT_EQ(plan.layers, 3);
  for (const PlannedHole& hole : plan.holes) {
    const auto [col, row] = std::pair(hole.cell.col, hole.cell.row);
    EXPECT_EQ(hole.layer, 1 + std::min({col, row, 4 - col, 4 - row})) << ToString(hole.cell);
  }
}

// The cell in the middle has no surface but an island, which its layer's heights can begin at.
TEST(MakePlanTest, CountsAHoleWithAnIslandToTheFirstLayer) {
  const std::string beach(18, '#'), lake = "##" + std::string(14, '.') + "##";
  Picture picture(18, lake);
  picture[0] = picture[1] = picture[16] = picture[17] = beach;
  EXPECT_EQ(PlanOf(PictureScene(picture, 6)).layers, 2);
  for (const int row : {8, 9}) picture[row].replace(8, 2, "##");
  const Plan plan = PlanOf(PictureScene(picture, 6));
  ExpectSound(plan);
  EXPECT_EQ(plan.clusters, 1);
  EXPECT_EQ(plan.layers, 1);
}

TEST(MakePlanTest, CountsAnIslandsShoreToTheBoundaryOfAClosedHole) {
  const Plan plan = PlanOf(Picture{"#######",  //
                                   "#.....#",  //
                                   "#.....#",  //
                                   "#..#..#",  //
                                   "#.....#",  //
                                   "#.....#",  //
                                   "#######"},
                           7);
  ExpectSound(plan);
  ASSERT_EQ(CountsOf(plan), "1 closed");
  EXPECT_THAT(plan.holes[0].segments, SizeIs(20 + 4));
  EXPECT_DOUBLE_EQ(plan.holes[0].area, 24);
  EXPECT_EQ(plan.holes[0].single, SingleType::kIsland);
}

TEST(MakePlanTest, CallsAClosedHoleAroundABigIslandAnnular) {
  const Plan plan = PlanOf(Picture{"#######",  //
                                   "#.....#",  //
                                   "#.###.#",  //
                                   "#.###.#",  //
                                   "#.###.#",  //
                                   "#.....#",  //
                                   "#######"},
                           7);
  ExpectSound(plan);
  ASSERT_EQ(CountsOf(plan), "1 closed");
  EXPECT_EQ(plan.holes[0].single, SingleType::kAnnular);
}

TEST(MakePlanTest, CountsAnIslandsShoreToTheBoundaryOfAnOpenHole) {
  const Plan plan = PlanOf(Picture{"######|######",  //
                                   "#.....|..####",  //
                                   "#.....|..####",  //
                                   "#..#..|..####",  //
                                   "#.....|..####",  //
                                   "######|######"},
                           6);
  ExpectSound(plan);
  ASSERT_EQ(CountsOf(plan), "2 IB");
  EXPECT_DOUBLE_EQ(plan.holes[0].area, 19);
  EXPECT_DOUBLE_EQ(BoundedArea(plan, plan.holes[0]), 19);
}

TEST(MakePlanTest, SplitsAContinuousHoleWhereItTouchesItself) {
  const Plan plan = PlanOf(Picture{"####",  //
                                   "#.##",  //
                                   "##.#",  //
                                   "####"});
  ExpectSound(plan);
  EXPECT_EQ(CountsOf(plan), "2 closed");
  EXPECT_EQ(plan.continuous, 1);
}

// Over the ground stands a facade with a hole, and in the hole a piece of the facade; another piece stands off it.
TEST(MakePlanTest, CountsAnIslandOfAFacadeToTheHoleThatItLiesIn) {
  TriMesh mesh = PictureMesh(Picture(12, std::string(12, '#')));
  const auto add = [&](const Picture& picture, const Point3& corner) {
    const TriMesh part = PictureMesh(picture);
    for (Triangle t : part.triangles) {
      for (int32_t& v : t) v += static_cast<int32_t>(mesh.points.size());
      mesh.triangles.push_back(t);
    }
    for (const Point3& p : part.points) mesh.points.push_back(corner + Point3(p.x(), 0, p.y()));
  };
  add({"#######",  //
       "#.....#",  //
       "#.....#",  //
       "#..#..#",  //
       "#.....#",  //
       "#.....#",  //
       "#######"},
      Point3(2, 5, 3));
  add({"#"}, Point3(5, 7, 6));
  Grid grid;
  grid.cell_size = Point2(12, 12);
  const Plan plan = PlanOf(SurveyScene(grid, {{{0, 0}, mesh}}));
  ASSERT_EQ(CountsOf(plan), "1 closed");
  EXPECT_THAT(plan.holes[0].segments, SizeIs(20 + 4));
  EXPECT_DOUBLE_EQ(plan.holes[0].area, 24);
  EXPECT_EQ(plan.outer_rims, 2) << "of the facade and the piece off it";
}

TEST(MakePlanTest, LeavesTheOutlineOfADetachedPieceAndSaysSo) {
  TriMesh mesh = PictureMesh({"####", "####", "####", "####"});
  TriMesh roof = PictureMesh({"##"}, [](double, double) { return 30; });
  for (Triangle t : roof.triangles) {
    for (int32_t& v : t) v += static_cast<int32_t>(mesh.points.size());
    mesh.triangles.push_back(t);
  }
  for (const Point3& p : roof.points) mesh.points.push_back(p + Point3(1, 1, 0));
  Grid grid;
  grid.cell_size = Point2(4, 4);
  const Plan plan = PlanOf(SurveyScene(grid, {{{0, 0}, mesh}}));
  EXPECT_EQ(CountsOf(plan), "none");
  EXPECT_EQ(plan.outer_rims, 1);
  ASSERT_THAT(plan.left, SizeIs(1));
  EXPECT_EQ(plan.left[0].edges, 6);
}

TEST(MakePlanTest, LeavesHolesAtTheRimOfAnUnknownAreaOpenAndSaysSo) {
  SurveyedScene scene = PictureScene({"########",  //
                                      "########",  //
                                      "####....",  //
                                      "####....",  //
                                      "##.#####",  //
                                      "########",  //
                                      "########",  //
                                      "########"},
                                     8);
  scene.area_known = false;
  const Plan plan = PlanOf(scene);
  EXPECT_EQ(CountsOf(plan), "1 closed");
  ASSERT_THAT(plan.left, SizeIs(1));
  EXPECT_EQ(plan.left[0].cell, (CellId{0, 0}));
}

// Four squares of 0.1 mm in the corners of each of two cells of 1,000 km.
SurveyedScene FineMeshInLargeCells() {
  constexpr double kCell = 1e6, kEdge = 1e-4;
  std::map<CellId, TriMesh> tiles;
  for (const int32_t col : {0, 1}) {
    TriMesh& mesh = tiles[{col, 0}];
    for (const double x : {col * kCell, (col + 1) * kCell - kEdge}) {
      for (const double y : {0.0, kCell - kEdge}) {
        const auto first = static_cast<int32_t>(mesh.points.size());
        for (const auto& [i, j] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
          mesh.points.emplace_back(x + i * kEdge, y + j * kEdge, 0);
        }
        mesh.triangles.push_back({first, first + 1, first + 2});
        mesh.triangles.push_back({first, first + 2, first + 3});
      }
    }
  }
  Grid grid;
  grid.cell_size = Point2(kCell, kCell);
  return SurveyScene(grid, std::move(tiles));
}

TEST(MakePlanTest, LeavesHolesWhoseSeamsWouldHaveTooManyVertices) {
  const SurveyedScene scene = FineMeshInLargeCells();
  const Plan plan = MakePlan(scene.Input(), {});
  EXPECT_LT(plan.vertices.size(), 2'000'000U);
  ASSERT_THAT(plan.holes, Not(IsEmpty()));
  for (const PlannedHole& hole : plan.holes) EXPECT_THAT(hole.failure, HasSubstr("too fine for cells of this size"));
}

}  // namespace
}  // namespace tilemend
