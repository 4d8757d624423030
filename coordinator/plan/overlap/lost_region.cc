#include "coordinator/plan/overlap/lost_region.h"

#include <algorithm>

namespace tilemend {
namespace {

constexpr double kLostShare = 0.1;
constexpr double kLostArea = 2;  // m2

double AreaOf(const Plan& plan, const std::vector<RimSegment>& segments) {
  double doubled = 0;
  if (segments.empty()) return doubled;
  const Point2 origin = plan.vertices[segments.front().from].position.head<2>();
  for (const RimSegment& s : segments) {
    const Point2 a = plan.vertices[s.from].position.head<2>() - origin;
    const Point2 b = plan.vertices[s.to].position.head<2>() - origin;
    doubled += a.x() * b.y() - a.y() * b.x();
  }
  return doubled / 2;
}

}  // namespace

bool IsLostRegion(const Plan& plan, const std::vector<RimSegment>& hole, const std::vector<RimSegment>& region,
                  bool on_outline) {
  const auto has_surface = [](const std::vector<RimSegment>& of) {
    return !std::ranges::all_of(of, &RimSegment::seam);
  };
  if (!on_outline && !region.empty() && has_surface(hole) && !has_surface(region)) return true;
  const double whole = AreaOf(plan, hole);
  return whole - AreaOf(plan, region) > std::max(kLostArea, kLostShare * whole);
}

bool IsSliver(const Plan& plan, const std::vector<RimSegment>& hole, double width) {
  if (hole.empty()) return true;
  // Vertices on seams have no height yet: seen from above there.
  const bool is_in_space = std::ranges::none_of(hole, &RimSegment::seam);
  const auto position = [&](int32_t v) {
    const Point3& p = plan.vertices[v].position;
    return is_in_space ? p : Point3(p.x(), p.y(), 0);
  };
  const Point3 origin = position(hole.front().from);
  Eigen::Vector3d doubled = Eigen::Vector3d::Zero();
  double length = 0;
  for (const RimSegment& s : hole) {
    const Point3 a = position(s.from), b = position(s.to);
    doubled += (a - origin).cross(b - origin);
    length += (b - a).norm();
  }
  return doubled.norm() / 2 <= width * length / 2;
}

}  // namespace tilemend
