// Round bodies of known shape, for tests of holes in single meshes.
#ifndef TILEMEND_TESTS_SUPPORT_ROUND_MESHES_H_
#define TILEMEND_TESTS_SUPPORT_ROUND_MESHES_H_

#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>

#include "tests/support/mesh_builders.h"

namespace tilemend {

// Squares [0, around) x [0, along) as a surface: column `around` is column 0. Faces the side from which x of the
// squares goes right and y up.
inline TriMesh TubeMesh(int32_t around, int32_t along, const std::function<Point3(double turn, double share)>& at) {
  TriMesh mesh;
  for (int32_t j = 0; j <= along; ++j) {
    for (int32_t i = 0; i < around; ++i) {
      mesh.points.push_back(at(2 * std::numbers::pi * i / around, static_cast<double>(j) / along));
    }
  }
  for (int32_t j = 0; j < along; ++j) {
    for (int32_t i = 0; i < around; ++i) {
      const int32_t a = j * around + i, b = j * around + (i + 1) % around;
      mesh.triangles.push_back({a, b, b + around});
      mesh.triangles.push_back({a, b + around, a + around});
    }
  }
  return mesh;
}

// A tube about the z axis, facing outward, open at both ends.
inline TriMesh Tube(int32_t around, int32_t along, double radius, double z0, double z1) {
  return TubeMesh(around, along, [=](double turn, double share) {
    return Point3(radius * std::cos(turn), radius * std::sin(turn), z0 + share * (z1 - z0));
  });
}

// The unit sphere between two angles from its upper pole, degrees, facing outward: open at both unless an angle is 0.
inline TriMesh SphereBelt(double from_degrees, double to_degrees, int32_t around = 24, int32_t along = 12) {
  const double degree = std::numbers::pi / 180;
  TriMesh mesh = TubeMesh(around, along, [=](double turn, double share) {
    const double angle = degree * (to_degrees + share * (from_degrees - to_degrees));
    return Point3(std::sin(angle) * std::cos(turn), std::sin(angle) * std::sin(turn), std::cos(angle));
  });
  if (from_degrees > 0) return mesh;
  // The last row is the pole: one vertex.
  const auto pole = static_cast<int32_t>(mesh.points.size()) - around;
  mesh.points.resize(static_cast<size_t>(pole) + 1);
  for (Triangle& t : mesh.triangles) {
    for (int32_t& v : t) v = std::min(v, pole);
  }
  std::erase_if(mesh.triangles, [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  return mesh;
}

// A torus about the z axis without the part of its length beyond `share`, facing outward.
inline TriMesh TorusPart(int32_t around, int32_t along, double radius, double thickness, double share_kept) {
  return TubeMesh(around, along, [=](double turn, double share) {
    const double way = 2 * std::numbers::pi * share * share_kept, off = radius + thickness * std::cos(turn);
    return Point3(off * std::cos(way), off * std::sin(way), -thickness * std::sin(turn));
  });
}

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_ROUND_MESHES_H_
