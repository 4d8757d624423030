#include "coordinator/plan/seam/seam_vertices.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/support/rim_builders.h"
#include "tests/support/seam_scene.h"

namespace tilemend {
namespace {

constexpr double kStep = 0x1p-10;

// A round hole of `radius` metres about the middle of the border between two cells of 100 m, with `edges` edges.
struct RoundHole {
  RoundHole(double radius, int32_t edges) : area(AreaOf(2, 1)), lines(LinesOf(area, 100)) {
    Loop3 loop;
    for (int32_t k = 0; k < edges; ++k) {
      const double angle = -2 * std::numbers::pi * (k + 0.5) / edges;
      loop.emplace_back(100 + radius * std::cos(angle), 50 + radius * std::sin(angle), 0);
    }
    rim = RimOf({loop});
    from = Point2(100, 50 - radius);
    to = Point2(100, 50 + radius);
  }

  std::vector<SeamPlace> Place(const PlanOptions& options) const {
    const RimIndex index(rim);
    return PlaceSeamVertices({area, lines, rim, index, options, kStep}, {{0, 0}, {1, 0}}, from, to).value();
  }

  std::set<CellId> area;
  GridLines lines;
  Rim rim;
  Point2 from, to;
};

PlanOptions Uniform() {
  PlanOptions options;
  options.uniform = true;
  return options;
}

TEST(PlaceSeamVerticesTest, PlacesThemInOrderOnTheLineAndOnTheLattice) {
  const RoundHole hole(20, 64);
  const std::vector<SeamPlace> places = hole.Place({});
  ASSERT_GT(places.size(), 3U);
  double last = hole.from.y();
  for (const SeamPlace& place : places) {
    EXPECT_EQ(place.position.x(), 100);
    EXPECT_GT(place.position.y(), last);
    EXPECT_EQ(std::fmod(place.position.y(), kStep), 0);
    EXPECT_EQ(place.beside, -1);
    last = place.position.y();
  }
  EXPECT_LT(last, hole.to.y());
}

TEST(PlaceSeamVerticesTest, SpacesThemLikeTheRimInUniformMode) {
  const RoundHole hole(20, 64);
  const double edge = hole.rim.points[0].size;
  const std::vector<SeamPlace> places = hole.Place(Uniform());
  EXPECT_NEAR(static_cast<double>(places.size()), 40 / edge, 3);
  for (size_t i = 1; i < places.size(); ++i) {
    EXPECT_NEAR((places[i].position - places[i - 1].position).norm(), edge, 0.2 * edge);
  }
}

TEST(PlaceSeamVerticesTest, GrowsThemApartFromTheRimInward) {
  const RoundHole hole(40, 160);
  PlanOptions steep;
  steep.gradation = 1.6;
  const size_t uniform = hole.Place(Uniform()).size(), gentle = hole.Place({}).size(), few = hole.Place(steep).size();
  EXPECT_LT(gentle, uniform / 2);
  EXPECT_LT(few, gentle);
  PlanOptions limited;
  limited.size_limit = 1;
  EXPECT_GT(hole.Place(limited).size(), gentle);
}

TEST(PlaceSeamVerticesTest, BringsThemCloserToTheRimWhereTilesOverlap) {
  RoundHole hole(20, 16);
  const std::vector<SeamPlace> apart = hole.Place({});
  hole.lines.joined = true;
  const std::vector<SeamPlace> places = hole.Place({});
  const double edge = hole.rim.points[0].size;
  EXPECT_GT(apart.front().position.y() - hole.from.y(), 0.5 * edge);
  EXPECT_LT(places.front().position.y() - hole.from.y(), 0.15 * edge);
  EXPECT_LT(places.size(), apart.size() + 16);
}

TEST(PlaceSeamVerticesTest, KeepsClearOfTheRim) {
  RoundHole hole(20, 64);
  const std::vector<SeamPlace> before = hole.Place(Uniform());
  // A small island a hair beside the middle of the line.
  const Rim with_island = RimOf({[&] {
                                   Loop3 loop;
                                   for (const RimPoint& p : hole.rim.points) loop.push_back(p.position);
                                   return loop;
                                 }(),
                                 {{100.1, 49, 0}, {102, 49, 0}, {102, 51, 0}, {100.1, 51, 0}}});
  hole.rim = with_island;
  const std::vector<SeamPlace> after = hole.Place(Uniform());
  EXPECT_LT(after.size(), before.size());
  for (const SeamPlace& place : after) {
    EXPECT_TRUE(place.position.y() < 49 || place.position.y() > 51) << place.position.y();
  }
}

TEST(PlaceSeamVerticesTest, PlacesOneBesideEachRimPointAHairOffTheRimOfTheArea) {
  SurveyedScene scene = PictureScene({"####..#..###", "############", "############", "############"}, 4);
  for (auto& [cell, tile] : scene.tiles) {
    for (Point3& p : tile.points) {
      if ((p.x() == 6 || p.x() == 7) && p.y() == 4) p.y() -= 1e-4;
    }
  }
  const SeamScene s(SurveyScene(scene.grid, std::move(scene.tiles)));
  const std::vector<SeamPlace> places = PlaceSeamVertices(s.Site(), {{1, 0}, {1, 1}}, {5, 4}, {8, 4}).value();
  std::vector<Point2> beside;
  for (const SeamPlace& place : places) {
    if (place.beside < 0) continue;
    beside.push_back(place.position);
    EXPECT_NEAR((s.rim.points[place.beside].position.head<2>() - place.position).norm(), 1e-4, 1e-9);
  }
  ASSERT_EQ(beside.size(), 2U);
  EXPECT_EQ(beside[0], Point2(6, 4));
  EXPECT_EQ(beside[1], Point2(7, 4));
}

TEST(PlaceSeamVerticesTest, DoesNotDependOnWhichWayTheLineRuns) {
  const RoundHole hole(20, 64);
  RoundHole turned = hole;
  turned.area = AreaOf(1, 2);
  turned.lines = LinesOf(turned.area, 100);
  for (RimPoint& p : turned.rim.points) p.position = Point3(p.position.y(), p.position.x(), 0);
  const RimIndex index(turned.rim);
  const PlanOptions options;
  const SeamSite site{turned.area, turned.lines, turned.rim, index, options, kStep};
  const std::vector<SeamPlace> places = PlaceSeamVertices(site, {{0, 0}, {0, 1}}, {30, 100}, {70, 100}).value();
  const std::vector<SeamPlace> upright = hole.Place({});
  ASSERT_EQ(places.size(), upright.size());
  for (size_t i = 0; i < places.size(); ++i) {
    EXPECT_NEAR(places[i].position.x(), upright[i].position.y(), 2 * kStep);
  }
}

TEST(PlaceSeamVerticesTest, EndsOnceItIsCancelled) {
  const RoundHole hole(20, 64);
  const RimIndex index(hole.rim);
  PlanOptions options;
  int asked = 0, last = std::numeric_limits<int>::max();
  options.is_cancelled = [&] { return asked++ >= last; };
  const SeamSite site{hole.area, hole.lines, hole.rim, index, options, kStep};
  const auto places = PlaceSeamVertices(site, {{0, 0}, {1, 0}}, hole.from, hole.to);
  ASSERT_TRUE(places);
  EXPECT_GT(asked, std::ssize(*places));
  const int all = asked;
  for (last = 0; last < all; last += 5) {
    asked = 0;
    EXPECT_FALSE(PlaceSeamVertices(site, {{0, 0}, {1, 0}}, hole.from, hole.to)) << last;
  }
  last = asked = 0;
  EXPECT_TRUE(SpacedBetween(site, hole.from, hole.to).empty());
}

TEST(PlaceSeamVerticesTest, RefusesMoreEdgesThanItMayLay) {
  const RoundHole hole(20, 64);
  const RimIndex index(hole.rim);
  const PlanOptions options;
  const SeamSite site{hole.area, hole.lines, hole.rim, index, options, kStep};
  const auto edges = static_cast<int64_t>(hole.Place({}).size()) + 1;
  EXPECT_TRUE(PlaceSeamVertices(site, {{0, 0}, {1, 0}}, hole.from, hole.to, edges + 1).has_value());
  EXPECT_FALSE(PlaceSeamVertices(site, {{0, 0}, {1, 0}}, hole.from, hole.to, edges - 1).has_value());
  const Point2 far(100, 1e9);
  EXPECT_FALSE(PlaceSeamVertices(site, {{0, 0}, {1, 0}}, hole.from, far).has_value());
  EXPECT_LE(std::ssize(SpacedBetween(site, hole.from, far)), kMostSeamEdges);
}

}  // namespace
}  // namespace tilemend
