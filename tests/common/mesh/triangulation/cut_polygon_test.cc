#include "common/mesh/triangulation/cut_polygon.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <vector>

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

std::vector<Triangle> Cut(const std::vector<Point3>& points) {
  std::vector<int32_t> corners(points.size());
  std::iota(corners.begin(), corners.end(), 0);
  std::vector<Triangle> triangles;
  CutPolygon(corners, points, triangles);
  return triangles;
}

Eigen::Vector3d AreaOf(const std::vector<Point3>& p, const Triangle& t) {
  return (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]) / 2;
}

// Each of the triangles faces as the face does, and together they are as large.
void ExpectCovered(const std::vector<Point3>& points, double area) {
  const std::vector<Triangle> triangles = Cut(points);
  ASSERT_THAT(triangles, SizeIs(points.size() - 2));
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double sizes = 0;
  for (const Triangle& t : triangles) {
    sum += AreaOf(points, t);
    sizes += AreaOf(points, t).norm();
  }
  EXPECT_NEAR(sum.norm(), area, 1e-12 * area);
  EXPECT_NEAR(sizes, area, 1e-12 * area);
}

// An L, its corners from number `first` on, turned and moved.
std::vector<Point3> LShape(size_t first, double turn) {
  std::vector<Point3> points = {{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  std::rotate(points.begin(), points.begin() + static_cast<ptrdiff_t>(first), points.end());
  const Eigen::AngleAxisd rotation(turn, Eigen::Vector3d(1, 2, 3).normalized());
  for (Point3& p : points) p = rotation * p + Point3(5, -7, 11);
  return points;
}

TEST(CutPolygonTest, MakesAFanOfAConvexFace) {
  EXPECT_THAT(Cut({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), ElementsAre(Triangle{0, 1, 2}));
  EXPECT_THAT(Cut({{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}}),
              ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}, Triangle{0, 3, 4}));
}

TEST(CutPolygonTest, CoversAConcaveFaceWhateverCornerIsFirst) {
  for (size_t first = 0; first < 6; ++first) {
    for (const double turn : {0.0, 0.4, 1.5, 3.0}) {
      SCOPED_TRACE(first + turn);
      ExpectCovered(LShape(first, turn), 4);
    }
  }
}

TEST(CutPolygonTest, CoversACombOfManyTeeth) {
  std::vector<Point3> comb = {{1000, -1, 0}, {1000, 0, 0}};
  for (int tooth = 999; tooth >= 0; --tooth) {
    comb.emplace_back(tooth + 0.5, 1, 0);
    comb.emplace_back(tooth, 0, 0);
  }
  comb.emplace_back(0, -1, 0);
  ExpectCovered(comb, 1000 + 500);
}

TEST(CutPolygonTest, MakesAFanOfWhatCrossesItselfOrIsNotKnown) {
  const std::vector<Point3> bow_tie = {{0, 0, 0}, {3, 3, 0}, {2, 0, 0}, {0, 1, 0}};
  EXPECT_THAT(Cut(bow_tie), SizeIs(2));
  std::vector<Triangle> triangles;
  const std::vector<int32_t> corners = {0, 1, 2, 9};
  CutPolygon(corners, bow_tie, triangles);
  EXPECT_THAT(triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
}

}  // namespace
}  // namespace tilemend
