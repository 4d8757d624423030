#include "coordinator/plan/water/ground_points.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "common/mesh/bin_grid.h"
#include "common/mesh/box_tree.h"
#include "common/mesh/triangulation/point_triangulation.h"
#include "coordinator/plan/water/hole_groups.h"
#include "coordinator/plan/water/platforms.h"
#include "coordinator/plan/water/shore_line.h"

namespace tilemend {
namespace {

constexpr double kLowestWithin = 2;  // metres
constexpr double kMostBins = 1000;   // along a side

Eigen::AlignedBox2d ExtentOf(const Plan& plan, const PlannedHole& hole) {
  Eigen::AlignedBox2d box;
  const auto extend = [&](const std::vector<RimSegment>& segments) {
    for (const RimSegment& s : segments) box.extend(Point2(plan.vertices[s.from].position.head<2>()));
  };
  extend(hole.segments);
  for (const std::vector<RimSegment>& region : hole.own_regions) extend(region);
  return box;
}

// The original vertices on the rims of the holes that stand on no object.
std::vector<Point3> GroundAtRims(const Plan& plan, const std::vector<int32_t>& holes) {
  std::set<int32_t> ground;
  for (const int32_t h : holes) {
    for (const RimSegment& s : plan.holes[h].segments) {
      for (const int32_t v : {s.from, s.to}) {
        if (plan.vertices[v].index >= 0 && !plan.vertices[v].on_object) ground.insert(v);
      }
    }
  }
  std::vector<Point3> points;
  for (const int32_t v : ground) points.push_back(plan.vertices[v].position);
  return points;
}

// The points, each as high as the lowest around it.
std::vector<Point3> Lowered(const std::vector<Point3>& points) {
  if (points.empty()) return {};
  Eigen::AlignedBox2d places;
  for (const Point3& p : points) places.extend(Point2(p.head<2>()));
  const Point2 reach = Point2::Constant(kLowestWithin);
  const auto place = [&](int32_t i) { return Point2(points[i].head<2>()); };
  const BinGrid bins(places, std::max(kLowestWithin, places.sizes().maxCoeff() / kMostBins),
                     static_cast<int32_t>(points.size()),
                     [&](int32_t i) { return Eigen::AlignedBox2d(place(i), place(i)); });
  std::vector<Point3> lowered = points;
  for (int32_t i = 0; i < std::ssize(points); ++i) {
    for (const int32_t k : bins.In({place(i) - reach, place(i) + reach})) {
      if ((place(k) - place(i)).norm() <= kLowestWithin) lowered[i].z() = std::min(lowered[i].z(), points[k].z());
    }
  }
  return lowered;
}

// A box of the plane, for a tree.
Eigen::AlignedBox3d Flat(const Eigen::AlignedBox2d& box) {
  return {Point3(box.min().x(), box.min().y(), 0), Point3(box.max().x(), box.max().y(), 0)};
}

std::vector<Eigen::AlignedBox3d> BoxesOf(const PointTriangulation& triangulation) {
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const Triangle& t : triangulation.mesh.triangles) {
    Eigen::AlignedBox2d box;
    for (const int32_t v : t) box.extend(triangulation.window.ToMetres(triangulation.points[v]));
    boxes.push_back(Flat(box));
  }
  return boxes;
}

// Of points over one place the first.
std::vector<Point3> FirstOverEachPlace(const std::vector<Point3>& points) {
  std::set<std::pair<double, double>> places;
  std::vector<Point3> first;
  for (const Point3& p : points) {
    if (places.emplace(p.x(), p.y()).second) first.push_back(p);
  }
  return first;
}

// The surface between the ground points of a group, of those over one place the first, to be asked for what it is made
// of in a box.
class GroundSurface {
 public:
  GroundSurface(const std::vector<Point3>& points, const Eigen::AlignedBox2d& places)
      : points_(FirstOverEachPlace(points)),
        triangulation_(TriangulatePoints(points_, places)),
        tree_(BoxesOf(triangulation_)) {}

  std::vector<Point3> CornersIn(const Eigen::AlignedBox2d& box) const {
    std::set<int32_t> corners;
    tree_.AnyMeeting(Flat(box), [&](int32_t t) {
      const Triangle& triangle = triangulation_.mesh.triangles[t];
      corners.insert(triangle.begin(), triangle.end());
      return false;
    });
    std::vector<Point3> result;
    for (const int32_t v : corners) {
      if (v < std::ssize(points_)) result.push_back(points_[v]);  // else a corner of the frame
    }
    return result;
  }

 private:
  const std::vector<Point3> points_;
  const PointTriangulation triangulation_;
  const BoxTree tree_;
};

// Of the holes of a group those that are parts of known shores, and the others.
struct KnownParts {
  std::vector<int32_t> known, others;
};

KnownParts PartsOf(const KnownObjects& known, const std::vector<int32_t>& holes) {
  KnownParts parts;
  for (const int32_t h : holes) (known.ShoreOf({h}) == nullptr ? parts.others : parts.known).push_back(h);
  return parts;
}

// The ground of the shores that the holes are parts of.
std::vector<Point3> KnownGround(const KnownObjects& known, const std::vector<int32_t>& holes) {
  std::set<int32_t> shores;
  for (const int32_t h : holes) shores.insert(known.shore_of[h]);
  std::vector<Point3> ground;
  for (const int32_t shore : shores) {
    const std::vector<Point3>& more = known.shores[shore].ground;
    ground.insert(ground.end(), more.begin(), more.end());
  }
  return ground;
}

}  // namespace

std::vector<Point3> GroundOfShore(const Plan& plan, const std::vector<int32_t>& holes) {
  const ShoreLine shore = ShoreLineOf(plan, holes);
  std::vector<Point3> ground = FindPlatforms(shore.points, shore.kinds, shore.edges);
  std::ranges::stable_sort(ground, {}, [](const Point3& p) { return p.z(); });
  const std::vector<Point3> rim = Lowered(GroundAtRims(plan, holes));
  ground.insert(ground.end(), rim.begin(), rim.end());
  return ground;
}

void FindGroundPoints(const KnownObjects& known, Plan& plan) {
  for (const std::vector<int32_t>& holes : GroupHoles(plan)) {
    if (!plan.holes[holes.front()].among_objects || plan.holes[holes.front()].water >= 0) continue;
    Eigen::AlignedBox2d places;
    for (const int32_t h : holes) places.extend(ExtentOf(plan, plan.holes[h]));
    const KnownParts parts = PartsOf(known, holes);
    std::vector<Point3> ground = KnownGround(known, parts.known);
    for (const Point3& p : ground) places.extend(Point2(p.head<2>()));
    const auto take = [&](const std::vector<int32_t>& some) {
      if (ground.empty() || some.empty()) return;
      const GroundSurface surface(ground, places);
      for (const int32_t h : some) plan.holes[h].ground_points = surface.CornersIn(ExtentOf(plan, plan.holes[h]));
    };
    take(parts.known);
    const std::vector<Point3> others = GroundOfShore(plan, parts.others);
    ground.insert(ground.end(), others.begin(), others.end());
    take(parts.others);
  }
}

}  // namespace tilemend
