#include "worker/papers/front/split_rim.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <vector>

#include "common/mesh/triangle_shape.h"
#include "worker/fill/mesh/patch_mesh.h"

namespace tilemend {
namespace {

using HalfEdge = PatchMesh::HalfedgeHandle;
using Vertex = PatchMesh::VertexHandle;

// Adds the points between two ends, in order, to the loop.
void Halve(int32_t from, int32_t to, double longest, FrontRim& rim, std::vector<int32_t>& loop) {
  const Point3 a = rim.points[from], b = rim.points[to];
  if (!((b - a).norm() > longest)) return;
  const auto middle = static_cast<int32_t>(rim.points.size());
  rim.points.emplace_back((a + b) / 2);
  rim.areas.emplace_back(rim.areas[from] + rim.areas[to]);
  rim.neighbours.push_back({a, b});
  rim.sizes.push_back((rim.sizes[from] + rim.sizes[to]) / 2);
  Halve(from, middle, longest, rim, loop);
  loop.push_back(middle);
  Halve(middle, to, longest, rim, loop);
}

class Tier {
 public:
  Tier(int32_t rim, const std::function<bool(int32_t, int32_t)>& may_join, const FrontPatch& patch)
      : rim_(rim), may_join_(may_join), mesh_(patch.points, patch.triangles) {}

  bool IsManifold() const { return mesh_.IsManifold(); }

  bool Remove(int32_t v) {
    const HalfEdge ahead = mesh_.halfedge_handle(Vertex(v));
    if (!ahead.is_valid() || !mesh_.is_boundary(ahead)) return false;
    const HalfEdge back = mesh_.opposite_halfedge_handle(mesh_.prev_halfedge_handle(ahead));
    const double by_ahead = QualityAfter(ahead), by_back = QualityAfter(back);
    if (std::max(by_ahead, by_back) <= 0) return false;
    mesh_.collapse(by_ahead >= by_back ? ahead : back);
    return true;
  }

  std::vector<Triangle> Triangles() const {
    std::vector<Triangle> triangles;
    for (const auto face : mesh_.faces()) triangles.push_back(mesh_.Corners(face));
    return triangles;
  }

 private:
  // The least quality of what is left around the vertex that a half-edge leaves, if that goes to its other end; 0 if it
  // may not.
  double QualityAfter(HalfEdge half_edge) {
    if (!mesh_.is_collapse_ok(half_edge)) return 0;
    const Vertex from = mesh_.from_vertex_handle(half_edge), to = mesh_.to_vertex_handle(half_edge);
    double least = std::numeric_limits<double>::infinity();
    for (const auto face : mesh_.vf_range(from)) {
      Triangle t = mesh_.Corners(face);
      if (std::find(t.begin(), t.end(), to.idx()) != t.end()) continue;
      const Eigen::Vector3d before = AreaOf(t);
      std::replace(t.begin(), t.end(), from.idx(), to.idx());
      if (AreaOf(t).dot(before) <= 0 || !MayHave(t, to.idx())) return 0;
      least = std::min(least, TriangleQuality(At(t[0]), At(t[1]), At(t[2])));
    }
    return least;
  }

  bool MayHave(const Triangle& t, int32_t to) const {
    return to >= rim_ || std::all_of(t.begin(), t.end(), [&](int32_t v) {
             return v == to || v >= rim_ || mesh_.HalfEdge(to, v).is_valid() || IsNextTo(to, v) || may_join_(to, v);
           });
  }

  // Whether the last split point between two points of the rim is to go: the rim has an edge there.
  bool IsNextTo(int32_t a, int32_t b) const { return !may_join_(a, b) && SharesSplitPoint(a, b); }
  bool SharesSplitPoint(int32_t a, int32_t b) const {
    for (const auto v : mesh_.vv_range(Vertex(a))) {
      if (v.idx() >= rim_ && mesh_.is_boundary(v) && mesh_.HalfEdge(v.idx(), b).is_valid()) return true;
    }
    return false;
  }

  Point3 At(int32_t v) const { return mesh_.Position(Vertex(v)); }
  Eigen::Vector3d AreaOf(const Triangle& t) const { return TwiceVectorArea(At(t[0]), At(t[1]), At(t[2])); }

  const int32_t rim_;
  const std::function<bool(int32_t, int32_t)>& may_join_;
  PatchMesh mesh_;
};

}  // namespace

int32_t SplitLongEdges(double longest, FrontRim& rim) {
  const auto before = std::ssize(rim.points);
  for (std::vector<int32_t>& loop : rim.loops) {
    std::vector<int32_t> split;
    for (size_t i = 0; i < loop.size(); ++i) {
      split.push_back(loop[i]);
      Halve(loop[i], loop[(i + 1) % loop.size()], longest, rim, split);
    }
    loop = std::move(split);
  }
  return static_cast<int32_t>(std::ssize(rim.points) - before);
}

bool TieBack(int32_t rim, int32_t split, const std::function<bool(int32_t, int32_t)>& may_join, FrontPatch& patch) {
  if (split == 0) return true;
  Tier tier(rim, may_join, patch);
  if (!tier.IsManifold()) return false;
  for (int32_t v = rim + split - 1; v >= rim; --v) {
    if (!tier.Remove(v)) return false;
  }
  patch.triangles = tier.Triangles();
  for (Triangle& t : patch.triangles) {
    for (int32_t& v : t) v -= v < rim ? 0 : split;
  }
  patch.points.erase(patch.points.begin() + rim, patch.points.begin() + rim + split);
  return true;
}

}  // namespace tilemend
