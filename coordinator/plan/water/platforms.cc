#include "coordinator/plan/water/platforms.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <tuple>
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

// The lowest and the highest of values in a row, to which new ones come while the first ones leave. Constant cost for
// each, amortized.
class SlidingRange {
 public:
  void Add(double value) {
    while (!lows_.empty() && lows_.back().second >= value) lows_.pop_back();
    while (!highs_.empty() && highs_.back().second <= value) highs_.pop_back();
    lows_.emplace_back(end_, value);
    highs_.emplace_back(end_, value);
    ++end_;
  }
  void DropFirst() {
    if (lows_.front().first == begin_) lows_.pop_front();
    if (highs_.front().first == begin_) highs_.pop_front();
    ++begin_;
  }
  Interval range() const { return {lows_.front().second, highs_.front().second}; }
  Interval With(double value) const { return lows_.empty() ? Interval(value, value) : Extended(range(), value); }

 private:
  std::deque<std::pair<int64_t, double>> lows_, highs_;  // which value it is; those that may become the range's ends
  int64_t begin_ = 0, end_ = 0;
};

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
    if (kinds[i] != ShorePoint::kGround) continue;
    const Point3& p = points[i];
    const auto is_lower_ground = [&](int32_t k) {
      return kinds[k] == ShorePoint::kGround && points[k].z() < p.z() - rule.lift &&
             (Place(points[k]) - Place(p)).norm() <= rule.beside;
    };
    bool above = false;
    bins.ForBins({Place(p) - reach, Place(p) + reach}, [&](int64_t, std::span<const int32_t> around) {
      above = above || std::ranges::any_of(around, is_lower_ground);
    });
    low[i] = !above;
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
    std::ranges::sort(towers_, {}, [](const Tower& t) { return std::tuple(t.middle.x(), t.middle.y(), t.shelf); });
  }

  // From west to east, in whatever order the edges come.
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

  // The height of the shelf on the way from the ground at the first point up to the top. Each point of the way in turn
  // begins a stretch, which goes on as long as its heights are those of a shelf.
  std::optional<double> ShelfFromFirst(const Tower& tower) const {
    const std::vector<Point3>& way = tower.points;
    const double ground = way.front().z();
    const double top = std::ranges::max(way, {}, [](const Point3& p) { return p.z(); }).z();
    double highest = ground;  // so far
    SlidingRange heights, along;
    size_t end = 1;
    for (size_t first = 1; first < way.size() && way[first].z() <= top - rule_.tower; ++first) {
      for (; end < way.size() && Length(heights.With(way[end].z())) <= rule_.roughness; ++end) {
        heights.Add(way[end].z());
        along.Add(tower.Along(way[end]));
      }
      const auto [low, high] = heights.range();
      const bool is_long = Length(along.range()) >= rule_.extent;
      if (is_long && low >= ground + rule_.lift && high <= top - rule_.tower && highest <= high) {
        return MedianHeight({way.begin() + static_cast<ptrdiff_t>(first), way.begin() + static_cast<ptrdiff_t>(end)});
      }
      highest = std::max(highest, way[first].z());
      heights.DropFirst();
      along.DropFirst();
    }
    return std::nullopt;
  }

  static double MedianHeight(std::span<const Point3> points) {
    std::vector<double> heights;
    for (const Point3& p : points) heights.push_back(p.z());
    std::ranges::nth_element(heights, heights.begin() + std::ssize(heights) / 2);
    return heights[heights.size() / 2];
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
    const Point2 along = (a.along - b.along).normalized();
    const std::vector<Point2> ways = {along, -along};
    std::vector<Limit> limits;
    for (const Point2& way : ways) {
      if (const std::optional<double> most = MostAlong(way)) limits.push_back({way, *most});
    }
    limits_ = std::move(limits);
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

  // How far the platform reaches that way, if not from shelf to shelf.
  std::optional<double> MostAlong(const Point2& way) const {
    const auto has_shelf = [&](const Tower& t) { return way.dot(Place(t.points.front() - t.points.back())) > 0; };
    if (has_shelf(a_) && has_shelf(b_)) return std::nullopt;
    const std::optional<End> end_a = EndOf(a_, way), end_b = EndOf(b_, way);
    if (!end_a || !end_b) return std::nullopt;
    return std::min(way.dot(Place(end_a->top)), way.dot(Place(end_b->top)));
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
    for (int k = 1; k < steps; ++k) {  // both ends are points of the towers
      const double t = static_cast<double>(k) / steps;
      const Point2 top = Place(a.top) + t * across, foot = top + rule_.wall * outward;
      ground_.emplace_back(top.x(), top.y(), height_);
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
