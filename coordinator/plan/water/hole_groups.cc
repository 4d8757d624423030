#include "coordinator/plan/water/hole_groups.h"

#include <Eigen/Geometry>
#include <cmath>
#include <map>

#include "coordinator/plan/types/left_reasons.h"

namespace tilemend {
namespace {

constexpr double kFacesUp = 0.9;  // cosine of a closed hole's slope
constexpr double kIsPart = 0.5;   // of a hole

}  // namespace

double SlopeOf(const Plan& plan, const PlannedHole& hole) {
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  const Point3 origin = plan.vertices[hole.segments[0].from].position;
  for (const RimSegment& s : hole.segments) {
    area += (plan.vertices[s.from].position - origin).cross(plan.vertices[s.to].position - origin);
  }
  return std::atan2(area.head<2>().norm(), area.z());
}

std::vector<std::vector<int32_t>> GroupHoles(const Plan& plan, bool with_left) {
  std::vector<std::vector<int32_t>> groups;
  std::map<int32_t, size_t> group_of_cluster;
  for (size_t h = 0; h < plan.holes.size(); ++h) {
    const PlannedHole& hole = plan.holes[h];
    if (!hole.failure.empty() && !(with_left && hole.failure == kLeftByDecision)) continue;
    if (hole.kind == HoleKind::kClosed) {
      if (plan.upright && std::cos(SlopeOf(plan, hole)) > kFacesUp) groups.push_back({static_cast<int32_t>(h)});
      continue;
    }
    const auto [it, fresh] = group_of_cluster.try_emplace(hole.cluster, groups.size());
    if (fresh) groups.emplace_back();
    groups[it->second].push_back(static_cast<int32_t>(h));
  }
  return groups;
}

std::vector<std::vector<int32_t>> GroupAllHoles(const Plan& plan) {
  std::vector<std::vector<int32_t>> groups;
  std::map<int32_t, size_t> group_of_cluster;
  for (size_t h = 0; h < plan.holes.size(); ++h) {
    const int32_t cluster = plan.holes[h].cluster;
    size_t group = groups.size();
    if (cluster >= 0) group = group_of_cluster.try_emplace(cluster, group).first->second;
    if (group == groups.size()) groups.emplace_back();
    groups[group].push_back(static_cast<int32_t>(h));
  }
  return groups;
}

std::vector<int32_t> RimVerticesOf(const Plan& plan, const std::vector<int32_t>& holes) {
  std::vector<int32_t> vertices;
  for (const int32_t h : holes) {
    ForRimSegments(plan.holes[h], [&](const RimSegment& s) {
      for (const int32_t v : {s.from, s.to}) {
        if (plan.vertices[v].index >= 0) vertices.push_back(v);
      }
    });
  }
  std::ranges::sort(vertices);
  vertices.erase(std::ranges::unique(vertices).begin(), vertices.end());
  return vertices;
}

std::vector<PlaneSegment> BoundaryOf(const Plan& plan, const std::vector<int32_t>& holes) {
  std::vector<PlaneSegment> boundary;
  for (const int32_t h : holes) {
    for (const RimSegment& s : plan.holes[h].segments) {
      boundary.emplace_back(plan.vertices[s.from].position.head<2>(), plan.vertices[s.to].position.head<2>());
    }
  }
  return boundary;
}

std::vector<int32_t> GroupsCovering(const Plan& plan, const Plan& whole, const std::vector<int32_t>& group_of) {
  std::vector<int32_t> covering(plan.holes.size(), -1);
  std::multimap<CellId, int32_t> holes_in;
  for (size_t h = 0; h < whole.holes.size(); ++h) holes_in.emplace(whole.holes[h].cell, static_cast<int32_t>(h));
  for (size_t h = 0; h < plan.holes.size(); ++h) {
    const auto [from, to] = holes_in.equal_range(plan.holes[h].cell);
    const bool is_asked = plan.holes[h].failure.empty() &&
                          std::any_of(from, to, [&](const auto& other) { return group_of[other.second] >= 0; });
    if (!is_asked) continue;
    const std::vector<PlaneSegment> boundary = BoundaryOf(plan, {static_cast<int32_t>(h)});
    const CoverLines region(boundary);
    std::map<int32_t, double> share;
    bool is_other = false;  // the same hole is there, and in no group: it lies above one of a group
    for (auto it = from; it != to && !is_other; ++it) {
      const std::vector<PlaneSegment> other = BoundaryOf(whole, {it->second});
      const double covered = region.ShareIn(other);
      if (group_of[it->second] >= 0) {
        share[group_of[it->second]] += covered;
      } else {
        is_other = covered > kIsPart && CoverLines(other).ShareIn(boundary) > kIsPart;
      }
    }
    const auto most = std::ranges::max_element(share, {}, [](const auto& s) { return s.second; });
    if (!is_other && most != share.end() && most->second > kIsPart) covering[h] = most->first;
  }
  return covering;
}

}  // namespace tilemend
