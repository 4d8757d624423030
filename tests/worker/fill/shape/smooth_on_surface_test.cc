#include "worker/fill/shape/smooth_on_surface.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace tilemend {
namespace {

constexpr double kStep = 0x1p-10;  // of the lattice, metres

LatticePoint OnLattice(const Point2& p) { return {std::llround(p.x() / kStep), std::llround(p.y() / kStep)}; }

std::optional<std::pair<LatticePoint, Point2>> Anywhere(const Point2& p) {
  const LatticePoint q = OnLattice(p);
  return std::pair(q, Point2(static_cast<double>(q.x) * kStep, static_cast<double>(q.y) * kStep));
}

// A patch of its rim's points first; every other one may move.
struct Patch {
  std::vector<Triangle> triangles;
  std::vector<LatticePoint> plane;
  std::vector<Point3> points;
  int32_t rim = 0;

  void Add(double x, double y, const std::function<double(double, double)>& height) {
    plane.push_back(OnLattice({x, y}));
    points.emplace_back(x, y, height(x, y));
  }

  void Smooth(const PlacePoint& place = Anywhere) { SmoothOnSurface(triangles, rim, place, plane, points); }

  double ShapeSum() const {
    double sum = 0;
    for (const Triangle& t : triangles) {
      const Eigen::Vector3d ab = points[t[1]] - points[t[0]], ac = points[t[2]] - points[t[0]];
      sum += ab.cross(ac).norm() / (ab.squaredNorm() + ac.squaredNorm() + (ac - ab).squaredNorm());
    }
    return sum;
  }
};

double Flat(double, double) { return 0; }
double Steep(double x, double y) { return 2 * x + y; }
double Bowl(double x, double y) { return (x * x + y * y) / 8; }

// A hexagon with a vertex in it, off its centre.
Patch Hexagon(const std::function<double(double, double)>& height) {
  Patch patch;
  patch.rim = 6;
  for (const auto& [x, y] : {std::pair(2, 0), {1, 2}, {-1, 2}, {-2, 0}, {-1, -2}, {1, -2}}) patch.Add(x, y, height);
  patch.Add(0.75, 0.5, height);
  for (int32_t k = 0; k < 6; ++k) patch.triangles.push_back({k, (k + 1) % 6, 6});
  return patch;
}

TEST(SmoothOnSurfaceTest, MovesAVertexToWhereItsTrianglesAreBetter) {
  Patch patch = Hexagon(Steep);
  const std::vector<Point3> before = patch.points;
  const double shapes = patch.ShapeSum();
  patch.Smooth();
  EXPECT_GT(patch.ShapeSum(), 1.05 * shapes);
  for (size_t v = 0; v < 6; ++v) EXPECT_EQ(patch.points[v], before[v]);
  EXPECT_NE(patch.points[6], before[6]);
}

TEST(SmoothOnSurfaceTest, StaysOnAPlane) {
  Patch patch = Hexagon(Steep);
  patch.Smooth();
  EXPECT_NEAR(patch.points[6].z(), Steep(patch.points[6].x(), patch.points[6].y()), 1e-12);
}

// Squares of side 1, each of two triangles, the vertices inside pushed off their places.
TEST(SmoothOnSurfaceTest, StaysNearACurvedSurface) {
  constexpr int32_t kSide = 9;
  Patch patch;
  std::vector<std::vector<int32_t>> number(kSide, std::vector<int32_t>(kSide));
  for (const bool inside : {false, true}) {
    if (inside) patch.rim = static_cast<int32_t>(patch.points.size());
    for (int32_t j = 0; j < kSide; ++j) {
      for (int32_t i = 0; i < kSide; ++i) {
        if (inside != (i > 0 && j > 0 && i + 1 < kSide && j + 1 < kSide)) continue;
        number[j][i] = static_cast<int32_t>(patch.points.size());
        const double off = inside ? 0.25 * ((i + 2 * j) % 3 - 1) : 0;
        patch.Add(i - 4 + off, j - 4 - off, Bowl);
      }
    }
  }
  for (int32_t j = 0; j + 1 < kSide; ++j) {
    for (int32_t i = 0; i + 1 < kSide; ++i) {
      patch.triangles.push_back({number[j][i], number[j][i + 1], number[j + 1][i + 1]});
      patch.triangles.push_back({number[j][i], number[j + 1][i + 1], number[j + 1][i]});
    }
  }
  const double shapes = patch.ShapeSum();
  patch.Smooth();
  EXPECT_GT(patch.ShapeSum(), 1.01 * shapes);
  // The diagonals lie 1 / 16 off the bowl.
  for (const Point3& p : patch.points) EXPECT_NEAR(p.z(), Bowl(p.x(), p.y()), 1.0 / 16);
}

TEST(SmoothOnSurfaceTest, TurnsNoTriangleOver) {
  Patch patch = Hexagon([](double x, double) { return x < 0 ? 0 : 40 * x; });
  patch.Smooth();
  for (const Triangle& t : patch.triangles) {
    EXPECT_GT(Orientation(patch.plane[t[0]], patch.plane[t[1]], patch.plane[t[2]]), 0);
  }
}

TEST(SmoothOnSurfaceTest, LeavesAVertexThatHasNoOtherPlace) {
  Patch patch = Hexagon(Steep);
  const std::vector<Point3> before = patch.points;
  patch.Smooth([](const Point2&) { return std::nullopt; });
  EXPECT_EQ(patch.points, before);
}

TEST(IsSteepPatchTest, TellsSteepFromFlat) {
  const auto slope = [](double s) { return [s](double x, double) { return s * x; }; };
  for (const double gentle : {0.0, 0.2}) {
    const Patch patch = Hexagon(slope(gentle));
    EXPECT_FALSE(IsSteepPatch(patch.triangles, patch.points));
  }
  const Patch patch = Hexagon(slope(0.3));
  EXPECT_TRUE(IsSteepPatch(patch.triangles, patch.points));
  EXPECT_FALSE(IsSteepPatch(Hexagon(Flat).triangles, Hexagon(Flat).points));
}

}  // namespace
}  // namespace tilemend
