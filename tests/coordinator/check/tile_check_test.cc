#include "coordinator/check/tile_check.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <utility>

#include "tests/support/mesh_builders.h"
#include "worker/survey/survey.h"

namespace tilemend {
namespace {

constexpr uint64_t kKey = 42;

// A slope of 7 x 5 squares with two holes.
TriMesh Tile() {
  const auto keep = [](int32_t i, int32_t j) { return j != 2 || (i != 2 && i != 5); };
  return SquaresMesh(0, 7, 0, 5, keep, [](double x, double y) { return 0.25 * x + 0.125 * y; });
}

std::string WrongWith(const TriMesh& tile, const std::function<void(SurveyRecord&)>& change) {
  SurveyRecord record = SurveyTile(tile, true);
  change(record);
  return std::string(CheckAgainstTile(record, tile, true, kKey).message());
}
std::string WrongWith(const std::function<void(SurveyRecord&)>& change) { return WrongWith(Tile(), change); }

constexpr auto kAsItIs = [](SurveyRecord&) {};

// Leaves out the loop that vertex `v` is on.
void HideLoop(SurveyRecord& record, int32_t v) {
  for (bool found = true; found;) {
    found = false;
    for (size_t e = 0; e < record.edges.size(); ++e) {
      if (record.edges[e].from != v) continue;
      v = record.edges[e].to;
      record.edges.erase(record.edges.begin() + static_cast<std::ptrdiff_t>(e));
      found = true;
      break;
    }
  }
}

TEST(TileCheckTest, TakesWhatASurveyGives) {
  EXPECT_EQ(WrongWith(kAsItIs), "");
  EXPECT_EQ(WrongWith(TriMesh(), kAsItIs), "");
}

TEST(TileCheckTest, TakesDoubledVerticesAndEdgesOfThreeTriangles) {
  TriMesh tile = Tile();
  const auto other = static_cast<int32_t>(tile.points.size());
  tile.points.push_back(tile.points[tile.triangles[0][0]]);
  tile.triangles[0][0] = other;
  EXPECT_EQ(WrongWith(tile, kAsItIs), "");
  tile.points.emplace_back(3, 2, 9);
  tile.triangles.push_back({tile.triangles[4][0], tile.triangles[4][2], other + 1});  // at an inner edge
  EXPECT_GT(SurveyTile(tile, true).nonmanifold_edges, 0);
  EXPECT_EQ(WrongWith(tile, kAsItIs), "");
  EXPECT_NE(WrongWith(tile, [](SurveyRecord& r) { r.edges.pop_back(); }), "");
}

TEST(TileCheckTest, HasTheCountsTypeAndBoundsOfTheTile) {
  EXPECT_EQ(WrongWith([](SurveyRecord& r) { ++r.vertex_count; }), "counts that are not the tile's");
  EXPECT_EQ(WrongWith([](SurveyRecord& r) { --r.triangle_count; }), "counts that are not the tile's");
  EXPECT_EQ(WrongWith([](SurveyRecord& r) { r.float32 = false; }), "a number type that is not the tile's");
  EXPECT_EQ(WrongWith([](SurveyRecord& r) { r.hi.z() += 1; }), "bounds that are not the tile's");
}

TEST(TileCheckTest, HasTheVerticesOfTheTile) {
  const std::string wrong = "boundary vertices that are not the tile's";
  EXPECT_EQ(WrongWith([](SurveyRecord& r) { r.vertices[0].position.z() += 0.5; }), wrong);
  EXPECT_EQ(WrongWith([](SurveyRecord& r) { std::swap(r.vertices[0].index, r.vertices[1].index); }), wrong);
  TriMesh tile = Tile();
  tile.points.push_back(tile.points[0]);
  const auto last = static_cast<int32_t>(tile.points.size()) - 1;
  EXPECT_EQ(WrongWith(tile,
                      [&](SurveyRecord& r) {
                        for (BoundaryVertex& v : r.vertices) v.index = v.index == 0 ? last : v.index;
                      }),
            wrong);
}

TEST(TileCheckTest, HasEveryLoopOfTheTile) {
  const std::string wrong = "a boundary that is not the tile's";
  const auto loop_of = [](const Point3& p) {
    return [p](SurveyRecord& r) {
      for (size_t v = 0; v < r.vertices.size(); ++v) {
        if (r.vertices[v].position.head<2>() == p.head<2>()) return HideLoop(r, static_cast<int32_t>(v));
      }
      FAIL() << "no such vertex";
    };
  };
  EXPECT_EQ(WrongWith(loop_of({2, 2, 0})), wrong);
  EXPECT_EQ(WrongWith(loop_of({0, 0, 0})), wrong);
}

TEST(TileCheckTest, LeavesTheEdgesOfFlatTrianglesToTheSurvey) {
  TriMesh tile = Tile();
  tile.triangles.push_back({0, 0, 1});
  EXPECT_EQ(WrongWith(tile, kAsItIs), "");
}

}  // namespace
}  // namespace tilemend
