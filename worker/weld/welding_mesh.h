// A mesh whose boundary vertices are merged, and whose boundary edges are split, one after the other.
#ifndef TILEMEND_WORKER_WELD_WELDING_MESH_H_
#define TILEMEND_WORKER_WELD_WELDING_MESH_H_

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "common/mesh/mesh_view.h"
#include "common/mesh/tri_mesh.h"

namespace tilemend {

// A place is a number of a position. Vertices at one position are one place from the start, merged places are one place
// from then on: the one that stays.
class WeldingMesh {
 public:
  // An edge of a triangle, from its corner to the next.
  struct Edge {
    int32_t triangle = 0;
    int corner = 0;
  };

  // `boundary` are the vertices that may be merged, one for each position. The mesh outlives this. O(n).
  WeldingMesh(const MeshView& mesh, std::span<const int32_t> boundary, std::span<const int32_t> face_of);
  WeldingMesh(const TriMesh&& mesh, std::span<const int32_t> boundary, std::span<const int32_t> face_of) = delete;

  // The places of the boundary vertices, in their order.
  const std::vector<int32_t>& boundary() const { return boundary_; }
  // Where a place is now.
  int32_t StaysAs(int32_t place) const;
  int32_t VertexAt(int32_t place) const { return vertex_at_[place]; }
  Point3 PositionOf(int32_t place) const { return mesh_.points[vertex_at_[place]]; }
  // Boundary places that were merged into one, itself first.
  std::span<const int32_t> MembersOf(int32_t place) const { return members_.at(place); }

  // Why place `gone` cannot be merged into `keep`; null if it can. The cost is that of the triangles at both.
  const char* MergeFault(int32_t keep, int32_t gone) const;
  // Precondition: no fault.
  void Merge(int32_t keep, int32_t gone);

  // The edges with one triangle, in order of the triangles.
  std::vector<Edge> OpenEdges() const;
  bool IsOpen(const Edge& edge) const;
  bool IsAtOpenEdge(int32_t place) const;
  std::pair<int32_t, int32_t> EndsOf(const Edge& edge) const;
  // Why the triangle of an edge cannot be split at `place`; null if it can.
  const char* SplitFault(const Edge& edge, int32_t place) const;
  // Splits it: its far half is a new triangle. Precondition: no fault, an edge of OpenEdges.
  void Split(const Edge& edge, int32_t place);

  // By vertices of the mesh: its triangles as they are now, then the new ones.
  const std::vector<Triangle>& triangles() const { return triangles_; }
  // Of each new triangle, the one of the mesh that it is a part of.
  std::span<const int32_t> CutFrom() const { return std::span(original_).subspan(mesh_.triangles.size()); }

 private:
  int32_t PlaceOf(int32_t vertex) const { return StaysAs(place_of_[vertex]); }
  std::array<int32_t, 3> PlacesOf(int32_t triangle) const;
  std::span<const int32_t> TrianglesAt(int32_t place) const;
  // How many triangles at a place have an edge from one place to another, of which it is one.
  int Count(int32_t at, int32_t from, int32_t to) const;
  // Whether an edge joins them.
  bool Has(int32_t at, int32_t other) const;
  // Whether the edge to `other` would have more than one triangle each way if `gone` were `keep`.
  bool WouldCrowd(int32_t keep, int32_t gone, int32_t other) const;
  Eigen::Vector3d NormalAt(int32_t place) const;
  bool FacesAgainst(const Eigen::Vector3d& normal, const Eigen::Vector3d& other) const;
  bool SharesFace(int32_t triangle, int32_t place) const;
  // What is wrong with a triangle that gets these corners: no area, or it faces another way than the original.
  const char* ShapeFault(int32_t triangle, const SpaceTriangle& corners) const;
  // Whether the triangle is a whole face of the file.
  bool IsWhole(int32_t triangle) const;

  MeshView mesh_;
  std::span<const int32_t> face_of_;
  std::vector<int32_t> place_of_, vertex_at_;  // by vertex; by place: the lowest
  std::vector<int32_t> boundary_;
  std::vector<int32_t> merged_into_;  // by place
  std::vector<Triangle> triangles_;
  std::vector<int32_t> original_;                                             // of each triangle
  std::unordered_map<int32_t, std::vector<int32_t>> triangles_at_, members_;  // of boundary places
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_WELD_WELDING_MESH_H_
