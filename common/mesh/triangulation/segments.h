// Forces segments into a Delaunay triangulation.
#ifndef TILEMEND_COMMON_MESH_TRIANGULATION_SEGMENTS_H_
#define TILEMEND_COMMON_MESH_TRIANGULATION_SEGMENTS_H_

#include <cstdint>
#include <optional>
#include <vector>

#include "common/mesh/triangulation/delaunay.h"

namespace tilemend::internal {

// Makes segments edges of a triangulation with ghosts, one after the other, keeping it constrained Delaunay. The
// triangles that a segment crosses are replaced on either side, then made Delaunay by Lawson flips. The replacement is
// a linear-time scan over the chain of their vertices. Every vertex of the chain sees the segment along an edge that
// crossed it, so the scan is that of a weakly visible polygon.
class SegmentInserter {
 public:
  // What stood in the way.
  struct Obstacle {
    bool is_point;  // vertex `a` lies on the segment; otherwise the constrained edge a-b crosses it
    int32_t a;
    int32_t b;
  };

  explicit SegmentInserter(DelaunayMesh& mesh);

  // Precondition: a != b are vertices of the triangulation. With an obstacle the mesh is unchanged.
  std::optional<Obstacle> Insert(int32_t a, int32_t b);

 private:
  // An edge of the cavity to be joined: half_edge < 0 only says that the edge is constrained.
  struct LooseEdge {
    int32_t lo;
    int32_t hi;
    int32_t half_edge;
    bool constrained;
  };

  struct Departure {
    int32_t half_edge = -1;  // the edge that the segment crosses first
    int32_t vertex = -1;     // or the first vertex on it
    int32_t spoke = -1;      // the half-edge between a and that vertex
  };
  Departure Leave(int32_t a, int32_t b) const;
  std::optional<Obstacle> March(int32_t a, int32_t b, int32_t half_edge);
  void CollectLooseEdges(int32_t a, int32_t b);
  void FillSide(const std::vector<int32_t>& chain, bool left);
  void Join();
  void MakeDelaunay();
  void AddLoose(int32_t u, int32_t v, int32_t half_edge, bool constrained);
  void Constrain(int32_t half_edge);
  void Touch(int32_t triangle);

  DelaunayMesh& mesh_;
  std::vector<int32_t> triangle_of_;  // some real triangle at each vertex, -1 if none
  std::vector<int32_t> degree_;       // triangles at each vertex before the first segment
  std::vector<uint32_t> removed_at_;  // per triangle: the round in which it was removed
  uint32_t round_ = 0;
  std::vector<int32_t> removed_, free_, left_, right_, pile_, todo_;
  std::vector<LooseEdge> loose_;
};

}  // namespace tilemend::internal

#endif  // TILEMEND_COMMON_MESH_TRIANGULATION_SEGMENTS_H_
