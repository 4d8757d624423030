#include "coordinator/plan/overlap/strip_edges.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <vector>

namespace tilemend {
namespace {

using ::testing::Contains;
using ::testing::IsEmpty;
using ::testing::IsSubsetOf;

constexpr double kMargin = 0.25;

using Place = std::array<double, 2>;

// Two cells of 10 m side by side whose tiles reach 0.25 m beyond their squares, and a hole in each across the border
// from y = 2 to y = 8, with new vertices every 2 m.
class StripEdgesTest : public ::testing::Test {
 protected:
  StripEdgesTest() {
    plan_.lattice_step = 1.0 / 1024;
    AddCell({0, 0});
    AddCell({1, 0});
    for (int k = 0; k < 4; ++k) {
      on_line_[k] = AddVertex({10, 2.0 + 2 * k, 0}, -1, -1);
      plan_.vertices[on_line_[k]].lines = 1;
    }
    AddHole({0, 0}, 10 + kMargin, 5);
    AddHole({1, 0}, 10 - kMargin, 15);
  }

  void AddCell(CellId cell) {
    for (const Side side : kSides) {
      const int number = (AxisOf(side) == 0 ? cell.col : cell.row) + (OutwardOf(side) > 0 ? 1 : 0);
      outlines_.coordinate[cell][side] = 10 * number + OutwardOf(side) * kMargin;
    }
  }

  int32_t AddVertex(const Point3& position, int32_t index, int32_t follows) {
    PlanVertex v;
    v.position = position;
    v.index = index;
    v.follows = follows;
    v.size = 2;
    plan_.vertices.push_back(v);
    return static_cast<int32_t>(plan_.vertices.size()) - 1;
  }

  // From a tip of rim at `tip` along the outline at x = `outline` and back.
  void AddHole(CellId cell, double outline, double tip) {
    std::vector<int32_t> ring = {AddVertex({tip, 5, 1}, 0, -1)};
    for (int k = 0; k < 4; ++k) {
      ring.push_back(AddVertex({outline, 2.0 + 2 * k, 0}, -1, on_line_[k]));
      plan_.vertices.back().lines = 1;
    }
    if (cell.col == 1) std::reverse(ring.begin() + 1, ring.end());
    PlannedHole hole;
    hole.cell = cell;
    std::vector<RimSegment>& region = hole.own_regions.emplace_back();
    for (size_t i = 0; i < ring.size(); ++i) {
      region.push_back({ring[i], ring[(i + 1) % ring.size()], i > 0 && i + 1 < ring.size()});
    }
    plan_.holes.push_back(hole);
  }

  Place PlaceOf(int32_t v) const { return {plan_.vertices[v].position.x(), plan_.vertices[v].position.y()}; }

  // Edges of a hole's patch in the strip: those inside and those of its outline.
  std::set<std::set<Place>> EdgesOf(const PlannedHole& hole) const {
    std::set<std::set<Place>> edges;
    for (const RimSegment& s : hole.inner_edges) edges.insert({PlaceOf(s.from), PlaceOf(s.to)});
    for (const RimSegment& s : hole.own_regions[0]) {
      if (s.seam) edges.insert({PlaceOf(s.from), PlaceOf(s.to)});
    }
    return edges;
  }

