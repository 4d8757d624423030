#include "common/assemble/level_outline.h"

#include <gtest/gtest.h>

#include <functional>

namespace tilemend {
namespace {

// A square of 16 m in squares of `step`; the triangles whose middles are wanted.
TriMesh Grid(int32_t step, const std::function<bool(const Point2&)>& is_wanted) {
  const int32_t n = 16 / step;
  TriMesh mesh;
  for (int32_t y = 0; y <= n; ++y) {
    for (int32_t x = 0; x <= n; ++x) mesh.points.emplace_back(x * step, y * step, 3);
  }
  for (int32_t y = 0; y < n; ++y) {
    for (int32_t x = 0; x < n; ++x) {
      const int32_t a = y * (n + 1) + x, b = a + 1, c = a + n + 1, d = c + 1;
      for (const Triangle& t : {Triangle{a, b, d}, Triangle{a, d, c}}) {
        const Point3 middle = (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3;
        if (is_wanted(middle.head<2>())) mesh.triangles.push_back(t);
      }
    }
  }
  return mesh;
}

bool IsIn(const Point2& p, double lo, double hi) { return p.minCoeff() > lo && p.maxCoeff() < hi; }

class LevelOutlineTest : public ::testing::Test {
 protected:
  LevelOutlineTest() {
    patch_.triangles = Grid(1, [](const Point2& p) { return IsIn(p, 5, 7); }).triangles;
  }

  const TriMesh finest_ = Grid(1, [](const Point2& p) { return !IsIn(p, 5, 7); });
  const TriMesh level_ = Grid(4, [](const Point2& p) { return !IsIn(p, 4, 8); });
  const TriMesh cleared_ = Grid(4, [](const Point2& p) { return IsIn(p, 4, 8); });
  FilePatch patch_;
};

TEST_F(LevelOutlineTest, IsTheRimOfTheLevel) {
  LevelOutline outline(level_, finest_, patch_, cleared_);
  const std::vector<RegionBoundary> boundaries = outline.Boundaries();
  EXPECT_TRUE(outline.open().empty());
  EXPECT_DOUBLE_EQ(outline.edge(), 4);
  ASSERT_EQ(boundaries.size(), 1u);
  ASSERT_EQ(boundaries[0].size(), 4u) << "the sides of a square of the level";
  for (const DirectedEdge& s : boundaries[0]) {
    const int32_t v = outline.LevelVertexAt(s.from);
    ASSERT_GE(v, 0);
    EXPECT_EQ(Point2(level_.points[v].head<2>()), outline.region().At(s.from));
  }
}

TEST_F(LevelOutlineTest, KnowsThePlacesOfVerticesOfThePatch) {
  LevelOutline outline(level_, finest_, patch_, cleared_);
  ASSERT_FALSE(outline.Boundaries().empty());
  ASSERT_EQ(outline.footprint().size(), 8u);
  for (const DirectedEdge& s : outline.footprint()) {
    EXPECT_EQ(outline.LevelVertexAt(s.from), -1);
    const Point3* place = outline.PlaceOf(s.from);
    ASSERT_NE(place, nullptr);
    EXPECT_EQ(Point2(place->head<2>()), outline.region().At(s.from));
    EXPECT_EQ(place->z(), 3);
  }
}

TEST_F(LevelOutlineTest, WithoutAHoleThereIsNone) {
  const TriMesh whole = Grid(4, [](const Point2&) { return true; }), none;
  EXPECT_TRUE(LevelOutline(whole, finest_, patch_, none).Boundaries().empty());
}

}  // namespace
}  // namespace tilemend
