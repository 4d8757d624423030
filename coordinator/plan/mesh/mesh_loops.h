// The boundary loops of one mesh, as they lie in space.
#ifndef TILEMEND_COORDINATOR_PLAN_MESH_MESH_LOOPS_H_
#define TILEMEND_COORDINATOR_PLAN_MESH_MESH_LOOPS_H_

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "common/records/cell_holes.h"
#include "common/records/survey_record.h"
#include "coordinator/plan/rim/rim.h"

namespace tilemend {

struct MeshLoop {
  std::vector<RimSegment> segments;      // of rim points; a hole on the left, seen from outside
  Eigen::Vector3d vector_area{0, 0, 0};  // of a patch that would close it
  Eigen::Vector3d normal{0, 0, 0};       // the mean of the unit normals of the surface along it: no unit vector itself
  Point3 middle{0, 0, 0};                // of its vertices
  double length = 0;
  int32_t piece = 0;     // BoundaryEdge::piece
  int32_t group = 0;     // loops that share a vertex have the same
  bool touches = false;  // another loop, or itself: part of a continuous hole (Zhang 2022, 3.2)

  // The mean cosine between the direction of the loop and the surface along it. It is near +1 around a hole in a sheet,
  // near -1 around the sheet, near 0 at the end of a tube.
  double Turn() const {
    const double area = vector_area.norm();
    return area > 0 ? vector_area.dot(normal) / area : 0;
  }

  // Whether it has next to no area for its length: the two sides of a crack. Where they overlap it runs the wrong way
  // round, as an outline does.
  bool IsSlit() const { return vector_area.norm() < kSlit * length * length; }

 private:
  static constexpr double kSlit = 0.005;
};

// The loops of the rim of one mesh, in order of Rim::loops. Precondition: `rim` is that of `record` alone. O(n log n).
std::vector<MeshLoop> ReadMeshLoops(const Rim& rim, const SurveyRecord& record);

// How many groups are continuous holes.
int32_t CountContinuous(const std::vector<MeshLoop>& loops);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_MESH_MESH_LOOPS_H_
