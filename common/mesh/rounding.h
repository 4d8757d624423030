// Rounding of coordinates: to the scene's lattice, and to what a file can hold.
#ifndef TILEMEND_COMMON_MESH_ROUNDING_H_
#define TILEMEND_COMMON_MESH_ROUNDING_H_

#include <Eigen/Core>
#include <cmath>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// What a file can hold in a coordinate.
enum class NumberType { kFloat32, kFloat64 };

// The multiple of `step` (a power of two, so that it is exact) that is nearest to x; of two the one further from zero.
inline double RoundedToLattice(double x, double step) { return std::round(x / step) * step; }

inline Point2 RoundedToLattice(const Point2& p, double step) {
  return {RoundedToLattice(p.x(), step), RoundedToLattice(p.y(), step)};
}

inline Point3 RoundedToLattice(const Point3& p, double step) {
  return {RoundedToLattice(p.x(), step), RoundedToLattice(p.y(), step), RoundedToLattice(p.z(), step)};
}

// The double that a file of `type` gives back for `value`.
//
// The store to memory is needed. Compiled by g++ 12 at -O2, neighbouring `double(float(x))` do nothing when they are
// vectorised: a[0] = double(float(a[0])); a[1] = double(float(a[1])); leaves `a` as it was. The same goes for Eigen's
// cast<float>().cast<double>().
inline double RoundedTo(NumberType type, double value) {
  if (type == NumberType::kFloat64) return value;
  volatile float rounded = static_cast<float>(value);
  return static_cast<double>(rounded);
}

inline Point2 RoundedTo(NumberType type, const Point2& p) { return {RoundedTo(type, p.x()), RoundedTo(type, p.y())}; }

inline Point3 RoundedTo(NumberType type, const Point3& p) {
  return {RoundedTo(type, p.x()), RoundedTo(type, p.y()), RoundedTo(type, p.z())};
}

}  // namespace tilemend

#endif  // TILEMEND_COMMON_MESH_ROUNDING_H_
