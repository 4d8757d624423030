#include "worker/fill/plane/upright_walls.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "common/mesh/rounding.h"
#include "common/records/flat_water.h"

namespace tilemend {
namespace {

// Of its size: a rim vertex that is closer to the surface needs no wall; at level water one within kFlatWithin.
constexpr double kLeastHeight = 0.125;

// Where a rim edge passes through the surface, the surface ends beside it: so far from there, in metres, as the foot of
// a wall from an object (coordinator/plan/overlap/wall_feet.h), and no farther than this share of its triangle.
constexpr double kBeside = 0.02, kMostBeside = 0.25;

double Turn(const Point3& a, const Point3& b, const Point3& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

class WallRaiser {
 public:
  WallRaiser(const LocalHole& hole, std::span<const double> ground, LocalPatch& patch)
      : hole_(hole), ground_(ground), patch_(patch), foot_(hole.vertices.size(), -1) {}

  std::vector<int32_t> Run() {
    LayFeet();
    for (Triangle& t : patch_.triangles) {
      for (int32_t& v : t) v = Lowered(v);
    }
    FindEdges();
    for (const RegionSegment& s : hole_.segments) AddWall(s.from, s.to);
    return std::move(foot_);
  }

 private:
  void LayFeet() {
    const std::vector<bool> simple = SimplePasses();
    const double most = ExtentFromAbove();
    for (int32_t v = 0; v < hole_.size(); ++v) {
      const double height = std::abs(hole_.positions[v].z() - ground_[v]);
      if (!hole_.on_object[v] || !simple[v] || IsShared(v) || height < LeastHeight(v) || height > most) continue;
      foot_[v] = hole_.size() + static_cast<int32_t>(patch_.new_points.size());
      Point3& foot = patch_.new_points.emplace_back(hole_.positions[v]);
      foot.z() = StorableHeight(ground_[v]);
    }
  }

  // Of each vertex: whether the boundary comes by once, and not to and fro along one edge, and no other hole's does.
  // Two walls that stand on one foot would share an edge of four triangles.
  std::vector<bool> SimplePasses() const {
    std::vector<int> passes(hole_.vertices.size(), 0);
    for (const RegionSegment& s : hole_.segments) ++passes[s.from];
    for (size_t k = 1; k < hole_.boundary.size(); ++k) {
      if (hole_.boundary[k] == hole_.boundary[k - 1])
        passes[hole_.boundary[k].first] = passes[hole_.boundary[k].second] = 0;
    }
    std::vector<bool> simple;
    for (int32_t v = 0; v < hole_.size(); ++v) {
      const int32_t in_cell = hole_.vertices[v];
      simple.push_back(passes[v] == 1 && (in_cell < 0 || hole_.band->Passes(in_cell) <= 1));
    }
    return simple;
  }

  // Whether a seam ends at the vertex, which the hole of another cell must see as this one does.
  bool IsShared(int32_t v) const { return !hole_.own_outline && !hole_.has_equation[v]; }

  double LeastHeight(int32_t v) const { return hole_.level ? kFlatWithin : kLeastHeight * hole_.sizes[v]; }

  double ExtentFromAbove() const {
    Point2 lo = hole_.positions[0].head<2>(), hi = lo;
    for (const Point3& p : hole_.positions) {
      lo = lo.cwiseMin(p.head<2>());
      hi = hi.cwiseMax(p.head<2>());
    }
    return (hi - lo).norm();
  }

  double StorableHeight(double z) const {
    return RoundedTo(hole_.cell->float32 ? NumberType::kFloat32 : NumberType::kFloat64,
                     RoundedToLattice(z, hole_.cell->lattice_step));
  }

  int32_t Lowered(int32_t v) const { return v < hole_.size() && foot_[v] >= 0 ? foot_[v] : v; }

  const Point3& At(int32_t v) const {
    return v < hole_.size() ? hole_.positions[v] : patch_.new_points[v - hole_.size()];
  }

  // Whether a rim edge is above level water at one end and below it at the other. Rims that pass through ground are
  // rare; there what crosses is closed anew (space/mend_crossings.h).
  bool PassesThrough(int32_t from, int32_t to) const {
    return hole_.level && foot_[from] >= 0 && foot_[to] >= 0 &&
           (hole_.positions[from].z() > At(foot_[from]).z()) != (hole_.positions[to].z() > At(foot_[to]).z());
  }

  // Triangles of the surface that walls divide, by their edges.
  void FindEdges() {
    for (const RegionSegment& s : hole_.segments) {
      if (PassesThrough(s.from, s.to)) triangle_at_[{foot_[s.from], foot_[s.to]}] = -1;
    }
    if (triangle_at_.empty()) return;
    for (size_t t = 0; t < patch_.triangles.size(); ++t) NoteEdges(static_cast<int32_t>(t));
  }

  void NoteEdges(int32_t t) {
    const Triangle& corners = patch_.triangles[t];
    for (int k = 0; k < 3; ++k) {
      if (const auto at = triangle_at_.find({corners[k], corners[(k + 1) % 3]}); at != triangle_at_.end())
        at->second = t;
    }
  }

  // Two upright triangles between an edge and a surface that it passes through would overlap each other. There the
  // surface gets a vertex beside its edge, and the wall goes around it. False if it has no room for one.
  bool AddWallBeside(int32_t from, int32_t to) {
    const int32_t a = foot_[from], b = foot_[to], t = triangle_at_.at({a, b});
    if (t < 0) return false;
    const Triangle corners = patch_.triangles[t];
    const int32_t apex = corners[0] != a && corners[0] != b   ? corners[0]
                         : corners[1] != a && corners[1] != b ? corners[1]
                                                              : corners[2];
    const double above = std::abs(hole_.positions[from].z() - At(a).z());
    const double below = std::abs(hole_.positions[to].z() - At(b).z());
    const Point3 through = At(a) + above / (above + below) * (At(b) - At(a));
    Point3 beside = through;  // at its height, so that water stays level
    const Point2 inward = (At(apex) - through).head<2>();
    beside.head<2>() += std::min(kBeside / inward.norm(), kMostBeside) * inward;
    beside = RoundedToLattice(beside, hole_.cell->lattice_step);
    beside = RoundedTo(hole_.cell->float32 ? NumberType::kFloat32 : NumberType::kFloat64, beside);
    const bool has_room =
        Turn(At(a), At(b), beside) > 0 && Turn(At(b), At(apex), beside) > 0 && Turn(At(apex), At(a), beside) > 0;
    if (!has_room) return false;
    const int32_t v = hole_.size() + static_cast<int32_t>(patch_.new_points.size());
    patch_.new_points.push_back(beside);
    patch_.triangles[t] = {a, v, apex};
    patch_.triangles.push_back({v, b, apex});
    triangle_at_.at({a, b}) = -1;
    NoteEdges(t);
    NoteEdges(static_cast<int32_t>(patch_.triangles.size()) - 1);
    for (const Triangle& wall : {Triangle{from, to, v}, Triangle{to, b, v}, Triangle{from, v, a}})
      patch_.triangles.push_back(wall);
    return true;
  }

  // The surface has the edge between the lowered ends.
  void AddWall(int32_t from, int32_t to) {
    const int32_t below_from = Lowered(from), below_to = Lowered(to);
    if (PassesThrough(from, to) && AddWallBeside(from, to)) return;
    if (below_to != to) patch_.triangles.push_back({from, to, below_to});
    if (below_from != from) patch_.triangles.push_back({from, below_to, below_from});
  }

  const LocalHole& hole_;
  const std::span<const double> ground_;
  LocalPatch& patch_;
  std::vector<int32_t> foot_;  // of each vertex of the hole: the new one straight below it, else -1
  // The triangle of the surface at each edge, between feet, that a rim edge passes through; -1: none.
  std::map<std::pair<int32_t, int32_t>, int32_t> triangle_at_;
};

}  // namespace

std::vector<int32_t> RaiseWalls(const LocalHole& hole, std::span<const double> ground, LocalPatch& patch) {
  return hole.on_object.empty() ? std::vector<int32_t>() : WallRaiser(hole, ground, patch).Run();
}

}  // namespace tilemend
