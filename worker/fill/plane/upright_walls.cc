#include "worker/fill/plane/upright_walls.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "common/mesh/rounding.h"
#include "common/records/flat_water.h"

namespace tilemend {
namespace {

// Of its size: a rim vertex that is closer to the surface needs no wall; at level water one within kFlatWithin.
constexpr double kLeastHeight = 0.125;

class WallRaiser {
 public:
  WallRaiser(const LocalHole& hole, std::span<const double> ground, LocalPatch& patch)
      : hole_(hole), ground_(ground), patch_(patch), foot_(hole.vertices.size(), -1) {}

  std::vector<int32_t> Run() {
    LayFeet();
    for (Triangle& t : patch_.triangles) {
      for (int32_t& v : t) v = Lowered(v);
    }
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

  // Of each vertex: whether the boundary comes by once, and not to and fro along one edge.
  std::vector<bool> SimplePasses() const {
    std::vector<int> passes(hole_.vertices.size(), 0);
    for (const RegionSegment& s : hole_.segments) ++passes[s.from];
    for (size_t k = 1; k < hole_.boundary.size(); ++k) {
      if (hole_.boundary[k] == hole_.boundary[k - 1])
        passes[hole_.boundary[k].first] = passes[hole_.boundary[k].second] = 0;
    }
    std::vector<bool> simple;
    for (const int n : passes) simple.push_back(n == 1);
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

  // The surface has the edge between the lowered ends.
  void AddWall(int32_t from, int32_t to) {
    const int32_t below_from = Lowered(from), below_to = Lowered(to);
    if (below_to != to) patch_.triangles.push_back({from, to, below_to});
    if (below_from != from) patch_.triangles.push_back({from, below_to, below_from});
  }

  const LocalHole& hole_;
  const std::span<const double> ground_;
  LocalPatch& patch_;
  std::vector<int32_t> foot_;  // of each vertex of the hole: the new one straight below it, else -1
};

}  // namespace

std::vector<int32_t> RaiseWalls(const LocalHole& hole, std::span<const double> ground, LocalPatch& patch) {
  return hole.on_object.empty() ? std::vector<int32_t>() : WallRaiser(hole, ground, patch).Run();
}

}  // namespace tilemend
