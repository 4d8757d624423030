#include "coordinator/plan/water/platforms.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "common/mesh/bin_grid.h"

namespace tilemend {
namespace {

constexpr double kMostBins = 1000;  // along a side
constexpr double kFacing = 0.5;     // cosine of the angle between the shores of two towers that face each other

using Interval = std::pair<double, double>;

double Length(const Interval& i) { return i.second - i.first; }

Interval Extended(const Interval& i, double x) { return {std::min(i.first, x), std::max(i.second, x)}; }

Point2 Place(const Point3& p) { return p.head<2>(); }

// Where the shore is ground, and not a shelf: as high above other ground near it.
std::vector<bool> LowGround(std::span<const Point3> points, std::span<const ShorePoint> kinds,
                            const PlatformRule& rule) {
  Eigen::AlignedBox2d places;
  for (const Point3& p : points) places.extend(Place(p));
  const BinGrid bins(places, std::max(rule.beside, places.sizes().maxCoeff() / kMostBins),
                     static_cast<int32_t>(points.size()),
                     [&](int32_t i) { return Eigen::AlignedBox2d(Place(points[i])); });
  const Point2 reach = Point2::Constant(rule.beside);
  std::vector<bool> low(points.size());
  for (size_t i = 0; i < points.size(); ++i) {
    const Point3& p = points[i];
    const auto is_lower_ground = [&](int32_t k) {
      return kinds[k] == ShorePoint::kGround && points[k].z() < p.z() - rule.lift &&
             (Place(points[k]) - Place(p)).norm() <= rule.beside;
    };
    low[i] = kinds[i] == ShorePoint::kGround &&
             std::ranges::none_of(bins.In({Place(p) - reach, Place(p) + reach}), is_lower_ground);
  }
  return low;
}

// A stretch of shore on an object, from the ground on the side of its shelf to the other end.
struct Tower {
  std::vector<Point3> points;
  Point2 middle, along;  // of the way along the shore, the hole on its left
  double shelf = 0;      // height

  double Along(const Point3& p) const { return along.dot(Place(p) - middle); }
};

// Finds the towers of a shore.
class TowerFinder {
 public:
  TowerFinder(std::span<const Point3> points, std::span<const ShorePoint> kinds, std::span<const DirectedEdge> edges,
              const PlatformRule& rule)
      : points_(points), rule_(rule), is_ground_(LowGround(points, kinds, rule)) {
    for (const EdgeWalk& walk : LinkEdges(edges)) AddTowers(VerticesOf(walk, edges));
  }

  const std::vector<Tower>& towers() const { return towers_; }

 private:
  // In order; a loop begins at ground, and ends with the same vertex.
  std::vector<int32_t> VerticesOf(const EdgeWalk& walk, std::span<const DirectedEdge> edges) const {
    std::vector<int32_t> vertices;
    for (const int32_t e : walk.edges) vertices.push_back(edges[e].from);
    if (!walk.closed) {
      vertices.push_back(edges[walk.edges.back()].to);
      return vertices;
    }
    const auto ground = std::ranges::find_if(vertices, [&](int32_t v) { return is_ground_[v]; });
    if (ground == vertices.end()) return {};
    std::rotate(vertices.begin(), ground, vertices.end());
    vertices.push_back(vertices.front());
    return vertices;
  }

  void AddTowers(const std::vector<int32_t>& vertices) {
    const auto is_ground = [&](int32_t v) { return is_ground_[v]; };
    auto end = vertices.begin();
    while (end != vertices.end()) {
      const auto begin = std::find_if_not(end, vertices.end(), is_ground);
      end = std::find_if(begin, vertices.end(), is_ground);
      if (begin == end) return;
      const bool from_ground = begin != vertices.begin(), to_ground = end != vertices.end();
      AddTower({begin - (from_ground ? 1 : 0), end + (to_ground ? 1 : 0)}, from_ground, to_ground);
    }
  }

