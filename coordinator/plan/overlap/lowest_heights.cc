#include "coordinator/plan/overlap/lowest_heights.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <vector>

#include "common/mesh/box_tree.h"

namespace tilemend {
namespace {

// An edge seen across the line: x is the coordinate along it, y the height.
struct ProfileEdge {
  Point2 from, to;
};

bool PassesBelow(const ProfileEdge& e, const Point2& p) {
  const double share = (p.x() - e.from.x()) / (e.to.x() - e.from.x());
  return share > 0 && share < 1 && e.from.y() + share * (e.to.y() - e.from.y()) < p.y();
}

}  // namespace

std::map<double, double> LowestHeights(const SurveyRecord& record, int axis,
                                       const std::function<bool(const Point3&)>& beyond) {
  const auto in_profile = [&](const Point3& p) { return Point2(p[axis], p.z()); };
  std::vector<ProfileEdge> edges;
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const BoundaryEdge& e : record.edges) {
    const Point3 &from = record.vertices[e.from].position, &to = record.vertices[e.to].position;
    if (!beyond(from) || !beyond(to) || from[axis] == to[axis]) continue;
    edges.push_back({in_profile(from), in_profile(to)});
    Eigen::AlignedBox3d& box = boxes.emplace_back();
    for (const Point2& p : {edges.back().from, edges.back().to}) box.extend(Point3(p.x(), p.y(), 0));
  }
  const BoxTree tree(boxes);
  std::map<double, double> heights;
  for (const BoundaryVertex& v : record.vertices) {
    if (!beyond(v.position)) continue;
    const Point2 p = in_profile(v.position);
    const Eigen::AlignedBox3d below(Point3(p.x(), -std::numeric_limits<double>::max(), 0), Point3(p.x(), p.y(), 0));
    if (tree.AnyMeeting(below, [&](int32_t e) { return PassesBelow(edges[e], p); })) continue;
    const auto [it, fresh] = heights.emplace(p.x(), p.y());
    if (!fresh) it->second = std::min(it->second, p.y());
  }
  return heights;
}

}  // namespace tilemend
