#include "coordinator/plan/water/hole_groups.h"

#include <Eigen/Geometry>
#include <map>

namespace tilemend {
namespace {

constexpr double kFacesUp = 0.9;  // cosine of a closed hole's slope

}  // namespace

std::vector<std::vector<int32_t>> GroupHoles(const Plan& plan) {
  const auto faces_up = [&](const PlannedHole& hole) {
    Eigen::Vector3d area = Eigen::Vector3d::Zero();
    const Point3 origin = plan.vertices[hole.segments[0].from].position;
    for (const RimSegment& s : hole.segments) {
      area += (plan.vertices[s.from].position - origin).cross(plan.vertices[s.to].position - origin);
    }
    return area.z() > kFacesUp * area.norm();
  };
  std::vector<std::vector<int32_t>> groups;
  std::map<int32_t, size_t> group_of_cluster;
  for (size_t h = 0; h < plan.holes.size(); ++h) {
    const PlannedHole& hole = plan.holes[h];
    if (!hole.failure.empty()) continue;
    if (hole.kind == HoleKind::kClosed) {
      if (hole.projects && faces_up(hole)) groups.push_back({static_cast<int32_t>(h)});
      continue;
    }
    const auto [it, fresh] = group_of_cluster.try_emplace(hole.cluster, groups.size());
    if (fresh) groups.emplace_back();
    groups[it->second].push_back(static_cast<int32_t>(h));
  }
  return groups;
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

}  // namespace tilemend
