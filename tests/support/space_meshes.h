// Boxes with holes that lie over no plane, for tests of patches in space.
#ifndef TILEMEND_TESTS_SUPPORT_SPACE_MESHES_H_
#define TILEMEND_TESTS_SUPPORT_SPACE_MESHES_H_

#include <Eigen/Geometry>
#include <cstdint>
#include <functional>
#include <random>

#include "common/mesh/position_index.h"
#include "tests/support/mesh_builders.h"

namespace tilemend {

inline void AddMesh(const TriMesh& part, TriMesh& mesh) {
  const auto first = static_cast<int32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), part.points.begin(), part.points.end());
  for (const Triangle& t : part.triangles) mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

// Equal positions as one vertex; only the vertices in use.
inline TriMesh Welded(const TriMesh& mesh) {
  PositionIndex index;
  TriMesh welded;
  for (const Triangle& t : mesh.triangles) {
    welded.triangles.push_back(
        {index.Insert(mesh.points[t[0]]), index.Insert(mesh.points[t[1]]), index.Insert(mesh.points[t[2]])});
  }
  welded.points = index.positions();
  return welded;
}

// A closed box [0, side]^3 of unit squares, each two triangles, facing outward.
inline TriMesh BoxMesh(int32_t side) {
  TriMesh box;
  const TriMesh face = SquaresMesh(0, side, 0, side, [](int32_t, int32_t) { return true; });
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool far : {false, true}) {
      TriMesh placed = face;
      for (Point3& p : placed.points) {
        const double u = far ? p.x() : p.y(), v = far ? p.y() : p.x();
        p[axis] = far ? side : 0;
        p[(axis + 1) % 3] = u;
        p[(axis + 2) % 3] = v;
      }
      AddMesh(placed, box);
    }
  }
  return Welded(box);
}

// Without the triangles whose middle is in the hole.
inline TriMesh WithoutHole(TriMesh mesh, const std::function<bool(const Point3&)>& in_hole) {
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    return in_hole((mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3);
  });
  return Welded(mesh);
}

// Each vertex off its place by up to `noise` in all directions.
inline TriMesh Shaken(TriMesh mesh, double noise, uint32_t seed) {
  std::mt19937 random(seed);
  const auto off = [&] { return noise * (static_cast<double>(random()) / 0x1p31 - 1); };
  for (Point3& p : mesh.points) {
    const double x = off(), y = off();
    p += Point3(x, y, off());
  }
  return mesh;
}

// Turned some way about the origin: 0 is not at all, 1 to 3 put another axis up or down, others are askew.
inline TriMesh Turned(TriMesh mesh, int way) {
  const Eigen::Vector3d axes[] = {{0, 0, 1}, {1, 0, 0}, {1, 1, 1}, {1, -1, 0}, {3, 1, 2}, {-1, 4, 1}, {2, -3, -1}};
  const double angles[] = {0, 3.14159265358979312, 2.09439510239319549, 1.57079632679489656, 1, 2, 3};
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angles[way], axes[way].normalized()).toRotationMatrix();
  for (Point3& p : mesh.points) p = turn * p;
  return mesh;
}

// A closed tetrahedron about a point.
inline TriMesh Tetrahedron(const Point3& middle, double size) {
  TriMesh mesh;
  for (const Point3& p : {Point3(1, 1, 1), Point3(-1, -1, 1), Point3(-1, 1, -1), Point3(1, -1, -1)}) {
    mesh.points.emplace_back(middle + size * p);
  }
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}

// A thin closed body along (1, 1, 1) with its middle at `middle`.
inline TriMesh Needle(const Point3& middle) {
  TriMesh mesh = Tetrahedron(Point3(0, 0, 0), 0.1);
  for (Point3& p : mesh.points) p += middle + 20 * p.sum() * Point3(1, 1, 1);
  return mesh;
}

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_SPACE_MESHES_H_
