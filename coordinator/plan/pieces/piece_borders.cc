#include "coordinator/plan/pieces/piece_borders.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "common/mesh/segment_distance.h"

namespace tilemend {
namespace {

constexpr double kPlane = 2e-3;     // metres: an edge whose ends agree to this lies in a plane across that axis
constexpr double kOtherWay = -0.3;  // cosine between edges that run along each other, one this way, one that

// Whether ab and cd both lie in planes across one axis.
bool ShareAxis(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  for (int k = 0; k < 3; ++k) {
    if (std::abs(a[k] - b[k]) <= kPlane && std::abs(c[k] - d[k]) <= kPlane) return true;
  }
  return false;
}

class BorderFinder {
 public:
  BorderFinder(const Rim& rim, const RimIndex& index, double reach)
      : rim_(rim), index_(index), reach_(reach), loop_of_(rim.edges.size(), -1) {
    for (size_t l = 0; l < rim.loops.size(); ++l) {
      for (const int32_t e : rim.loops[l]) loop_of_[e] = static_cast<int32_t>(l);
    }
  }

  double DistanceOf(int32_t edge) const {
    const RimEdge& e = rim_.edges[edge];
    double best = -1;
    const Point3 a = At(e.from), b = At(e.to), middle = (a + b) / 2;
    const Point2 r = Point2::Constant(reach_);
    for (const int32_t i : index_.EdgesIn(middle.head<2>() - r, middle.head<2>() + r)) {
      const RimEdge& o = rim_.edges[i];
      if (o.from == e.from || o.from == e.to || o.to == e.from || o.to == e.to) continue;
      const Point3 c = At(o.from), d = At(o.to);
      if ((b - a).dot(d - c) > kOtherWay * (b - a).norm() * (d - c).norm() || !ShareAxis(a, b, c, d)) continue;
      const Eigen::Vector3d left = (rim_.points[e.from].normal + rim_.points[e.to].normal).cross(b - a);
      if (loop_of_[i] == loop_of_[edge] && left.dot((c + d) / 2 - middle) <= 0) continue;
      const double distance = DistanceToSegment(middle, c, d);
      if (distance <= reach_ && (best < 0 || distance < best)) best = distance;
    }
    return best;
  }

 private:
  const Point3& At(int32_t p) const { return rim_.points[p].position; }

  const Rim& rim_;
  const RimIndex& index_;
  const double reach_;
  std::vector<int32_t> loop_of_;  // per edge
};

}  // namespace

std::vector<double> FindPieceBorders(const Rim& rim, const RimIndex& index, const ClosingCells& closing, double reach) {
  const BorderFinder finder(rim, index, reach);
  std::vector<double> distance;
  for (size_t e = 0; e < rim.edges.size(); ++e) {
    const bool at_outline = closing[e] != rim.edges[e].owner;
    distance.push_back(at_outline ? -1 : finder.DistanceOf(static_cast<int32_t>(e)));
  }
  return distance;
}

}  // namespace tilemend
