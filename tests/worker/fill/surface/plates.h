// Thin-plate problems on a square of unit squares.
#ifndef TILEMEND_TESTS_WORKER_FILL_SURFACE_PLATES_H_
#define TILEMEND_TESTS_WORKER_FILL_SURFACE_PLATES_H_

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "tests/support/mesh_builders.h"
#include "worker/fill/surface/plate_equations.h"

namespace tilemend::testing {

inline constexpr int32_t kHalf = 8;
inline constexpr int32_t kLarge = 32;  // half a side: 3,969 unknown points, enough for two levels

struct Plate {
  ThinPlateProblem problem;
  std::map<std::pair<double, double>, size_t> at;
};

// The square of half side `half` about the origin, with two rings of known points around the unknown ones. Points for
// which `keep` is false are left out with their triangles; `known` says which of the others have a height besides the
// rings. Known points inside have no equation of their own.
inline Plate MakePlate(const HeightFunction& height, const std::function<bool(double, double)>& keep,
                       const std::function<bool(double, double)>& known, int32_t half = kHalf) {
  const TriMesh mesh = SquaresMesh(-half - 3, half + 3, -half - 3, half + 3, [](int32_t, int32_t) { return true; });
  Plate plate;
  std::vector<int32_t> number(mesh.points.size(), -1);
  const auto outer = [half](const Point3& p) { return p.head<2>().cwiseAbs().maxCoeff() >= half; };
  for (size_t v = 0; v < mesh.points.size(); ++v) {
    const Point3& p = mesh.points[v];
    if (!keep(p.x(), p.y())) continue;
    number[v] = static_cast<int32_t>(plate.problem.points.size());
    plate.at[{p.x(), p.y()}] = plate.problem.points.size();
    const bool fixed = outer(p) || known(p.x(), p.y());
    plate.problem.points.emplace_back(p.x(), p.y(), fixed ? height(p.x(), p.y()) : 0);
    plate.problem.known.push_back(fixed);
    plate.problem.has_equation.push_back(p.head<2>().cwiseAbs().maxCoeff() <= half && !known(p.x(), p.y()));
  }
  for (const Triangle& t : mesh.triangles) {
    const Triangle out = {number[t[0]], number[t[1]], number[t[2]]};
    if (out[0] < 0 || out[1] < 0 || out[2] < 0) continue;
    const bool band = outer(mesh.points[t[0]]) && outer(mesh.points[t[1]]) && outer(mesh.points[t[2]]);
    (band ? plate.problem.band : plate.problem.patch).push_back(out);
  }
  return plate;
}

inline bool Everywhere(double, double) { return true; }
inline bool Nowhere(double, double) { return false; }

inline double Hills(double x, double y) { return std::sin(0.11 * x + 0.2) * std::cos(0.07 * y) + 0.001 * x * y; }
// With noise from point to point, as rims have it.
inline double RoughHills(double x, double y) { return Hills(x, y) + 0.05 * std::sin(37.1 * x + 91.7 * y); }

// Values without any pattern, zero at known points.
inline PointValues Noise(const ThinPlateProblem& problem, bool everywhere) {
  PointValues values(static_cast<Eigen::Index>(problem.points.size()));
  for (Eigen::Index v = 0; v < values.size(); ++v) {
    values[v] = everywhere || !problem.known[v] ? std::sin(12.9898 * static_cast<double>(v + 1) * (v % 7 + 1)) : 0;
  }
  return values;
}

inline double LargestError(const Plate& plate, const HeightFunction& height) {
  double largest = 0;
  for (const Point3& p : plate.problem.points) largest = std::max(largest, std::abs(p.z() - height(p.x(), p.y())));
  return largest;
}

}  // namespace tilemend::testing

#endif  // TILEMEND_TESTS_WORKER_FILL_SURFACE_PLATES_H_