  void AddTower(const std::vector<int32_t>& stretch, bool from_ground, bool to_ground) {
    Tower tower;
    for (const int32_t v : stretch) tower.points.push_back(points_[v]);
    const Point2 first = Place(tower.points.front()), last = Place(tower.points.back());
    tower.middle = (first + last) / 2;
    tower.along = (last - first).normalized();
    std::optional<double> shelf;
    if (from_ground) shelf = ShelfFromFirst(tower);
    if (to_ground && !shelf) {
      std::ranges::reverse(tower.points);
      shelf = ShelfFromFirst(tower);
    }
    if (!shelf) return;
    tower.shelf = *shelf;
    towers_.push_back(std::move(tower));
  }

  // The height of the shelf on the way from the ground at the first point up to the top.
  std::optional<double> ShelfFromFirst(const Tower& tower) const {
    const std::vector<Point3>& way = tower.points;
    const double ground = way.front().z();
    const double top = std::ranges::max(way, {}, [](const Point3& p) { return p.z(); }).z();
    double highest = ground;  // so far
    for (size_t first = 1; first < way.size() && way[first].z() <= top - rule_.tower; ++first) {
      std::vector<double> heights = LevelFrom(tower, first);
      const auto [low, high] = std::ranges::minmax(heights);
      if (low >= ground + rule_.lift && high <= top - rule_.tower && highest <= high) {
        std::ranges::nth_element(heights, heights.begin() + std::ssize(heights) / 2);
        return heights[heights.size() / 2];
      }
      highest = std::max(highest, way[first].z());
    }
    return std::nullopt;
  }

  // The heights from a point of the tower on as long as they are those of a shelf; of a stretch that is too short for
  // one, that of the ground alone.
  std::vector<double> LevelFrom(const Tower& tower, size_t first) const {
    std::vector<double> heights;
    Interval height(tower.points[first].z(), tower.points[first].z());
    Interval along(tower.Along(tower.points[first]), tower.Along(tower.points[first]));
    for (size_t k = first; k < tower.points.size(); ++k) {
      const Point3& p = tower.points[k];
      height = Extended(height, p.z());
      if (Length(height) > rule_.roughness) break;
      along = Extended(along, tower.Along(p));
      heights.push_back(p.z());
    }
    if (Length(along) < rule_.extent) return {tower.points.front().z()};
    return heights;
  }

  const std::span<const Point3> points_;
  const PlatformRule rule_;
  const std::vector<bool> is_ground_;
  std::vector<Tower> towers_;
};

// Whether `other` lies across the hole, beside at least half of the tower or of itself.
bool Faces(const Tower& tower, const Tower& other) {
  const Point2 way = other.middle - tower.middle;
  const bool on_left = tower.along.x() * way.y() - tower.along.y() * way.x() > 0;
  if (!on_left || tower.along.dot(other.along) > -kFacing) return false;
  const auto extent = [&](const Tower& t) {
    Interval along(tower.Along(t.points.front()), tower.Along(t.points.front()));
    for (const Point3& p : t.points) along = Extended(along, tower.Along(p));
    return along;
  };
  const Interval own = extent(tower), others = extent(other);
  const Interval common(std::max(own.first, others.first), std::min(own.second, others.second));
  return Length(common) >= std::min(Length(own), Length(others)) / 2;
}

bool ShareAPlatform(const Tower& a, const Tower& b, const PlatformRule& rule) {
  return std::abs(a.shelf - b.shelf) <= rule.roughness && (a.middle - b.middle).norm() <= rule.across && Faces(a, b) &&
         Faces(b, a);
}

// One that two towers stand on.
class Platform {
 public:
  Platform(const Tower& a, const Tower& b, const PlatformRule& rule)
      : a_(a), b_(b), rule_(rule), height_((a.shelf + b.shelf) / 2) {
    const std::vector<Point2> ways = {a.along, -a.along};
    for (const Point2& way : ways) CutAt(way);
    for (const Point2& way : ways) {
      const std::optional<End> end_a = EndOf(a, way), end_b = EndOf(b, way);
      if (end_a && end_b) AddWall(*end_a, *end_b, way);
    }
    for (const Tower* tower : {&a, &b}) {
      for (const Point3& p : tower->points) {
        if (StandsOnIt(p)) ground_.emplace_back(p.x(), p.y(), height_);
      }
    }
  }

