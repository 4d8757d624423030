// The edges of a mesh whose vertices are welded by position: those of one triangle, and those of several.
#ifndef TILEMEND_WORKER_SURVEY_WELDED_EDGES_H_
#define TILEMEND_WORKER_SURVEY_WELDED_EDGES_H_

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "common/mesh/mesh_view.h"
#include "common/records/survey_record.h"

namespace tilemend {

// Of an edge of a triangle, as that is directed, between welded vertices.
struct HalfEdge {
  int32_t from, to;
  int32_t triangle;
  int place;  // of its first corner in the triangle
  int32_t lo() const { return std::min(from, to); }
  int32_t hi() const { return std::max(from, to); }
};

struct WeldedEdges {
  std::vector<HalfEdge> boundary;                   // in order of the triangles
  std::vector<std::pair<int32_t, int32_t>> across;  // triangles that share an edge
};

// Where two triangles lie on each other and end at one edge.
enum class DoubleEdges {
  kNone,   // it is no boundary
  kClose,  // it is boundary twice, if boundary ends there or along such edges: pieces of a tile end there
};

// The edges between welded vertices. Those in exactly one triangle are boundary. Counts the degenerate triangles,
// repeated, disagreeing and non-manifold edges in `record`.
//   weld     the welded vertex of each vertex; -1: none (it lies within the surface)
//   at_weld  the triangles with a welded corner
// Cost: O(n log n) in those triangles.
WeldedEdges FindWeldedEdges(const MeshView& mesh, const std::vector<int32_t>& weld, const std::vector<int32_t>& at_weld,
                            DoubleEdges doubles, SurveyRecord& record);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_SURVEY_WELDED_EDGES_H_
