// What every triangulated region must satisfy, checked by means that share no code with the triangulator.
#ifndef TILEMEND_TESTS_COMMON_MESH_TRIANGULATION_REGION_CHECKS_H_
#define TILEMEND_TESTS_COMMON_MESH_TRIANGULATION_REGION_CHECKS_H_

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "common/mesh/triangulation/region_triangulation.h"

namespace tilemend::testing {

using Int = __int128;

inline Int Cross(LatticePoint a, LatticePoint b, LatticePoint c) {
  return Int{b.x - a.x} * (c.y - a.y) - Int{b.y - a.y} * (c.x - a.x);
}

// A planar straight-line graph under construction.
struct Region {
  std::vector<LatticePoint> points;
  std::vector<RegionSegment> segments;

  // Adds a closed loop; counter-clockwise bounds its inside, clockwise makes an island.
  Region& Loop(const std::vector<LatticePoint>& loop) {
    const auto first = static_cast<int32_t>(points.size());
    const auto n = static_cast<int32_t>(loop.size());
    points.insert(points.end(), loop.begin(), loop.end());
    for (int32_t i = 0; i < n; ++i) segments.push_back({first + i, first + (i + 1) % n});
    return *this;
  }
  // Adds a loop over points that exist already.
  Region& LoopOf(const std::vector<int32_t>& loop) {
    for (size_t i = 0; i < loop.size(); ++i) segments.push_back({loop[i], loop[(i + 1) % loop.size()]});
    return *this;
  }
};

inline Region Square(int64_t x, int64_t y, int64_t side) {
  return Region().Loop({{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}});
}

// Twice the area that the segments bound.
inline Int BoundedArea2(std::span<const LatticePoint> points, std::span<const RegionSegment> segments) {
  Int sum = 0;
  for (const RegionSegment& s : segments) {
    sum += Int{points[s.from].x} * points[s.to].y - Int{points[s.from].y} * points[s.to].x;
  }
  return sum;
}

// All guarantees but Delaunay: orientation, area, symmetric neighbours, components, segments.
inline void CheckTopology(std::span<const LatticePoint> points, std::span<const RegionSegment> segments,
                          const RegionTriangulation& result) {
  ASSERT_TRUE(result.conflicts.empty());
  ASSERT_EQ(result.neighbors.size(), result.triangles.size());
  ASSERT_EQ(result.component.size(), result.triangles.size());
  ASSERT_EQ(result.segment_triangle.size(), segments.size());
  std::map<std::pair<int32_t, int32_t>, int32_t> open;
  for (size_t s = 0; s < segments.size(); ++s) open[{segments[s].from, segments[s].to}] = static_cast<int32_t>(s);
  Int area = 0;
  size_t walls = 0;
  for (size_t t = 0; t < result.triangles.size(); ++t) {
    const Triangle& tri = result.triangles[t];
    const Int area2 = Cross(points[tri[0]], points[tri[1]], points[tri[2]]);
    ASSERT_TRUE(area2 > 0) << "triangle " << t;
    area += area2;
    ASSERT_GE(result.component[t], 0);
    ASSERT_LT(result.component[t], result.component_count);
    for (int k = 0; k < 3; ++k) {
      const std::pair edge(tri[(k + 1) % 3], tri[(k + 2) % 3]);
      const int32_t n = result.neighbors[t][k];
      const auto segment = open.find(edge);
      if (segment != open.end()) {
        ++walls;
        ASSERT_EQ(n, -1);
        ASSERT_EQ(result.segment_triangle[segment->second], static_cast<int32_t>(t));
        continue;
      }
      ASSERT_GE(n, 0);
      ASSERT_EQ(result.component[n], result.component[t]);
      int back = 0;
      for (int j = 0; j < 3; ++j) {
        const std::pair reversed(result.triangles[n][(j + 2) % 3], result.triangles[n][(j + 1) % 3]);
        back += reversed == edge && result.neighbors[n][j] == static_cast<int32_t>(t);
      }
      ASSERT_EQ(back, 1);
    }
  }
  ASSERT_EQ(walls, segments.size());
  ASSERT_TRUE(area == BoundedArea2(points, segments));
}

// No far corner of a neighbour inside a triangle's circle, by a determinant in the plain 3x3 form.
inline void CheckDelaunay(std::span<const LatticePoint> points, const RegionTriangulation& result) {
  for (size_t t = 0; t < result.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int32_t n = result.neighbors[t][k];
      if (n < 0) continue;
      for (int32_t v : result.triangles[n]) {
        Int m[3][3];
        for (int i = 0; i < 3; ++i) {
          m[i][0] = points[result.triangles[t][i]].x - points[v].x;
          m[i][1] = points[result.triangles[t][i]].y - points[v].y;
          m[i][2] = m[i][0] * m[i][0] + m[i][1] * m[i][1];
        }
        const Int determinant = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                                m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                                m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
        ASSERT_TRUE(determinant <= 0) << "triangle " << t << " point " << v;
      }
    }
  }
}

inline RegionTriangulation TriangulateAndCheck(const Region& region) {
  RegionTriangulation result = TriangulateRegion(region.points, region.segments);
  CheckTopology(region.points, region.segments, result);
  if (!::testing::Test::HasFatalFailure()) CheckDelaunay(region.points, result);
  return result;
}

// A star-shaped polygon with random radii; simple by construction as long as the rounded points are distinct in angle.
inline Region RandomStar(uint32_t seed, int count, double radius) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> part(0.3, 1.0);
  std::vector<LatticePoint> loop;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count, r = radius * part(random);
    loop.push_back({std::llround(r * std::cos(angle)), std::llround(r * std::sin(angle))});
  }
  return Region().Loop(loop);
}

}  // namespace tilemend::testing

#endif  // TILEMEND_TESTS_COMMON_MESH_TRIANGULATION_REGION_CHECKS_H_
