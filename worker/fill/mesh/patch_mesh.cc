#include "worker/fill/mesh/patch_mesh.h"

#include <OpenMesh/Core/System/omstream.hh>
#include <algorithm>

namespace tilemend {
namespace {

// OpenMesh tells of each face that it refuses on stderr.
void SilenceOpenMesh() {
  static const bool silent = [] {
    omerr().disable();
    return true;
  }();
  static_cast<void>(silent);
}

bool HasRepeatedCorner(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

}  // namespace

PatchMesh::PatchMesh(std::span<const Point3> points, std::span<const Triangle> triangles) {
  SilenceOpenMesh();
  // Euler: about three edges for two triangles; more where the boundary is long.
  reserve(points.size(), triangles.size() + triangles.size() / 2 + points.size() / 4, triangles.size());
  for (const Point3& p : points) add_vertex(Point(p.x(), p.y(), p.z()));
  AddTriangles(triangles);
}

void PatchMesh::AddTriangles(std::span<const Triangle> triangles) {
  for (const Triangle& t : triangles) {
    if (!Add(t)) refused_.push_back({added_, ReasonToRefuse(t)});
    ++added_;
  }
}

bool PatchMesh::Add(const Triangle& t) {
  if (HasRepeatedCorner(t)) return false;
  const FaceHandle face = add_face(VertexHandle(t[0]), VertexHandle(t[1]), VertexHandle(t[2]));
  if (!face.is_valid()) return false;
  // OpenMesh begins with the last edge.
  set_halfedge_handle(face, next_halfedge_handle(halfedge_handle(face)));
  return true;
}

Refusal PatchMesh::ReasonToRefuse(const Triangle& t) const {
  if (HasRepeatedCorner(t)) return Refusal::kCorners;
  for (int k = 0; k < 3; ++k) {
    const HalfedgeHandle edge = HalfEdge(t[k], t[(k + 1) % 3]);
    if (edge.is_valid() && !is_boundary(edge)) return Refusal::kEdge;
  }
  return Refusal::kVertex;
}

int32_t PatchMesh::TriangleOf(FaceHandle face) const {
  int32_t triangle = face.idx();
  for (const RefusedTriangle& r : refused_) {
    if (r.triangle > triangle) break;
    ++triangle;
  }
  return triangle;
}

Triangle PatchMesh::Corners(FaceHandle face) const {
  const HalfedgeHandle first = halfedge_handle(face), second = next_halfedge_handle(first);
  return {from_vertex_handle(first).idx(), to_vertex_handle(first).idx(), to_vertex_handle(second).idx()};
}

std::vector<Triangle> PatchMesh::Triangles() const {
  std::vector<Triangle> triangles;
  triangles.reserve(n_faces());
  for (const FaceHandle face : all_faces()) triangles.push_back(Corners(face));
  return triangles;
}

void PatchMesh::FacesAround(VertexHandle vertex, std::vector<FaceHandle>& faces) const {
  faces.clear();
  for (const FaceHandle face : vf_range(vertex)) faces.push_back(face);
  std::sort(faces.begin(), faces.end());
}

std::vector<std::pair<int32_t, int32_t>> PatchMesh::BoundaryEdges() const {
  std::vector<std::pair<int32_t, int32_t>> edges;
  for (const FaceHandle face : all_faces()) {
    for (const HalfedgeHandle h : fh_range(face)) {
      if (is_boundary(opposite_halfedge_handle(h))) {
        edges.emplace_back(from_vertex_handle(h).idx(), to_vertex_handle(h).idx());
      }
    }
  }
  return edges;
}

void PatchMesh::FlipEdge(EdgeHandle edge) {
  const HalfedgeHandle a = halfedge_handle(edge, 0), b = halfedge_handle(edge, 1);
  const FaceHandle near = face_handle(a), far = face_handle(b);
  const HalfedgeHandle near_start = StartAfterFlip(near, a, b), far_start = StartAfterFlip(far, b, a);
  flip(edge);
  set_halfedge_handle(near, near_start);
  set_halfedge_handle(far, far_start);
}

// Which half-edge will leave the first corner of a face. `own` is its side of the edge, `other` the other side.
PatchMesh::HalfedgeHandle PatchMesh::StartAfterFlip(FaceHandle face, HalfedgeHandle own, HalfedgeHandle other) const {
  const HalfedgeHandle start = halfedge_handle(face);
  if (start == own) return next_halfedge_handle(other);
  return start == next_halfedge_handle(own) ? own : start;
}

}  // namespace tilemend
