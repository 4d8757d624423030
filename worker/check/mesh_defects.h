// What is wrong with a mesh, apart from its holes (Zhang 2022, table 1, with definitions of our own: the paper has
// none).
#ifndef TILEMEND_WORKER_CHECK_MESH_DEFECTS_H_
#define TILEMEND_WORKER_CHECK_MESH_DEFECTS_H_

#include <cstdint>
#include <map>
#include <vector>

#include "common/mesh/mesh_view.h"
#include "common/mesh/tri_mesh.h"

namespace tilemend {

enum class Defect {
  kNonManifoldEdge,    // an edge with more than two triangles
  kNonManifoldVertex,  // a vertex off such edges at which the triangles form more than one fan
  kTurnedEdge,         // an edge whose two triangles face opposite ways
  kSelfIntersection,   // a triangle that passes through or touches one that it shares no more than a corner with, or
                       // folds onto a neighbour
  kCreasedEdge,        // an edge at which the surface turns by more than CheckLimits::crease_degrees
  kSpike,              // a vertex whose triangles together have less than spike_degrees there, and whose edges are in
                       // the mean spike_edges times as long as those around it
  kSmallComponent,     // a piece, not the largest, that is no wider than component_edges mean edges of the mesh
  kDuplicateTriangle,  // a triangle with the corners of an earlier one
  kFlatTriangle,       // a triangle without area
};
inline constexpr int kDefectKinds = 9;

struct CheckLimits {
  double crease_degrees = 120;  // (0, 180)
  double spike_degrees = 90;    // (0, 360)
  double spike_edges = 2;
  double component_edges = 5;
};

struct DefectFinding {
  int64_t count = 0;
  std::vector<Point3> places;  // the first few
};

// By kind, all kinds. Vertices at equal positions are one. Touching is decided by exact signs. O(n log n) where
// triangles are small beside the mesh.
std::map<Defect, DefectFinding> FindDefects(const TriMesh& mesh, const CheckLimits& limits);

// Whether any triangle has an area: a mesh of none has no surface. O(n).
bool HasArea(const MeshView& mesh);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_CHECK_MESH_DEFECTS_H_
