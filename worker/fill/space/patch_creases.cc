#include "worker/fill/space/patch_creases.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

#include "common/mesh/edge_key.h"
#include "common/mesh/rounding.h"
#include "common/mesh/triangle_shape.h"
#include "common/mesh/vertex_lists.h"

namespace tilemend {
namespace {

using Eigen::Vector3d;
using Edge = std::pair<int32_t, int32_t>;  // directed, as a triangle of the patch runs along it

constexpr double kCreaseCosine = -0.5;
constexpr double kSpikeEdges = 2;
// How far bevels reach from the crease, of the height of the triangle that they are cut from; tried in this order.
constexpr double kReaches[] = {0.3, 0.1, 0.03};
// Of a sum of two unit vectors: folds that are flatter have no direction to turn in.
constexpr double kLeastTurn = 1e-3;
// Bevels may crease against their own neighbours, and be bevelled again.
constexpr int kCreaseRounds = 3;

// The triangles at one vertex together.
struct Tip {
  void Add(const SpaceTriangle& t, int corner) {
    const Vector3d u = t[(corner + 1) % 3] - t[corner], w = t[(corner + 2) % 3] - t[corner];
    angle_rad += std::atan2(u.cross(w).norm(), u.dot(w));
    to_it += (u.norm() + w.norm()) / 2;
    about_it += (u - w).norm();
  }
  bool IsSpike() const { return to_it > kSpikeEdges * about_it && angle_rad < std::numbers::pi / 2; }

  double angle_rad = 0, to_it = 0, about_it = 0;
};

class Bevelling {
 public:
  Bevelling(const LocalHole& hole, LocalPatch patch) : hole_(hole), patch_(std::move(patch)) {
    beside_.reserve(3 * patch_.triangles.size());
    for (size_t t = 0; t < patch_.triangles.size(); ++t) Register(static_cast<int32_t>(t));
  }

  const LocalPatch& patch() const { return patch_; }

  std::vector<Edge> Creases() const {
    std::vector<Edge> creases;
    for (const Triangle& t : patch_.triangles) {
      for (int k = 0; k < 3; ++k) {
        const Edge edge{t[k], t[(k + 1) % 3]};
        const bool twice = edge.first > edge.second && Beside({edge.second, edge.first}) >= 0;
        if (!twice && IsCrease(edge)) creases.push_back(edge);
      }
    }
    return creases;
  }

  //   spared  edges that are to stay as they are
  void BevelAll(const std::set<Edge>& spared) {
    for (const Edge& edge : Creases()) {
      if (spared.contains(edge) || !IsCrease(edge)) continue;
      const bool inside = Beside({edge.second, edge.first}) >= 0;
      if (!Bevel(edge) && inside) Bevel({edge.second, edge.first});
    }
  }

  // Which edge a triangle came from by a bevel, if it did.
  const std::map<int32_t, Edge>& made() const { return made_; }

 private:
  void Register(int32_t t) {
    for (int k = 0; k < 3; ++k) beside_[EdgeKey(patch_.triangles[t][k], patch_.triangles[t][(k + 1) % 3])] = t;
  }

  // The triangle that runs along an edge; -1 if none does.
  int32_t Beside(const Edge& edge) const {
    const auto it = beside_.find(EdgeKey(edge.first, edge.second));
    return it == beside_.end() ? -1 : it->second;
  }

  Point3 At(int32_t v) const { return v < hole_.size() ? hole_.positions[v] : patch_.new_points[v - hole_.size()]; }

  Vector3d NormalOf(const Triangle& t) const { return TwiceVectorArea(InSpace(hole_, patch_, t)).normalized(); }

  // Of what lies on the other side of an edge; zero if nothing does.
  Vector3d NormalBeyond(const Edge& edge) const {
    const int32_t back = Beside({edge.second, edge.first});
    if (back >= 0) return NormalOf(patch_.triangles[back]);
    const bool on_rim = edge.first < hole_.size() && edge.second < hole_.size();
    return on_rim ? hole_.NormalBeside(edge.first, edge.second) : Vector3d::Zero();
  }

  bool IsCrease(const Edge& edge) const {
    return NormalOf(patch_.triangles[Beside(edge)]).dot(NormalBeyond(edge)) < kCreaseCosine;
  }

  int CountAround(const Triangle& t) const {
    int creases = 0;
    for (int k = 0; k < 3; ++k) creases += IsCrease({t[k], t[(k + 1) % 3]});
    return creases;
  }

  bool Bevel(const Edge& edge) {
    const auto [a, b] = edge;
    const int32_t t = Beside(edge), tip = hole_.size() + static_cast<int32_t>(patch_.new_points.size());
    const Triangle before = patch_.triangles[t];
    const int32_t d = before[0] + before[1] + before[2] - a - b;
    const Vector3d along = (At(b) - At(a)).normalized(), beyond = NormalBeyond(edge), normal = NormalOf(before);
    // Across the edge: as the surface comes, and as the triangle goes on.
    const Vector3d comes = beyond.cross(along), goes = normal.cross(along);
    Vector3d off = comes + goes;
    off = off.norm() > kLeastTurn ? off.normalized() : beyond;
    const double length = (At(b) - At(a)).norm();
    const double height = std::min(length, TwiceVectorArea(InSpace(hole_, patch_, before)).norm() / length);
    const int creases = CountAround(before);
    for (const double reach : kReaches) {
      const Point3 wanted = (At(a) + At(b)) / 2 + reach * height * off;
      patch_.new_points.push_back(RoundedToLattice(wanted, hole_.cell->lattice_step));
      if (Replace(t, {Triangle{a, b, tip}, Triangle{b, d, tip}, Triangle{d, a, tip}}, creases)) {
        for (const int32_t made : {t, Last() - 1, Last()}) made_[made] = edge;
        return true;
      }
      Undo(t, before, tip);
    }
    return false;
  }

