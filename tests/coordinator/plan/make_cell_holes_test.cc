#include "coordinator/plan/make_cell_holes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/support/surveyed_scene.h"

namespace tilemend {
namespace {

// A hole over two cells, and a closed one in the eastern cell.
const std::vector<std::string> kPicture = {"######|######", "###...|..####", "###...|..####",  //
                                           "######|######", "######|##.###", "######|######"};

struct Planned {
  Planned() : scene(PictureScene(kPicture, 6)), input(scene.Input()), plan(MakePlan(input, {})) {}

  CellHoles Make(const std::vector<int32_t>& holes, bool with_band = true) const {
    return MakeCellHoles(plan, input, heights, holes, with_band);
  }

  SurveyedScene scene;
  PlanInput input;
  Plan plan;
  SeamHeights heights;
};

int32_t FirstOpenIn(const Plan& plan, CellId cell) {
  const auto hole = std::find_if(plan.holes.begin(), plan.holes.end(),
                                 [&](const PlannedHole& h) { return h.cell == cell && h.kind != HoleKind::kClosed; });
  return static_cast<int32_t>(hole - plan.holes.begin());
}

int32_t FirstClosed(const Plan& plan) {
  const auto hole = std::find_if(plan.holes.begin(), plan.holes.end(),
                                 [](const PlannedHole& h) { return h.kind == HoleKind::kClosed; });
  return static_cast<int32_t>(hole - plan.holes.begin());
}

TEST(MakeCellHolesTest, HandsTheOwnVertexOutWhereATileHasOneToo) {
  const SurveyedScene scene = PictureScene({"##|##",  //
                                            "##|.#"},
                                           2);
  const Plan plan = MakePlan(scene.Input(), {});
  ASSERT_EQ(CountsOf(plan), "1 IIB");
  const CellHoles work = MakeCellHoles(plan, scene.Input(), {}, {0}, true);
  int own = 0, foreign = 0;
  for (const RimVertex& v : work.vertices) {
    if (v.index < 0) continue;
    EXPECT_EQ(scene.tiles.at(v.tile).points.at(v.index), v.position);
    ++(v.tile == CellId{1, 0} ? own : foreign);
  }
  EXPECT_EQ(own, 3) << "the corners of the hole that the cell's own tile has";
  EXPECT_EQ(foreign, 1) << "the corner on the rim of the area is the west tile's alone";
}

TEST(MakeCellHolesTest, KeepsTheBoundaryOfThePlan) {
  const Planned p;
  const int32_t h = FirstOpenIn(p.plan, {0, 0});
  const CellHoles made = p.Make({h});
  ASSERT_EQ(made.holes.size(), 1U);
  const CellHole& hole = made.holes[0];
  EXPECT_EQ(hole.id, h);
  EXPECT_TRUE(hole.open);
  ASSERT_EQ(hole.segments.size(), p.plan.holes[h].segments.size());
  for (size_t k = 0; k < hole.segments.size(); ++k) {
    const RimSegment& planned = p.plan.holes[h].segments[k];
    EXPECT_EQ(made.vertices[hole.segments[k].from].position, p.plan.vertices[planned.from].position);
    EXPECT_EQ(made.vertices[hole.segments[k].to].position, p.plan.vertices[planned.to].position);
    EXPECT_EQ(hole.segments[k].seam, planned.seam);
  }
}

TEST(MakeCellHolesTest, GivesSeamVerticesTheHeightsThatAreKnown) {
  Planned p;
  const int32_t h = FirstOpenIn(p.plan, {0, 0});
  for (const RimVertex& v : p.Make({h}).vertices) EXPECT_EQ(v.height_known, v.index >= 0);
  for (size_t v = 0; v < p.plan.vertices.size(); ++v) {
    p.heights.height[static_cast<int32_t>(v)] = 7.5;
    p.heights.laplacian[{p.plan.holes[h].cluster, static_cast<int32_t>(v)}] = 0.25;
  }
  p.heights.tension[p.plan.holes[h].cluster] = 0.125;
  const CellHoles made = p.Make({h});
  EXPECT_EQ(made.holes[0].tension, 0.125);
  int on_seam = 0;
  for (const RimVertex& v : made.vertices) {
    EXPECT_TRUE(v.height_known);
    EXPECT_TRUE(v.index >= 0 || v.position.z() == 7.5);
    EXPECT_EQ(v.laplacian_known, v.seam_vertex >= 0);
    on_seam += v.seam_vertex >= 0;
  }
  EXPECT_GE(on_seam, 2);
}

// Beside a seam vertex, and beside a rim vertex on an object, where only the ground below it counts.
TEST(MakeCellHolesTest, GoesOnWithTheSlopeOfTheSurfaceOffTheGridLine) {
  Planned p;
  const int32_t h = FirstOpenIn(p.plan, {0, 0});
  PlannedHole& hole = p.plan.holes[h];
  const auto is_new = [&](const RimSegment& s) { return p.plan.vertices[s.from].index < 0; };
  const int32_t source = std::find_if(hole.segments.begin(), hole.segments.end(), is_new)->from;
  PlanVertex beside = p.plan.vertices[source];
  beside.follows = source;
  beside.position += Point3(2, 1, 0);
  p.plan.vertices.push_back(beside);
  const auto number = static_cast<int32_t>(p.plan.vertices.size()) - 1;
  hole.own_regions = {{{number, source, true}, {source, number, true}}};
  const auto height = [&] { return MakeFillHoles(p.plan, p.input, p.heights, {h}).vertices[0].position.z(); };
  p.heights.height[source] = 5;
  EXPECT_EQ(height(), 5);
  p.heights.slope[source] = {{0.25, -2}, hole.cluster};
  EXPECT_EQ(height(), 5 + 0.5 - 2);
  p.heights.ground[{hole.cluster + 1, source}] = {9, {1, 1}};
  EXPECT_EQ(height(), 5 + 0.5 - 2);
  p.heights.ground[{hole.cluster, source}] = {8, {0.5, -1}};
  EXPECT_EQ(height(), 8 + 1 - 1);
}

// Half an edge off the grid line and more the surface of the cluster is asked for.
TEST(MakeCellHolesTest, AsksForTheSurfaceFarOffTheGridLine) {
  Planned p;
  const int32_t h = FirstOpenIn(p.plan, {0, 0});
  PlannedHole& hole = p.plan.holes[h];
  const auto is_new = [&](const RimSegment& s) { return p.plan.vertices[s.from].index < 0; };
  const int32_t source = std::find_if(hole.segments.begin(), hole.segments.end(), is_new)->from;
  const double edge = p.plan.vertices[source].size;
  std::vector<int32_t> beside;
  for (const double off : {0.4, 0.6, 0.7}) {
    beside.push_back(static_cast<int32_t>(p.plan.vertices.size()));
    PlanVertex v = p.plan.vertices[source];
    v.follows = source;
    v.position += Point3(off * edge, 0, 0);
    v.on_neighbour = beside.size() == 3;  // there at the line; farther off it may have a hole
    p.plan.vertices.push_back(v);
  }
  hole.own_regions = {{{beside[0], beside[1], true}, {beside[1], beside[2], true}, {beside[2], beside[0], true}}};
  const CellHoles cluster = p.Make({h});
  std::set<int32_t> asked;
  for (const RimVertex& v : cluster.vertices) asked.insert(v.seam_vertex);
  EXPECT_FALSE(asked.contains(beside[0]));
  EXPECT_TRUE(asked.contains(beside[1]));
  EXPECT_TRUE(asked.contains(beside[2]));

  p.heights.height = {{source, 5}, {beside[1], 7}};
  p.heights.laplacian = {{{hole.cluster, source}, 1}, {{hole.cluster, beside[1]}, 2}};
  const std::vector<RimVertex> filled = MakeFillHoles(p.plan, p.input, p.heights, {h}).vertices;
  EXPECT_EQ(filled[0].position.z(), 5);
  EXPECT_EQ(filled[1].position.z(), 7);
  EXPECT_EQ(filled[0].laplacian, 1);
  EXPECT_EQ(filled[1].laplacian, 2);
  EXPECT_EQ(filled[1].follows, -1) << "it goes with no other vertex";
}

// The surface of ground with walls need not meet the rim. Where two clusters touch, neither tells the other its height.
TEST(MakeCellHolesTest, TellsWhereGroundWithWallsPasses) {
  Planned p;
  const int32_t h = FirstOpenIn(p.plan, {0, 0});
  const int32_t cluster = p.plan.holes[h].cluster;
  const auto is_rim = [&](const RimSegment& s) { return p.plan.vertices[s.from].index >= 0; };
  const int32_t foot = std::ranges::find_if(p.plan.holes[h].segments, is_rim)->from;
  const auto ground = [&](const std::vector<int32_t>& holes) {
    const CellHoles made = p.Make(holes);
    const auto at_foot = [&](const RimVertex& v) { return v.position == p.plan.vertices[foot].position; };
    return std::ranges::find_if(made.vertices, at_foot)->ground;
  };
  p.heights.ground[{cluster, foot}] = {2.5, {0, 0}};
  EXPECT_FALSE(ground({h}).has_value()) << "a plate meets it";
  p.heights.walls[cluster] = {{0, 0.5}, 0.125};
  EXPECT_EQ(ground({h}), 2.5);
  EXPECT_EQ(p.Make({h}).holes[0].walls.slope, Point2(0, 0.5));

  PlannedHole touching = p.plan.holes[h];
  touching.cluster = cluster + 1;
  p.plan.holes.push_back(touching);
  const auto other = static_cast<int32_t>(p.plan.holes.size()) - 1;
  EXPECT_FALSE(ground({h, other}).has_value());
  EXPECT_FALSE(ground({other, h}).has_value());
}

TEST(MakeCellHolesTest, AsksForTheRimOfAClusterBetweenObjects) {
  Planned p;
  const int32_t h = FirstOpenIn(p.plan, {0, 0});
  const auto asked = [&] {
    const CellHoles made = p.Make({h});
    return std::ranges::count_if(made.vertices, [](const RimVertex& v) { return v.seam_vertex >= 0; });
  };
  const auto on_seam = asked();
  p.plan.vertices[p.plan.holes[h].segments[0].from].on_object = true;
  EXPECT_EQ(asked(), static_cast<int64_t>(p.Make({h}).vertices.size()));
  EXPECT_GT(asked(), on_seam);
}

// Where a neighbour's object ends over the outline, the wall goes up to it, and its foot has the surface.
TEST(MakeCellHolesTest, ReachesUpToTheNeighboursObject) {
  Planned p;
  const int32_t h = FirstOpenIn(p.plan, {0, 0});
  PlannedHole& hole = p.plan.holes[h];
  const int32_t source = hole.segments.front().from;
  p.plan.vertices[source].position.z() = 12;
  p.plan.vertices[source].ground = 3.0F;
  PlanVertex beside = p.plan.vertices[source];
  beside.index = -1;
  beside.follows = source;
  beside.on_neighbour = beside.on_object = true;
  beside.ground.reset();
  p.plan.vertices.push_back(beside);
  const auto number = static_cast<int32_t>(p.plan.vertices.size()) - 1;
  hole.own_regions = {{{number, source, true}, {source, number, true}}};
  p.heights.height[number] = 2;  // of level water
  const auto vertex = [&] { return MakeFillHoles(p.plan, p.input, p.heights, {h}).vertices[0]; };
  EXPECT_EQ(vertex().position.z(), 12);
  EXPECT_EQ(vertex().ground, 3);
  p.heights.ground[{hole.cluster, source}] = {2.5, {0, 0}};
  EXPECT_EQ(vertex().ground, 2.5);
}

TEST(MakeCellHolesTest, TakesTheBandAroundTheHolesFromAllTilesThere) {
  const Planned p;
  const int32_t h = FirstOpenIn(p.plan, {0, 0});
  const CellHoles with = p.Make({h}), without = p.Make({h}, false);
  EXPECT_TRUE(without.band.triangles.empty());
  ASSERT_FALSE(with.band.triangles.empty());
  for (size_t v = 0; v < with.vertices.size(); ++v) EXPECT_EQ(with.band.points[v], with.vertices[v].position);
  std::set<double> sides;  // of the grid line x = 6
  for (const Triangle& t : with.band.triangles) {
    bool at_rim = false;
    for (const int32_t v : t) at_rim |= v < std::ssize(with.vertices);
    EXPECT_TRUE(at_rim);
    sides.insert((with.band.points[t[0]] + with.band.points[t[1]] + with.band.points[t[2]]).x() / 3 < 6 ? -1 : 1);
  }
  EXPECT_EQ(sides.size(), 2U) << "triangles of both tiles";
}

TEST(MakeCellHolesTest, PutsSeveralHolesIntoOneNumbering) {
  const Planned p;
  const std::vector<int32_t> both = {FirstOpenIn(p.plan, {1, 0}), FirstClosed(p.plan)};
  const CellHoles made = p.Make(both);
  ASSERT_EQ(made.holes.size(), 2U);
  EXPECT_FALSE(made.holes[1].open);
  EXPECT_EQ(made.vertices.size(), p.Make({both[0]}).vertices.size() + p.Make({both[1]}).vertices.size());
}

// Where tiles overlap a closed hole may have a region of its own too.
TEST(MakeCellHolesTest, AClosedHoleIsOpenOnlyWhereItsRegionHasASeam) {
  Planned p;
  const int32_t h = FirstClosed(p.plan);
  p.plan.holes[h].own_regions = {p.plan.holes[h].segments};
  EXPECT_FALSE(MakeFillHoles(p.plan, p.input, p.heights, {h}, false).holes[0].open);
  p.plan.holes[h].own_regions[0][0].seam = true;
  EXPECT_TRUE(MakeFillHoles(p.plan, p.input, p.heights, {h}, false).holes[0].open);
}

TEST(MakeCellHolesTest, GivesACellWithoutATileTheNumberTypeOfTheScene) {
  SurveyedScene scene = PictureScene({"##|..|##", "##|..|##"}, 2);
  for (const bool float32 : {true, false}) {
    for (auto& [cell, record] : scene.records) record.float32 = float32;
    const PlanInput input = scene.Input();
    const Plan plan = MakePlan(input, {});
    ASSERT_EQ(plan.holes.size(), 1U);
    EXPECT_EQ(MakeCellHoles(plan, input, {}, {0}, false).float32, float32);
  }
}

TEST(MakeCellHolesTest, GivesWaterItsLevel) {
  Planned p;
  const int32_t h = FirstClosed(p.plan);
  EXPECT_FALSE(p.Make({h}).holes[0].level.has_value());
  p.plan.water.emplace_back();
  p.plan.water[0].level = 3.25;
  p.plan.holes[h].water = 0;
  EXPECT_EQ(p.Make({h}).holes[0].level, 3.25);
}

}  // namespace
}  // namespace tilemend
