#include "coordinator/plan/water/terraces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "common/mesh/bin_grid.h"
#include "common/mesh/disjoint_sets.h"

namespace tilemend {
namespace {

constexpr double kMostBins = 1000;  // along a side

struct Stretch {
  double length = 0;  // metres of shore
  Eigen::AlignedBox2d box;
  int ways_down = 0, other_ways = 0;  // off it: down over an object, and others
  std::vector<int32_t> points;
};

class Terraces {
 public:
  Terraces(std::span<const Point3> points, std::span<const ShorePoint> kinds, std::span<const DirectedEdge> edges,
           const TerraceRule& rule)
      : points_(points), kinds_(kinds), rule_(rule), levels_(static_cast<int32_t>(points.size())), bins_(Bins()) {
    const std::vector<GroundLink> links = LinkGround(kinds, edges, GroundBesideObjects(points, kinds, edges));
    for (const GroundLink& link : links) {
      if (IsLevel(link)) levels_.Join(link.a, link.b);
    }
    for (int32_t v = 0; v < std::ssize(points); ++v) {
      if (!IsGround(v)) continue;
      Stretch& stretch = stretches_[LevelOf(v)];
      stretch.points.push_back(v);
      stretch.box.extend(Point2(points[v].head<2>()));
    }
    for (const DirectedEdge& e : edges) {
      const bool within = IsGround(e.from) && IsGround(e.to) && LevelOf(e.from) == LevelOf(e.to);
      if (within) stretches_[LevelOf(e.from)].length += Distance(e.from, e.to);
    }
    for (const GroundLink& link : links) {
      if (LevelOf(link.a) == LevelOf(link.b)) continue;
      AddWay(link.a, link.b, link.over_object);
      AddWay(link.b, link.a, link.over_object);
    }
  }

  std::vector<bool> Raised() {
    std::set<int32_t> candidates, terraces;
    for (const auto& [level, stretch] : stretches_) {
      if (MayBeTerrace(stretch)) candidates.insert(level);
    }
    const std::vector<int32_t> may_be_terrace = LevelsOfPoints(candidates);
    for (const int32_t level : candidates) {
      if (LiesHigh(stretches_[level], may_be_terrace)) terraces.insert(level);
    }
    std::vector<bool> raised(points_.size());
    if (terraces.empty()) return raised;
    const std::vector<int32_t> terrace_of = LevelsOfPoints(terraces);
    for (const auto& [level, stretch] : stretches_) {
      if (!terraces.contains(level) && !IsScrap(stretch, terrace_of)) continue;
      for (const int32_t v : stretch.points) raised[v] = true;
    }
    return raised;
  }

 private:
  bool IsGround(int32_t v) const { return kinds_[v] == ShorePoint::kGround; }
  int32_t LevelOf(int32_t v) { return levels_.LowestOf(v); }
  double Distance(int32_t a, int32_t b) const { return (points_[b] - points_[a]).head<2>().norm(); }

  BinGrid Bins() const {
    Eigen::AlignedBox2d places(Point2(0, 0));
    if (!points_.empty()) places.setEmpty();
    for (const Point3& p : points_) places.extend(Point2(p.head<2>()));
    return {places, std::max(rule_.around / 4, places.sizes().maxCoeff() / kMostBins),
            static_cast<int32_t>(points_.size()),
            [&](int32_t i) { return Eigen::AlignedBox2d(Point2(points_[i].head<2>())); }};
  }

  bool IsLevel(const GroundLink& link) const {
    const double rise = std::abs(points_[link.b].z() - points_[link.a].z());
    return rise <= (link.over_object ? rule_.same_level : rule_.noise + rule_.slope * Distance(link.a, link.b));
  }

  void AddWay(int32_t from, int32_t to, bool over_object) {
    if (stretches_[LevelOf(to)].length < rule_.beside) return;
    Stretch& stretch = stretches_[LevelOf(from)];
    ++(over_object && IsLower(to, from) ? stretch.ways_down : stretch.other_ways);
  }

  bool IsLower(int32_t v, int32_t than) const { return points_[v].z() < points_[than].z() - rule_.lift; }

  bool MayBeTerrace(const Stretch& stretch) const {
    return stretch.box.diagonal().norm() >= rule_.extent && stretch.ways_down > 0 && stretch.other_ways == 0;
  }

  // The ground at most so far away, in any order.
  template <typename Visit>
  void ForGroundAround(int32_t v, double radius, const Visit& visit) const {
    const Point2 p = points_[v].head<2>(), reach = Point2::Constant(radius);
    bins_.ForBins({p - reach, p + reach}, [&](int64_t, std::span<const int32_t> around) {
      for (const int32_t k : around) {
        if (IsGround(k) && Distance(v, k) < radius) visit(k);
      }
    });
  }

  // The points of stretches, and of which: its level; of other points -1.
  std::vector<int32_t> LevelsOfPoints(const std::set<int32_t>& stretches) const {
    std::vector<int32_t> level_of(points_.size(), -1);
    for (const int32_t level : stretches) {
      for (const int32_t v : stretches_.at(level).points) level_of[v] = level;
    }
    return level_of;
  }

  // `may_be_terrace`: LevelsOfPoints of all that may be.
  bool LiesHigh(const Stretch& stretch, const std::vector<int32_t>& may_be_terrace) const {
    int64_t lower = 0, all = 0;
    for (const int32_t v : stretch.points) {
      ForGroundAround(v, rule_.around, [&](int32_t k) {
        const bool is_lower = IsLower(k, v);
        const bool is_another = may_be_terrace[k] >= 0 && may_be_terrace[k] != may_be_terrace[v];
        lower += is_lower;
        all += is_lower || !is_another;
      });
    }
    return static_cast<double>(lower) >= rule_.share * static_cast<double>(all);
  }

  // `terrace_of`: LevelsOfPoints of the terraces.
  bool IsScrap(const Stretch& stretch, const std::vector<int32_t>& terrace_of) const {
    if (stretch.length >= rule_.scrap) return false;
    return std::ranges::any_of(stretch.points, [&](int32_t v) {
      bool near = false;
      ForGroundAround(v, rule_.near, [&](int32_t k) {
        near = near || (terrace_of[k] >= 0 && points_[v].z() > points_[k].z() - rule_.same_level);
      });
      return near;
    });
  }

  const std::span<const Point3> points_;
  const std::span<const ShorePoint> kinds_;
  const TerraceRule rule_;
  DisjointSets levels_;                   // of the ground
  std::map<int32_t, Stretch> stretches_;  // by level
  const BinGrid bins_;
};

}  // namespace

std::vector<bool> OnTerraces(std::span<const Point3> points, std::span<const ShorePoint> kinds,
                             std::span<const DirectedEdge> edges, const TerraceRule& rule) {
  return Terraces(points, kinds, edges, rule).Raised();
}

}  // namespace tilemend