  int32_t Last() const { return static_cast<int32_t>(patch_.triangles.size()) - 1; }

  // Whether fewer than so many creases are left.
  bool Replace(int32_t t, const std::array<Triangle, 3>& by, int creases) {
    patch_.triangles[t] = by[0];
    patch_.triangles.insert(patch_.triangles.end(), {by[1], by[2]});
    for (const int32_t k : {t, Last() - 1, Last()}) Register(k);
    int left = 0;
    for (const Triangle& n : by) {
      if (TwiceVectorArea(InSpace(hole_, patch_, n)).squaredNorm() <= 0) return false;
      left += CountAround(n);
    }
    return left < creases;
  }

  void Undo(int32_t t, const Triangle& before, int32_t tip) {
    patch_.new_points.pop_back();
    patch_.triangles.resize(patch_.triangles.size() - 2);
    patch_.triangles[t] = before;
    for (const int32_t v : before) {
      beside_.erase(EdgeKey(v, tip));
      beside_.erase(EdgeKey(tip, v));
    }
    Register(t);
  }

  const LocalHole& hole_;
  LocalPatch patch_;
  std::unordered_map<uint64_t, int32_t> beside_;  // the triangle that runs along an edge
  std::map<int32_t, Edge> made_;
};

}  // namespace

int32_t CountCreases(const LocalHole& hole, const LocalPatch& patch) {
  const std::vector<Triangle>& triangles = patch.triangles;
  const VertexLists corners = CornersAt(triangles, static_cast<size_t>(hole.size()) + patch.new_points.size());
  std::vector<Vector3d> normals;
  for (const Triangle& t : triangles) normals.push_back(TwiceVectorArea(InSpace(hole, patch, t)).normalized());
  int32_t creases = 0;
  for (size_t n = 0; n < triangles.size(); ++n) {
    for (int k = 0; k < 3; ++k) {
      const int32_t a = triangles[n][k], b = triangles[n][(k + 1) % 3];
      const auto runs_back = [&](int32_t corner) { return triangles[corner >> 2][((corner & 3) + 1) % 3] == a; };
      const auto around = corners.Of(b);
      const auto back = std::ranges::find_if(around, runs_back);
      if (back != around.end()) {
        creases += a < b && normals[n].dot(normals[*back >> 2]) < kCreaseCosine;
      } else if (a < hole.size() && b < hole.size()) {
        creases += normals[n].dot(hole.NormalBeside(a, b)) < kCreaseCosine;
      }
    }
  }
  return creases;
}

int32_t CountSpikes(const LocalHole& hole, const LocalPatch& patch) {
  std::vector<Tip> tips(static_cast<size_t>(hole.size()) + patch.new_points.size());
  for (const Triangle& t : patch.triangles) {
    const SpaceTriangle in_space = InSpace(hole, patch, t);
    for (int k = 0; k < 3; ++k) tips[t[k]].Add(in_space, k);
  }
  const TriMesh& band = hole.cell->band;
  for (int32_t v = 0; v < hole.size(); ++v) {
    if (hole.vertices[v] < 0) continue;
    for (const int32_t n : hole.band->At(hole.vertices[v])) {
      const Triangle& t = band.triangles[n];
      const SpaceTriangle in_space = {band.points[t[0]], band.points[t[1]], band.points[t[2]]};
      for (int k = 0; k < 3; ++k) {
        if (in_space[k] == hole.positions[v]) tips[v].Add(in_space, k);
      }
    }
  }
  return static_cast<int32_t>(std::ranges::count_if(tips, &Tip::IsSpike));
}

double TurnAtRim(const LocalHole& hole, const LocalPatch& patch) {
  double turns = 0, rim = 0;
  for (const Triangle& t : patch.triangles) {
    for (int k = 0; k < 3; ++k) {
      const int32_t a = t[k], b = t[(k + 1) % 3];
      if (a >= hole.size() || b >= hole.size()) continue;
      const Vector3d beside = hole.NormalBeside(a, b), normal = TwiceVectorArea(InSpace(hole, patch, t));
      if (beside.isZero()) continue;
      const double length = (hole.positions[b] - hole.positions[a]).norm();
      turns += length * std::atan2(beside.cross(normal).norm(), beside.dot(normal));
      rim += length;
    }
  }
  return rim > 0 ? turns / rim : 0;
}

LocalPatch BevelCreases(const LocalHole& hole, LocalPatch patch, CrossingCheck& check) {
  std::set<Edge> spared;
  for (int round = 0; round < kCreaseRounds; ++round) {
    Bevelling bevelling(hole, patch);
    bevelling.BevelAll(spared);
    if (bevelling.made().empty()) break;
    if (check.IsSound(bevelling.patch())) {
      patch = bevelling.patch();
      continue;
    }
    for (const int32_t t : check.Crossed(bevelling.patch())) {
      const auto made = bevelling.made().find(t);
      if (made != bevelling.made().end()) spared.insert(made->second);
    }
  }
  return patch;
}

}  // namespace tilemend