  const std::vector<Point3>& ground() const { return ground_; }

 private:
  // Of what stands on the platform: the last point that way, and the ground beside.
  struct End {
    Point3 top, foot;
  };
  // What lies farther that way is not on the platform.
  struct Limit {
    Point2 way;
    double most;
  };

  bool StandsOnIt(const Point3& p) const {
    const auto is_within = [&](const Limit& limit) { return limit.way.dot(Place(p)) <= limit.most; };
    return p.z() > height_ - rule_.roughness && std::ranges::all_of(limits_, is_within);
  }

  void CutAt(const Point2& way) {
    const auto has_shelf = [&](const Tower& t) { return way.dot(Place(t.points.front() - t.points.back())) > 0; };
    if (has_shelf(a_) && has_shelf(b_)) return;
    const std::optional<End> end_a = EndOf(a_, way), end_b = EndOf(b_, way);
    if (!end_a || !end_b) return;
    limits_.push_back({way, std::min(way.dot(Place(end_a->top)), way.dot(Place(end_b->top)))});
  }

  std::optional<End> EndOf(const Tower& tower, const Point2& way) const {
    const auto along = [&](const Point3& p) { return way.dot(Place(p)); };
    std::optional<Point3> top;
    for (const Point3& p : tower.points) {
      if (StandsOnIt(p) && (!top || along(p) > along(*top))) top = p;
    }
    const Point3 &first = tower.points.front(), &last = tower.points.back();
    if (!top) return std::nullopt;
    return End{*top, along(first) > along(last) ? first : last};
  }

  void AddWall(const End& a, const End& b, const Point2& way) {
    const Point2 across = Place(b.top) - Place(a.top);
    const double length = across.norm();
    if (!(length > 0)) return;
    Point2 outward(across.y() / length, -across.x() / length);
    if (outward.dot(way) < 0) outward = -outward;
    const int steps = static_cast<int>(std::ceil(length / rule_.spacing));
    for (int k = 0; k <= steps; ++k) {
      const double t = static_cast<double>(k) / steps;
      const Point2 top = Place(a.top) + t * across, foot = top + rule_.wall * outward;
      ground_.emplace_back(top.x(), top.y(), height_);
      if (k == 0 || k == steps) continue;  // there is the shore
      ground_.emplace_back(foot.x(), foot.y(), std::min(height_, a.foot.z() + t * (b.foot.z() - a.foot.z())));
    }
  }

  const Tower &a_, &b_;
  const PlatformRule rule_;
  const double height_;
  std::vector<Limit> limits_;
  std::vector<Point3> ground_;
};

}  // namespace

std::vector<Point3> FindPlatforms(std::span<const Point3> points, std::span<const ShorePoint> kinds,
                                  std::span<const DirectedEdge> edges, const PlatformRule& rule) {
  if (points.empty()) return {};
  const TowerFinder finder(points, kinds, edges, rule);
  const std::vector<Tower>& towers = finder.towers();
  std::vector<Point3> ground;
  for (size_t i = 0; i < towers.size(); ++i) {
    for (size_t k = i + 1; k < towers.size(); ++k) {
      if (!ShareAPlatform(towers[i], towers[k], rule)) continue;
      const Platform platform(towers[i], towers[k], rule);
      ground.insert(ground.end(), platform.ground().begin(), platform.ground().end());
    }
  }
  return ground;
}

}  // namespace tilemend
