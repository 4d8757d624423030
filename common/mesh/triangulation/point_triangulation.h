// Delaunay triangulation of points over the plane.
#ifndef TILEMEND_COMMON_MESH_TRIANGULATION_POINT_TRIANGULATION_H_
#define TILEMEND_COMMON_MESH_TRIANGULATION_POINT_TRIANGULATION_H_

#include <Eigen/Geometry>
#include <vector>

#include "common/mesh/triangulation/region_triangulation.h"

namespace tilemend {

// Points on the lattice of a window, triangulated with the four corners of a frame around them.
struct PointTriangulation {
  LatticeWindow window;
  std::vector<LatticePoint> points;  // the given ones, then the frame's corners
  RegionTriangulation mesh;          // of points over one place one is a vertex
};

// Triangulates points by x and y, metres. The frame lies four times the extent of `places` around these, which hold
// all the points: what lies among them is outside the points' hull where its triangle has a corner of the frame.
// O(n log n) expected.
PointTriangulation TriangulatePoints(const std::vector<Point3>& points, const Eigen::AlignedBox2d& places);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_MESH_TRIANGULATION_POINT_TRIANGULATION_H_
