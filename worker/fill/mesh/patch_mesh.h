// The half-edges of a patch and of the band around it.
#ifndef TILEMEND_WORKER_FILL_MESH_PATCH_MESH_H_
#define TILEMEND_WORKER_FILL_MESH_PATCH_MESH_H_

#include <OpenMesh/Core/Geometry/VectorT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// Why a triangle has no place in a PatchMesh.
enum class TriangleRefusal {
  kCorners,  // two of its corners are one vertex
  kEdge,     // another triangle runs along one of its edges in the same direction: an edge with three triangles, one
             // that turns over (a Moebius strip), or a triangle that is there twice
  kVertex,   // a corner is surrounded by triangles already, or would be with others left over
};

struct RefusedTriangle {
  int32_t triangle;  // its place among all that were added
  TriangleRefusal reason;
};

struct PatchTraits : public OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
  VertexAttributes(OpenMesh::Attributes::Status);
  HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
};

// A patch, alone or with its band, as an OpenMesh mesh. Code that walks from triangle to triangle or around a vertex,
// or that flips, splits or deletes, belongs on it. Equations that are solved keep arrays of triangles: a pass over all
// of them is faster there. All of OpenMesh's interface is open (circulators, is_flip_ok, split, delete_face,
// properties). This adds what a list of triangles needs to come in and go out again without loss.
//
//   PatchMesh mesh(points, patch);
//   mesh.AddTriangles(band);
//   if (!mesh.IsManifold()) return mesh.refused();
//   for (const auto v : mesh.vv_range(PatchMesh::VertexHandle(rim_vertex))) ...
//
// Numbers. Vertex v is points[v], also if no triangle has it. Faces have the order of the triangles, without the
// refused ones; a split adds new ones at the end. The first corner of a triangle stays first, and a flip puts the new
// corner where the old one was. So mesh.Triangles() gives what came in, changed only where something was changed.
//
// Manifolds. OpenMesh holds only triangles that run along each edge at most once in each direction and form fans around
// each vertex. A vertex has one closed fan, or any number of open ones (a pinched vertex; circulators pass through them
// all). Others are refused: the earlier of two triangles in each other's way stays. They are kept in refused(), so that
// none is lost silently, and the mesh is valid without them.
//
// Memory: some 80 bytes a triangle. Building: linear for vertices of bounded degree; the constructor links a manifold
// at once, in a third of the time of AddTriangles. Any number of threads, each with its own mesh. OpenMesh's messages
// on stderr are switched off for the whole process.
class PatchMesh : public OpenMesh::TriMesh_ArrayKernelT<PatchTraits> {
 public:
  PatchMesh() : PatchMesh({}, {}) {}
  // Precondition: corners are in [0, points.size()).
  PatchMesh(std::span<const Point3> points, std::span<const Triangle> triangles);

  // Adds triangles over the vertices that there are; reports the refused ones in refused().
  void AddTriangles(std::span<const Triangle> triangles);

  Point3 Position(VertexHandle vertex) const { return Point3(point(vertex).data()); }
  void SetPosition(VertexHandle vertex, const Point3& p) { set_point(vertex, Point(p.x(), p.y(), p.z())); }

  // In the order of the triangles.
  std::span<const RefusedTriangle> refused() const { return refused_; }
  bool IsManifold() const { return refused_.empty(); }
  // The place of a face among all triangles that were added. Precondition: none was split or deleted. O(refused).
  int32_t TriangleOf(FaceHandle face) const;

  // The half-edge between two vertices; not valid if there is none. O(degree).
  HalfedgeHandle HalfEdge(int32_t from, int32_t to) const {
    return find_halfedge(VertexHandle(from), VertexHandle(to));
  }

  // The corners, the first one where halfedge_handle(face) begins.
  Triangle Corners(FaceHandle face) const;
  // The corner of the half-edge's triangle that is not on it. Precondition: the half-edge has a triangle.
  int32_t Apex(HalfedgeHandle half_edge) const { return to_vertex_handle(next_halfedge_handle(half_edge)).idx(); }
  // The corners of all faces. Precondition: no deleted ones (garbage_collection).
  std::vector<Triangle> Triangles() const;
  // The faces around a vertex in rising order: a sum over them has the same bits however the mesh was built or walked.
  void FacesAround(VertexHandle vertex, std::vector<FaceHandle>& faces) const;
  // The edges with one triangle, which lies on their left: from, to; in the order of the triangles and their corners.
  std::vector<std::pair<int32_t, int32_t>> BoundaryEdges() const;

  // Turns an edge in the quadrilateral of its two triangles. Each keeps its number and one end of the edge: that with
  // the half-edge a -> b keeps a. Precondition: is_flip_ok(edge).
  void FlipEdge(EdgeHandle edge);

 private:
  bool Add(const Triangle& triangle);
  TriangleRefusal ReasonToRefuse(const Triangle& triangle) const;
  HalfedgeHandle StartAfterFlip(FaceHandle face, HalfedgeHandle own, HalfedgeHandle other) const;

  int32_t added_ = 0;  // the refused ones among them
  std::vector<RefusedTriangle> refused_;
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_MESH_PATCH_MESH_H_
