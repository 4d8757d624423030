#include "worker/fill/mesh/patch_mesh.h"

#include <OpenMesh/Core/System/omstream.hh>
#include <algorithm>

#include "common/mesh/vertex_lists.h"

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

// Links a list of triangles at once: to add them one at a time takes OpenMesh three times as long, of which a fill of a
// large patch would notice. Half-edge 4 t + k of the list runs from corner k of triangle t to the next.
class Linker {
 public:
  using HalfedgeHandle = PatchMesh::HalfedgeHandle;
  using VertexHandle = PatchMesh::VertexHandle;
  using FaceHandle = PatchMesh::FaceHandle;

  // Precondition: the mesh has vertices and nothing else. It must outlive the linker.
  Linker(std::span<const Triangle> triangles, PatchMesh& mesh)
      : triangles_(triangles), mesh_(mesh), leaving_(CornersAt(triangles, mesh.n_vertices())) {}

  // False, with links that are worth nothing, if the triangles form no manifold.
  bool Run() {
    if (!NumberHalfEdges()) return false;
    mesh_.resize(mesh_.n_vertices(), static_cast<size_t>(edges_), triangles_.size());
    LinkTriangles();
    for (const VertexHandle v : mesh_.all_vertices()) {
      if (!LinkFans(v)) return false;
    }
    return true;
  }

 private:
  static int32_t Next(int32_t h) { return (h & 3) == 2 ? h - 2 : h + 1; }
  int32_t Origin(int32_t h) const { return triangles_[h >> 2][h & 3]; }
  int32_t Target(int32_t h) const { return Origin(Next(h)); }

  // The next one of the list: every fourth number stands for none.
  static int32_t Following(int32_t h) { return (h & 3) == 2 ? h + 2 : h + 1; }

  // One from one vertex to another, -1 if there is none, -2 if there are several.
  int32_t Find(int32_t from, int32_t to) const {
    int32_t found = -1;
    for (const int32_t h : leaving_.Of(from)) {
      if (Target(h) == to) found = found == -1 ? h : -2;
    }
    return found;
  }

  // Numbers the edges with their two sides. False if an edge has more or such as run the same way.
  bool NumberHalfEdges() {
    number_.assign(4 * triangles_.size(), -1);
    const auto end = static_cast<int32_t>(number_.size());
    for (int32_t h = 0; h < end; h = Following(h)) {
      if (number_[h] >= 0) continue;
      const int32_t from = Origin(h), to = Target(h), twin = Find(to, from);
      if (from == to || twin == -2 || (twin == -1 && Find(from, to) != h)) return false;
      if (twin >= 0 && number_[twin] >= 0) return false;
      number_[h] = 2 * edges_++;
      if (twin >= 0) number_[twin] = number_[h] + 1;
    }
    return true;
  }

  void LinkTriangles() {
    const auto end = static_cast<int32_t>(number_.size());
    for (int32_t h = 0; h < end; h = Following(h)) {
      const HalfedgeHandle own(number_[h]), other = mesh_.opposite_halfedge_handle(own);
      mesh_.set_vertex_handle(own, VertexHandle(Target(h)));
      mesh_.set_vertex_handle(other, VertexHandle(Origin(h)));
      mesh_.set_face_handle(own, FaceHandle(h >> 2));
      mesh_.set_next_halfedge_handle(own, HalfedgeHandle(number_[Next(h)]));
      mesh_.set_halfedge_handle(VertexHandle(Origin(h)), own);
    }
    for (int32_t h = 0; h < end; h += 4) mesh_.set_halfedge_handle(FaceHandle(h >> 2), HalfedgeHandle(number_[h]));
  }

  // Links the boundary from each open fan around a vertex to the next one. False if one of several fans is closed.
  bool LinkFans(VertexHandle v) {
    const std::span<const int32_t> leaving = leaving_.Of(v.idx());
    size_t faces = 0;
    fans_.clear();
    for (const int32_t h : leaving) {
      const HalfedgeHandle first(number_[h]), in = mesh_.opposite_halfedge_handle(first);
      if (mesh_.is_boundary(in)) fans_.emplace_back(in, FanEnd(first, faces));
    }
    if (fans_.empty() && !leaving.empty()) FanEnd(HalfedgeHandle(number_[leaving[0]]), faces);
    for (size_t i = 0; i < fans_.size(); ++i) {
      mesh_.set_next_halfedge_handle(fans_[i].first, fans_[(i + 1) % fans_.size()].second);
    }
    if (!fans_.empty()) mesh_.set_halfedge_handle(v, fans_[0].second);
    return faces == leaving.size();
  }

  // The half-edge at which the fan from `first` on ends: on the boundary, or `first` again.
  HalfedgeHandle FanEnd(HalfedgeHandle first, size_t& faces) const {
    HalfedgeHandle h = first;
    do {
      h = mesh_.opposite_halfedge_handle(mesh_.prev_halfedge_handle(h));
      ++faces;
    } while (h != first && !mesh_.is_boundary(h));
    return h;
  }

  std::span<const Triangle> triangles_;
  PatchMesh& mesh_;
  const VertexLists leaving_;    // half-edges by origin
  std::vector<int32_t> number_;  // of each half-edge in the mesh
  int32_t edges_ = 0;
  std::vector<std::pair<HalfedgeHandle, HalfedgeHandle>> fans_;  // the boundary into each and out of it
};

}  // namespace

PatchMesh::PatchMesh(std::span<const Point3> points, std::span<const Triangle> triangles) {
  SilenceOpenMesh();
  resize(points.size(), 0, 0);
  for (size_t v = 0; v < points.size(); ++v) SetPosition(VertexHandle(static_cast<int>(v)), points[v]);
  if (Linker(triangles, *this).Run()) {
    added_ = static_cast<int32_t>(triangles.size());
    return;
  }
  resize(points.size(), 0, 0);
  for (const VertexHandle v : all_vertices()) set_isolated(v);
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

TriangleRefusal PatchMesh::ReasonToRefuse(const Triangle& t) const {
  if (HasRepeatedCorner(t)) return TriangleRefusal::kCorners;
  for (int k = 0; k < 3; ++k) {
    const HalfedgeHandle edge = HalfEdge(t[k], t[(k + 1) % 3]);
    if (edge.is_valid() && !is_boundary(edge)) return TriangleRefusal::kEdge;
  }
  return TriangleRefusal::kVertex;
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