  GridLines outlines_;
  Plan plan_;
  std::array<int32_t, 4> on_line_{};
};

TEST_F(StripEdgesTest, BothTilesHaveBothOutlinesAndTheSameDiagonals) {
  LayStripEdges(outlines_, plan_);
  // The rim comes near the first and last vertex of each outline: those two have none across.
  const std::set<std::set<Place>> of_both = {{{9.75, 4}, {9.75, 6}}, {{10.25, 4}, {10.25, 6}}, {{9.75, 4}, {10.25, 6}}};
  EXPECT_THAT(of_both, IsSubsetOf(EdgesOf(plan_.holes[0])));
  EXPECT_THAT(of_both, IsSubsetOf(EdgesOf(plan_.holes[1])));
}

TEST_F(StripEdgesTest, TheyFollowTheGridLine) {
  LayStripEdges(outlines_, plan_);
  for (const RimSegment& s : plan_.holes[0].inner_edges) {
    for (const int32_t v : {s.from, s.to}) {
      const PlanVertex& vertex = plan_.vertices[v];
      ASSERT_GE(vertex.follows, 0);
      EXPECT_EQ(vertex.position.y(), plan_.vertices[vertex.follows].position.y());
    }
  }
}

TEST_F(StripEdgesTest, TheyKeepClearOfTheRim) {
  plan_.vertices[plan_.holes[0].own_regions[0][0].from].position = Point3(9.875, 5, 1);
  LayStripEdges(outlines_, plan_);
  EXPECT_THAT(plan_.holes[0].inner_edges, IsEmpty());
}

TEST_F(StripEdgesTest, WaterHasNone) {
  plan_.holes[0].water = plan_.holes[1].water = 0;
  LayStripEdges(outlines_, plan_);
  EXPECT_THAT(plan_.holes[0].inner_edges, IsEmpty());
  EXPECT_THAT(plan_.holes[1].inner_edges, IsEmpty());
}

TEST_F(StripEdgesTest, TilesThatDoNotOverlapHaveNone) {
  outlines_.coordinate[{1, 0}][kWest] = 10 + kMargin;
  LayStripEdges(outlines_, plan_);
  EXPECT_THAT(plan_.holes[0].inner_edges, IsEmpty());
}

// The rim runs through the strip between a neighbour's vertex and the tile's outline.
TEST_F(StripEdgesTest, TheyReachBehindATipOfTheRim) {
  std::vector<RimSegment>& region = plan_.holes[0].own_regions[0];
  const int32_t before = AddVertex({10, 4.9, 0}, 1, -1), tip = AddVertex({10, 5.1, 0}, 2, -1);
  const int32_t a = AddVertex({10.25, 4.9, 0}, 3, -1), b = AddVertex({10.25, 5.1, 0}, 4, -1);
  const auto middle = std::find_if(region.begin(), region.end(), [&](const RimSegment& s) {
    return PlaceOf(s.from) == Place{10.25, 4} && PlaceOf(s.to) == Place{10.25, 6};
  });
  const int32_t end = middle->to;
  *middle = {middle->from, a, true};
  region.insert(region.end(), {{a, before, false}, {before, tip, false}, {tip, b, false}, {b, end, true}});
  for (PlanVertex& v : plan_.vertices) v.size = 0.5;
  const int32_t behind = AddVertex({9.75, 5, 0}, -1, on_line_[1]);
  plan_.vertices[behind].size = 0.5;
  for (std::vector<RimSegment>& other : plan_.holes[1].own_regions) {
    const auto whole = std::find_if(other.begin(), other.end(), [&](const RimSegment& s) {
      return PlaceOf(s.from) == Place{9.75, 6} && PlaceOf(s.to) == Place{9.75, 4};
    });
    const RimSegment rest{behind, whole->to, true};
    whole->to = behind;
    other.insert(std::next(whole), rest);
  }
  LayStripEdges(outlines_, plan_);
  const std::set<std::set<Place>> behind_it = {{{9.75, 4}, {9.75, 5}}, {{9.75, 5}, {9.75, 6}}};
  EXPECT_THAT(behind_it, IsSubsetOf(EdgesOf(plan_.holes[0])));
}

// Two holes of the eastern tile run along the same outline, one with a vertex where the other has none.
// The outline of one ends at y = 7.2, that of the other at a vertex of its rim at y = 8.
TEST_F(StripEdgesTest, TheLastTrianglesBeforeTheRimAreTheSame) {
  std::vector<RimSegment>&west = plan_.holes[0].own_regions[0], &east = plan_.holes[1].own_regions[0];
  plan_.vertices[west.front().from].position = Point3(8, 20, 0);
  plan_.vertices[east.front().from].position = Point3(12, 20, 0);
  PlanVertex& rim = plan_.vertices[east.front().to];
  ASSERT_EQ(rim.position, Point3(9.75, 8, 0));
  rim.index = 7;
  PlanVertex& lower = plan_.vertices[west.back().from];
  ASSERT_EQ(lower.position, Point3(10.25, 8, 0));
  lower.position.y() = 7.2;
  const int32_t low_west = AddVertex({5, 1, 0}, 1, -1), low_east = AddVertex({15, 1, 0}, 1, -1);
  west.push_back({low_west, west.front().to, false});
  west.front().to = low_west;
  east.push_back({low_east, east.back().to, false});
  east[east.size() - 2].to = low_east;

  LayStripEdges(outlines_, plan_);
  const std::set<std::set<Place>> of_both = {
      {{9.75, 6}, {9.75, 8}}, {{10.25, 6}, {10.25, 7.2}}, {{9.75, 6}, {10.25, 7.2}}, {{9.75, 8}, {10.25, 7.2}}};
  EXPECT_THAT(of_both, IsSubsetOf(EdgesOf(plan_.holes[0])));
  EXPECT_THAT(of_both, IsSubsetOf(EdgesOf(plan_.holes[1])));
  for (const PlannedHole& hole : plan_.holes) {
    for (const RimSegment& s : hole.inner_edges) {
      const bool twice = std::any_of(hole.own_regions[0].begin(), hole.own_regions[0].end(), [&](const RimSegment& o) {
        return std::minmax(o.from, o.to) == std::minmax(s.from, s.to);
      });
      EXPECT_FALSE(twice) << "the outline itself";
    }
  }
}

TEST_F(StripEdgesTest, NoEdgeIsGivenTwice) {
  PlannedHole other;
  other.cell = {1, 0};
  const int32_t north = AddVertex({9.75, 6, 0}, -1, on_line_[2]), middle = AddVertex({9.75, 5, 0}, -1, on_line_[1]);
  const int32_t south = AddVertex({9.75, 4, 0}, -1, on_line_[1]), tip = AddVertex({15, 5, 0}, 9, -1);
  other.own_regions = {{{tip, north, false}, {north, middle, true}, {middle, south, true}, {south, tip, false}}};
  plan_.holes.push_back(other);
  LayStripEdges(outlines_, plan_);
  const std::vector<RimSegment>& edges = plan_.holes[0].inner_edges;
  std::set<std::set<Place>> places;
  for (const RimSegment& s : edges) places.insert({PlaceOf(s.from), PlaceOf(s.to)});
  EXPECT_THAT(places, Contains(std::set<Place>{{9.75, 4}, {9.75, 5}}));
  EXPECT_EQ(places.size(), edges.size());
}

// Four tiles: beside its own corner each has the points where the outlines of the others cross its own.
TEST_F(StripEdgesTest, OutlinesCrossAtCorners) {
  AddCell({0, 1});
  AddCell({1, 1});
  const int32_t source = AddVertex({10, 10, 0}, -1, -1);
  plan_.vertices[source].lines = 3;
  const int32_t east = AddVertex({10.25, 8, 0}, -1, on_line_[3]), north = AddVertex({8, 10.25, 0}, -1, on_line_[3]);
  plan_.vertices[east].lines = 1;
  plan_.vertices[north].lines = 2;
  const int32_t corner = AddVertex({10.25, 10.25, 0}, -1, source), tip = AddVertex({5, 5, 0}, 0, -1);
  plan_.vertices[corner].lines = 3;
  plan_.holes[0].own_regions = {{{tip, east, false}, {east, corner, true}, {corner, north, true}, {north, tip, false}}};
  LayStripEdges(outlines_, plan_);
  std::set<Place> around;
  for (const PlanVertex& v : plan_.vertices) {
    if (v.follows == source) around.insert({v.position.x(), v.position.y()});
  }
  EXPECT_EQ(around, (std::set<Place>{{9.75, 10.25}, {10.25, 9.75}, {10.25, 10.25}}));
}

// The western outlines of both eastern tiles are a hair apart: the crossing lies on both.
TEST_F(StripEdgesTest, EdgesReachACrossingThatIsAHairOff) {
  AddCell({0, 1});
  AddCell({1, 1});
  outlines_.coordinate[{1, 1}][kWest] += 1e-5;
  const int32_t source = AddVertex({10, 10, 0}, -1, -1);
  plan_.vertices[source].lines = 3;
  const auto region = [&](double tip, const std::vector<Point2>& along) {
    std::vector<int32_t> ring = {AddVertex({5, tip, 0}, 0, -1)};
    for (const Point2& p : along) {
      const bool corner = &p == &along[1];
      ring.push_back(AddVertex({p.x(), p.y(), 0}, -1, corner ? source : on_line_[3]));
      plan_.vertices.back().lines = corner ? 3 : 1;
    }
    std::vector<RimSegment> segments;
    for (size_t i = 0; i < 4; ++i) segments.push_back({ring[i], ring[(i + 1) % 4], i == 1 || i == 2});
    return segments;
  };
  plan_.holes[0].own_regions = {region(5, {{10.25, 7}, {10.25, 10.25}, {8, 10.25}})};
  PlannedHole north;
  north.cell = {0, 1};
  north.own_regions = {region(15, {{7, 9.75}, {10.25, 9.75}, {10.25, 13}})};
  plan_.holes.push_back(north);
  LayStripEdges(outlines_, plan_);
  const std::set<Place> to_crossing = {{8, 10.25}, {9.75, 10.25}};
  EXPECT_THAT(EdgesOf(plan_.holes[2]), Contains(to_crossing));
}

// Beside a corner the outline of the eastern tile has no vertex where that of the northern one crosses it.
TEST_F(StripEdgesTest, EdgesEndWhereAnotherNeighboursVertexLiesOnThem) {
  AddCell({0, 1});
  AddCell({1, 1});
  const int32_t source = AddVertex({10, 10, 0}, -1, -1);
  plan_.vertices[source].lines = 3;
  const auto outline = [&](double x, double y, uint8_t lines) {
    const int32_t v = AddVertex({x, y, 0}, -1, lines == 3 ? source : on_line_[3]);
    plan_.vertices[v].lines = lines;
    return v;
  };
  const auto region = [&](const std::vector<int32_t>& along) {
    const int32_t tip = AddVertex({5, 5, 0}, 0, -1);
    std::vector<RimSegment> segments = {{tip, along.front(), false}};
    for (size_t i = 0; i + 1 < along.size(); ++i) segments.push_back({along[i], along[i + 1], true});
    segments.push_back({along.back(), tip, false});
    return segments;
  };
  plan_.holes[0].own_regions = {region({outline(10.25, 7, 1), outline(10.25, 10.25, 3), outline(7, 10.25, 2)})};
  plan_.holes[1].own_regions = {region({outline(9.75, 10.25, 1), outline(9.75, 8, 1)})};
  PlannedHole north;
  north.cell = {0, 1};
  north.own_regions = {region({outline(8, 9.75, 2), outline(9.75, 9.75, 2)})};
  plan_.holes.push_back(north);
  LayStripEdges(outlines_, plan_);
  const std::set<std::set<Place>> edges = EdgesOf(plan_.holes[0]);
  EXPECT_THAT(edges, Contains(std::set<Place>{{9.75, 8}, {9.75, 9.75}}));
  EXPECT_THAT(edges, Contains(std::set<Place>{{9.75, 9.75}, {9.75, 10.25}}));
  EXPECT_EQ(edges.count({{9.75, 8}, {9.75, 10.25}}), 0U);
}

}  // namespace
}  // namespace tilemend
