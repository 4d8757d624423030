#include "coordinator/plan/rim/rim.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>
#include <utility>

#include "common/mesh/disjoint_sets.h"
#include "common/mesh/edge_key.h"
#include "common/mesh/edge_loops.h"
#include "common/mesh/position_index.h"

namespace tilemend {
namespace {

// All boundary vertices and edges of all tiles, before matching.
void CollectEdges(const PlanInput& input, Rim& rim) {
  PositionIndex index;
  for (const auto& [cell, record] : input.cells) {
    if (record == nullptr) continue;
    std::vector<int32_t>& number = rim.point_of[cell];
    number.reserve(record->vertices.size());
    for (const BoundaryVertex& v : record->vertices) {
      const int32_t n = index.Insert(v.position);
      if (n == static_cast<int32_t>(rim.points.size())) {
        rim.points.push_back({cell, v.index, v.position, v.normal, v.centroid_height, 0});
      } else {
        rim.points[n].normal += v.normal;
      }
      number.push_back(n);
    }
    for (const BoundaryEdge& e : record->edges) {
      rim.edges.push_back({number[e.from], number[e.to], cell, e.piece == kAreaPiece});
    }
  }
}

// Drops every pair of edges that run between the same points: in opposite directions, two tiles meet there.
void DropMatched(Rim& rim) {
  std::unordered_map<uint64_t, int32_t> count;
  count.reserve(rim.edges.size());
  const auto key = [](const RimEdge& e) { return EdgeKey(std::min(e.from, e.to), std::max(e.from, e.to)); };
  for (const RimEdge& e : rim.edges) ++count[key(e)];
  std::erase_if(rim.edges, [&](const RimEdge& e) { return count[key(e)] != 1; });
}

// The angle of `d` around axis `normal`, in (-pi, pi], from a direction fixed by the normal.
class AngleAround {
 public:
  explicit AngleAround(Eigen::Vector3d normal) {
    if (normal.norm() == 0) normal = Eigen::Vector3d::UnitZ();
    normal.normalize();
    const Eigen::Vector3d helper = std::abs(normal.x()) < 0.9 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
    u_ = (helper - normal * helper.dot(normal)).normalized();
    v_ = normal.cross(u_);
  }
  double operator()(const Eigen::Vector3d& d) const { return std::atan2(d.dot(v_), d.dot(u_)); }

 private:
  Eigen::Vector3d u_, v_;
};

// For the edges that arrive at and leave one point: which leaves after which arrives. Turning counter-clockwise from
// the way back along an arriving edge one crosses the hole; the first leaving edge met bounds the same hole.
void LinkAt(const Rim& rim, int32_t point, const std::vector<int32_t>& arriving, const std::vector<int32_t>& leaving,
            std::vector<int32_t>& next) {
  if (arriving.size() == 1 && leaving.size() == 1) {
    next[arriving[0]] = leaving[0];
    return;
  }
  const AngleAround angle(rim.points[point].normal);
  std::vector<bool> taken(leaving.size(), false);
  for (const int32_t a : arriving) {
    const double back = angle(rim.points[rim.edges[a].from].position - rim.points[point].position);
    double best = 10;
    size_t choice = leaving.size();
    for (size_t k = 0; k < leaving.size(); ++k) {
      if (taken[k]) continue;
      double turn = angle(rim.points[rim.edges[leaving[k]].to].position - rim.points[point].position) - back;
      if (turn <= 0) turn += 2 * std::numbers::pi;
      if (turn < best) {
        best = turn;
        choice = k;
      }
    }
    if (choice == leaving.size()) continue;
    taken[choice] = true;
    next[a] = leaving[choice];
  }
}

std::vector<int32_t> LinkAtPoints(const Rim& rim, std::vector<uint8_t>& touching) {
  std::vector<std::vector<int32_t>> arriving(rim.points.size()), leaving(rim.points.size());
  for (size_t e = 0; e < rim.edges.size(); ++e) {
    leaving[rim.edges[e].from].push_back(static_cast<int32_t>(e));
    arriving[rim.edges[e].to].push_back(static_cast<int32_t>(e));
  }
  std::vector<int32_t> next(rim.edges.size(), -1);
  for (size_t p = 0; p < rim.points.size(); ++p) {
    if (arriving[p].empty()) continue;
    LinkAt(rim, static_cast<int32_t>(p), arriving[p], leaving[p], next);
    touching[p] = arriving[p].size() > 1;
  }
  return next;
}

void TraceLoops(const std::vector<int32_t>& next, Rim& rim) {
  for (EdgeWalk& walk : FollowEdges(next)) {
    if (walk.closed) {
      rim.loops.push_back(std::move(walk.edges));
    } else {
      rim.unlinked.insert(rim.unlinked.end(), walk.edges.begin(), walk.edges.end());
    }
  }
}

// Counts the groups of two or more loops that share a point.
int32_t CountTouchingGroups(const Rim& rim, const std::vector<uint8_t>& touching) {
  DisjointSets groups(static_cast<int32_t>(rim.loops.size()));
  std::unordered_map<int32_t, int32_t> loop_at;
  for (size_t l = 0; l < rim.loops.size(); ++l) {
    for (const int32_t e : rim.loops[l]) {
      const int32_t p = rim.edges[e].from;
      if (!touching[p]) continue;
      const auto [it, fresh] = loop_at.try_emplace(p, static_cast<int32_t>(l));
      if (!fresh) groups.Join(static_cast<int32_t>(l), it->second);
    }
  }
  std::vector<int32_t> members(rim.loops.size(), 0);
  for (const int32_t group : groups.Groups()) ++members[group];
  return static_cast<int32_t>(std::count_if(members.begin(), members.end(), [](int32_t n) { return n > 1; }));
}

void StoreSizes(Rim& rim) {
  std::vector<int32_t> count(rim.points.size(), 0);
  for (const RimEdge& e : rim.edges) {
    const double length = (rim.points[e.to].position - rim.points[e.from].position).norm();
    for (const int32_t p : {e.from, e.to}) {
      rim.points[p].size += length;
      ++count[p];
    }
  }
  for (size_t p = 0; p < rim.points.size(); ++p) {
    if (count[p] > 0) rim.points[p].size /= count[p];
  }
}

}  // namespace

Rim BuildRim(const PlanInput& input) {
  Rim rim;
  CollectEdges(input, rim);
  DropMatched(rim);
  StoreSizes(rim);
  LinkLoops(rim);
  return rim;
}

void LinkLoops(Rim& rim) {
  rim.loops.clear();
  rim.unlinked.clear();
  std::vector<uint8_t> touching(rim.points.size(), 0);
  const std::vector<int32_t> next = LinkAtPoints(rim, touching);
  TraceLoops(next, rim);
  rim.continuous = CountTouchingGroups(rim, touching);
}

std::vector<RimSegment> Reversed(const Rim& rim, std::span<const int32_t> edges) {
  std::vector<RimSegment> segments;
  for (auto e = edges.rbegin(); e != edges.rend(); ++e)
    segments.push_back({rim.edges[*e].to, rim.edges[*e].from, rim.edges[*e].area_edge});
  return segments;
}

}  // namespace tilemend
