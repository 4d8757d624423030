#include "worker/fill/plane/upright_walls.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "common/records/flat_water.h"

namespace tilemend {
namespace {

// Of its size: a rim vertex that is closer to the surface needs no wall; at level water one within kFlatWithin.
constexpr double kLeastHeight = 0.125;

// Where a rim edge passes through the surface, the surface ends beside it: so far from there, in metres, as the foot of
// a wall from an object (coordinator/plan/overlap/wall_feet.h), and no farther than this share of its triangle.
constexpr double kBeside = 0.02, kMostBeside = 0.25;

// How far into the hole the foot of a wall lies, in steps of the lattice, so that rounding leaves it inside: a triangle
// of a wall then faces up a little. Where tiles overlap feet lie below their vertices, where both tiles find them.
constexpr double kLeanSteps = 4;

// 1 - cos of the sharpest corner of the rim whose foot is moved, 8 degrees: there it lies 6 cm from its vertex.
constexpr double kLeastOpen = 0.01;

double Turn(const Point3& a, const Point3& b, const Point3& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

double ExtentFromAbove(const LocalHole& hole) {
  Point2 lo = hole.positions[0].head<2>(), hi = lo;
  for (const Point3& p : hole.positions) {
    lo = lo.cwiseMin(p.head<2>());
    hi = hi.cwiseMax(p.head<2>());
  }
  return (hi - lo).norm();
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
    if (!hole_.own_outline) LeanWalls();
    FindEdges();
    for (const RegionSegment& s : hole_.segments) AddWall(s.from, s.to);
    return std::move(foot_);
  }

 private:
  void LayFeet() {
    const std::vector<bool> simple = SimplePasses();
    const double most = ExtentFromAbove(hole_);
    for (int32_t v = 0; v < hole_.size(); ++v) {
      const double height = std::abs(hole_.positions[v].z() - ground_[v]);
      if (!hole_.on_object[v] || !simple[v] || IsShared(v) || height < LeastHeight(v) || height > most) continue;
      foot_[v] = hole_.size() + static_cast<int32_t>(patch_.new_points.size());
      Point3& foot = patch_.new_points.emplace_back(hole_.positions[v]);
      foot.z() = hole_.Storable({0, 0, ground_[v]}).z();
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

  // Moves feet into the hole, as far as the patch stays a height field.
  void LeanWalls() {
    std::vector<Point2> across(hole_.vertices.size(), Point2(0, 0));  // sum of the units across both segments
    for (const auto& [from, to] : hole_.segments) {
      const Point2 way = (hole_.positions[to] - hole_.positions[from]).head<2>();
      const Point2 left = Point2(-way.y(), way.x()) / std::max(way.norm(), std::numeric_limits<double>::min());
      across[from] += left;
      across[to] += left;
    }
    for (int32_t v = 0; v < hole_.size(); ++v) {
      const double open = across[v].squaredNorm() / 2;
      if (foot_[v] < 0 || !(open > kLeastOpen)) continue;
      Point3& foot = patch_.new_points[foot_[v] - hole_.size()];
      foot.head<2>() += kLeanSteps * hole_.cell->lattice_step / open * across[v];
      foot = hole_.Storable(foot);
    }
    while (StraightenFoldedWalls()) {
    }
  }

  // Puts feet below their vertices where a triangle would face down. False if there were none.
  bool StraightenFoldedWalls() {
    bool found = false;
    const auto look = [&](const Triangle& t, bool may_stand_upright) {
      const double turn = Turn(At(t[0]), At(t[1]), At(t[2]));
      if (turn > 0 || (turn == 0 && may_stand_upright)) return;
      for (const int32_t v : t) found |= Straighten(v);
    };
    for (const Triangle& t : patch_.triangles) look(t, false);
    for (const auto& [from, to] : hole_.segments) {
      look({from, to, Lowered(to)}, true);
      look({from, Lowered(to), Lowered(from)}, true);
    }
    return found;
  }

  // False if it is no foot of a wall that leans.
  bool Straighten(int32_t foot) {
    const auto v = std::ranges::find(foot_, foot);
    if (foot < hole_.size() || v == foot_.end()) return false;
    const Point2 above = hole_.positions[v - foot_.begin()].head<2>();
    Point3& place = patch_.new_points[foot - hole_.size()];
    if (place.head<2>() == above) return false;
    place.head<2>() = above;
    return true;
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
    beside = hole_.Storable(beside);
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
  std::vector<int32_t> foot_;  // of each vertex of the hole: the new one below it, else -1
  // The triangle of the surface at each edge, between feet, that a rim edge passes through; -1: none.
  std::map<std::pair<int32_t, int32_t>, int32_t> triangle_at_;
};

}  // namespace

std::vector<int32_t> RaiseWalls(const LocalHole& hole, std::span<const double> ground, LocalPatch& patch) {
  return hole.on_object.empty() ? std::vector<int32_t>() : WallRaiser(hole, ground, patch).Run();
}

}  // namespace tilemend
