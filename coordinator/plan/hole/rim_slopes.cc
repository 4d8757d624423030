#include "coordinator/plan/hole/rim_slopes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace tilemend {
namespace {

constexpr double kGentle = 0.25;  // a plate over the ground is that over the plane to within 3 %
constexpr double kSteepest = 2;

// The rim of one cluster, and its seams with the cluster on one side only: at the edge of the area.
class ClusterRim {
 public:
  explicit ClusterRim(const Plan& plan) : plan_(plan) {}

  void Add(const PlannedHole& hole) {
    for (const RimSegment& s : hole.segments) {
      if (!s.seam) {
        AddWay(s.from, s.to);
      } else if (seams_.erase({s.to, s.from}) == 0) {
        seams_.insert({s.from, s.to});
      }
    }
  }

  Point2 Slope() const {
    if (!seams_.empty() || !(area_.z() > 0)) return Point2(0, 0);
    const Point2 slope = -area_.head<2>() / area_.z();
    if (slope.norm() < kGentle) return Point2(0, 0);
    return slope * (kSteepest / std::max(slope.norm(), kSteepest));
  }

 private:
  void AddWay(int32_t from, int32_t to) {
    if (!origin_) origin_ = plan_.vertices[from].position;
    area_ += (plan_.vertices[from].position - *origin_).cross(plan_.vertices[to].position - *origin_);
  }

  const Plan& plan_;
  std::set<std::pair<int32_t, int32_t>> seams_;  // so far on one side only
  std::optional<Point3> origin_;
  Eigen::Vector3d area_ = Eigen::Vector3d::Zero();  // twice the vector area
};

}  // namespace

void FindRimSlopes(Plan& plan) {
  std::map<int32_t, ClusterRim> clusters;
  for (PlannedHole& hole : plan.holes) {
    if (hole.cluster >= 0) {
      clusters.try_emplace(hole.cluster, plan).first->second.Add(hole);
      continue;
    }
    ClusterRim rim(plan);
    rim.Add(hole);
    hole.slope = rim.Slope();
  }
  std::map<int32_t, Point2> slopes;
  for (auto& [cluster, rim] : clusters) slopes[cluster] = rim.Slope();
  for (PlannedHole& hole : plan.holes) {
    if (hole.cluster >= 0) hole.slope = slopes[hole.cluster];
  }
}

}  // namespace tilemend
