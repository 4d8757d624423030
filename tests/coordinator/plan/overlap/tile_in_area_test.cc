#include "coordinator/plan/overlap/tile_in_area.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "coordinator/plan/rim/rim.h"
#include "tests/support/overlapping_scene.h"

namespace tilemend {
namespace {

constexpr double kMargin = 0.25;
constexpr std::array<double, 4> kBox = {-kMargin, 6 + kMargin, -kMargin, 6 + kMargin};

// A tile of 6 x 6 squares stretched beyond its cell, and what is inside of x < `east`.
struct Case {
  SurveyRecord record;
  TileInArea tile;
};

Case TakeWestOf(double east, const std::vector<std::string>& picture) {
  const SurveyRecord record = OverlappingScene(picture, 6, kMargin).records.begin()->second;
  const AreaOutside outside = OutsideIn({{{-9, -9}, {-9, 9}, {east, 9}, {east, -9}}}, kBox, 0x1p-10);
  return {record, TakeInArea(record, std::vector<bool>(record.edges.size(), true), outside)};
}

const std::vector<std::string> kRiver = {"######", "######", "......", "......", "######", "######"};

std::vector<BoundaryEdge> AlongArea(const Case& c) {
  std::vector<BoundaryEdge> along;
  for (const BoundaryEdge& e : c.tile.record.edges) {
    const Point3 &a = c.tile.record.vertices[e.from].position, &b = c.tile.record.vertices[e.to].position;
    const bool on_box = (a.x() == b.x() && std::abs(a.x() - 3) > 3) || (a.y() == b.y() && std::abs(a.y() - 3) > 3);
    if (e.piece == kAreaPiece && !on_box) along.push_back(e);
  }
  return along;
}

TEST(TakeInAreaTest, TheAreaClosesARiverFromVertexToVertexOutside) {
  const Case c = TakeWestOf(2.5, kRiver);
  const std::vector<BoundaryEdge> along = AlongArea(c);
  ASSERT_EQ(along.size(), 1U);
  for (const int32_t v : {along[0].from, along[0].to}) {
    EXPECT_LT(v, std::ssize(c.record.vertices)) << "of the tile";
    EXPECT_GT(c.tile.record.vertices[v].position.x(), 2.5);
    EXPECT_LT(c.tile.record.vertices[v].position.x(), 2.5 + 1.1);
  }
}

TEST(TakeInAreaTest, DropsEdgesOutsideAndKeepsThoseThatCross) {
  const Case c = TakeWestOf(2.5, kRiver);
  for (size_t e = 0; e < c.record.edges.size(); ++e) {
    const double a = c.record.vertices[c.record.edges[e].from].position.x();
    const double b = c.record.vertices[c.record.edges[e].to].position.x();
    EXPECT_EQ(c.tile.edge_of[e] >= 0, std::min(a, b) < 2.5);
  }
}

TEST(TakeInAreaTest, ChainsOffTheOutlineGoOnIntoEachOther) {
  const Case c = TakeWestOf(2.5, kRiver);
  std::map<int32_t, int> balance;
  for (const BoundaryEdge& e : AlongArea(c)) ++balance[e.from], --balance[e.to];
  for (const BoundaryEdge& e : c.tile.record.edges) {
    const double a = c.tile.record.vertices[e.from].position.y(), b = c.tile.record.vertices[e.to].position.y();
    if (e.piece != kAreaPiece && std::abs(a - 3) < 2 && std::abs(b - 3) < 2) ++balance[e.from], --balance[e.to];
  }
  for (const auto& [v, more] : balance) {
    const double x = c.tile.record.vertices[v].position.x();
    EXPECT_EQ(std::abs(more), x < 0 ? 1 : 0) << x;
  }
}

TEST(TakeInAreaTest, OverSurfaceTheAreaBoundsNothing) {
  EXPECT_TRUE(AlongArea(TakeWestOf(2.5, std::vector<std::string>(6, "######"))).empty());
}

TEST(TakeInAreaTest, ACellWithoutTileHasTheAreaAlone) {
  const AreaOutside outside = OutsideIn({{{-9, -9}, {-9, 9}, {2.5, 9}, {2.5, -9}}}, kBox, 0x1p-10);
  const TileInArea tile = TakeInArea({}, {}, outside);
  const auto along = std::count_if(tile.record.edges.begin(), tile.record.edges.end(), [&](const BoundaryEdge& e) {
    return tile.record.vertices[e.from].position.x() == 2.5 && tile.record.vertices[e.to].position.x() == 2.5;
  });
  EXPECT_EQ(along, 1);
}

}  // namespace
}  // namespace tilemend
