// Plain triangle meshes: the data that every stage works on.
#ifndef TILEMEND_COMMON_MESH_TRI_MESH_H_
#define TILEMEND_COMMON_MESH_TRI_MESH_H_

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace tilemend {

// A position in metres, relative to the scene's origin: x east, y north, z up.
using Point3 = Eigen::Vector3d;
using Point2 = Eigen::Vector2d;

// Corner indices into the points, counter-clockwise seen from outside (from above, on terrain).
using Triangle = std::array<int32_t, 3>;

// A triangle by the positions of its corners.
using SpaceTriangle = std::array<Point3, 3>;

// A triangle soup with shared vertices. No promise about manifoldness, orientation or duplicate positions: tiles
// come as they are. Every index is in [0, points.size()) in any TriMesh that a reader or a stage returned.
struct TriMesh {
  std::vector<Point3> points;
  std::vector<Triangle> triangles;
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_MESH_TRI_MESH_H_
