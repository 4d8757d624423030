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
constexpr double kDoubt = 0.1;  // how much nearer to level a rim leaves a slope that reaches as far as its own extent

// Where segments lie: each counts at its middle, by its length seen from above. Relative to the first, so that map
// coordinates lose nothing.
class Extent {
 public:
  void Add(const Point3& from, const Point3& to) {
    if (!origin_) origin_ = from;
    const double length = (to - from).head<2>().norm();
    const Point3 middle = (from + to) / 2 - *origin_;
    length_ += length;
    sum_ += length * middle;
    squares_ += length * middle * middle.transpose();
  }

  bool IsEmpty() const { return !(length_ > 0); }
  Point3 Middle() const { return *origin_ + sum_ / length_; }
  // The mean of d d^T, where d leads from `place` to the segments.
  Eigen::Matrix3d SpreadAbout(const Point3& place) const {
    const Point3 to_place = place - *origin_, mean = sum_ / length_;
    return squares_ / length_ - mean * to_place.transpose() - to_place * mean.transpose() +
           to_place * to_place.transpose();
  }

 private:
  std::optional<Point3> origin_;
  double length_ = 0;
  Point3 sum_ = Point3::Zero();
  Eigen::Matrix3d squares_ = Eigen::Matrix3d::Zero();
};

// The rim of one cluster, and its seams with the cluster on one side only: at the edge of the area.
class ClusterRim {
 public:
  explicit ClusterRim(const Plan& plan) : plan_(plan) {}

  void Add(const PlannedHole& hole) {
    for (const RimSegment& s : hole.segments) {
      if (!s.seam) {
        AddRim(plan_.vertices[s.from].position, plan_.vertices[s.to].position);
      } else if (seams_.erase({s.to, s.from}) == 0) {
        seams_.insert({s.from, s.to});
      }
    }
  }

  Point2 Slope() const {
    const Point2 slope = seams_.empty() ? SlopeInside() : SlopeToTheEdge();
    if (slope.norm() < kGentle) return Point2(0, 0);
    return slope * (kSteepest / std::max(slope.norm(), kSteepest));
  }

 private:
  void AddRim(const Point3& from, const Point3& to) {
    if (!origin_) origin_ = from;
    area_ += (from - *origin_).cross(to - *origin_);
    rim_.Add(from, to);
  }

  Point2 SlopeInside() const { return area_.z() > 0 ? Point2(-area_.head<2>() / area_.z()) : Point2(0, 0); }

  // Of the plane through the rim by least squares, drawn to level in so far as the edge of the area is farther out than
  // the rim reaches.
  Point2 SlopeToTheEdge() const {
    Extent edge;
    for (const auto& [from, to] : seams_) edge.Add(plan_.vertices[from].position, plan_.vertices[to].position);
    if (rim_.IsEmpty() || edge.IsEmpty()) return Point2(0, 0);
    const Eigen::Matrix3d rim = rim_.SpreadAbout(rim_.Middle());
    const Eigen::Matrix2d doubt = kDoubt * edge.SpreadAbout(rim_.Middle()).topLeftCorner<2, 2>();
    const Eigen::Matrix2d spread = rim.topLeftCorner<2, 2>() + doubt;
    return spread.completeOrthogonalDecomposition().solve(Point2(rim.topRightCorner<2, 1>()));
  }

  const Plan& plan_;
  std::set<std::pair<int32_t, int32_t>> seams_;  // so far on one side only
  Extent rim_;
  std::optional<Point3> origin_;                    // of the vector area
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
