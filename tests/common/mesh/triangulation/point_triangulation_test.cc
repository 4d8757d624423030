#include "common/mesh/triangulation/point_triangulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace tilemend {
namespace {

using Corners = std::set<int32_t>;

std::set<Corners> TrianglesOf(const PointTriangulation& triangulation, size_t points) {
  std::set<Corners> triangles;
  for (const Triangle& t : triangulation.mesh.triangles) {
    if (std::all_of(t.begin(), t.end(), [&](int32_t v) { return v < static_cast<int32_t>(points); })) {
      triangles.insert(Corners(t.begin(), t.end()));
    }
  }
  return triangles;
}

TEST(PointTriangulationTest, IsDelaunayWithTheHullInIt) {
  const std::vector<Point3> kite = {{0, 0, 5}, {10, 0, 1}, {10, 4, 7}, {3, 9, 2}};
  const PointTriangulation triangulation = TriangulatePoints(kite, {Point2(0, 0), Point2(10, 9)});
  EXPECT_EQ(TrianglesOf(triangulation, 4), (std::set<Corners>{{0, 2, 3}, {0, 1, 2}}));
  EXPECT_EQ(triangulation.points.size(), 8U);
}

TEST(PointTriangulationTest, OfPointsOverOnePlaceOneIsAVertex) {
  const std::vector<Point3> points = {{0, 0, 0}, {8, 0, 0}, {8, 0, 9}, {0, 8, 0}};
  const std::set<Corners> triangles = TrianglesOf(TriangulatePoints(points, {Point2(0, 0), Point2(8, 8)}), 4);
  ASSERT_EQ(triangles.size(), 1U);
  EXPECT_TRUE(*triangles.begin() == Corners({0, 1, 3}) || *triangles.begin() == Corners({0, 2, 3}));
}

TEST(PointTriangulationTest, FewPointsAndNoneHaveTheFrameAlone) {
  for (const std::vector<Point3>& points : {std::vector<Point3>{}, {{1, 1, 0}}, {{0, 0, 0}, {1, 1, 0}}}) {
    const PointTriangulation triangulation = TriangulatePoints(points, {Point2(0, 0), Point2(1, 1)});
    EXPECT_EQ(triangulation.mesh.triangles.size(), 2 + 2 * points.size());
  }
}

// What the ground points of a cell rest on: triangles among some of the points are those among all.
TEST(PointTriangulationTest, ThePointsOfSomeTrianglesGiveThoseAgain) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(0, 100);
  std::vector<Point3> points;
  for (int i = 0; i < 300; ++i) points.emplace_back(place(random), place(random), 0);
  const Eigen::AlignedBox2d places(Point2(0, 0), Point2(100, 100));
  const std::set<Corners> all = TrianglesOf(TriangulatePoints(points, places), points.size());
  Corners chosen;
  std::set<Corners> near;
  for (const Corners& t : all) {
    if (std::any_of(t.begin(), t.end(), [&](int32_t v) { return points[v].x() < 30; })) near.insert(t);
  }
  for (const Corners& t : near) chosen.insert(t.begin(), t.end());
  std::vector<Point3> part;
  const std::vector<int32_t> number(chosen.begin(), chosen.end());
  for (const int32_t v : number) part.push_back(points[v]);
  std::set<Corners> again;
  for (const Corners& t : TrianglesOf(TriangulatePoints(part, places), part.size())) {
    Corners corners;
    for (const int32_t v : t) corners.insert(number[v]);
    again.insert(corners);
  }
  EXPECT_TRUE(std::includes(again.begin(), again.end(), near.begin(), near.end()));
  EXPECT_LT(part.size(), points.size() / 2);
}

}  // namespace
}  // namespace tilemend
