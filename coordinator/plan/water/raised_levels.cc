#include "coordinator/plan/water/raised_levels.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "common/mesh/disjoint_sets.h"

namespace tilemend {
namespace {

// Two points of the ground, neighbours along the shore.
struct Link {
  int32_t a, b;
  bool over_object;
};

class Levels {
 public:
  Levels(std::span<const Point3> points, std::span<const ShorePoint> kinds, std::span<const DirectedEdge> edges,
         const LevelRule& rule)
      : points_(points), kinds_(kinds), edges_(edges), rule_(rule), levels_(static_cast<int32_t>(points.size())) {
    const std::vector<Link> links = Links();
    for (const Link& link : links) {
      if (IsLevel(link)) levels_.Join(link.a, link.b);
    }
    for (const Link& link : links) {
      if (!IsWall(link)) continue;
      walls_[levels_.LowestOf(link.a)].emplace_back(levels_.LowestOf(link.b), Rise(link));
      walls_[levels_.LowestOf(link.b)].emplace_back(levels_.LowestOf(link.a), -Rise(link));
    }
    for (const DirectedEdge& e : edges_) {
      if (levels_.LowestOf(e.from) == levels_.LowestOf(e.to))
        length_[levels_.LowestOf(e.from)] += Distance(e.from, e.to);
    }
  }

  std::vector<bool> Raised() {
    for (const auto& [level, walls] : walls_) {
      if (!height_.contains(level)) MeasureTogether(level);
    }
    std::vector<bool> raised(points_.size());
    for (size_t v = 0; v < points_.size(); ++v) {
      const auto height = height_.find(levels_.LowestOf(static_cast<int32_t>(v)));
      raised[v] = IsGround(v) && height != height_.end() && height->second >= rule_.lift;
    }
    return raised;
  }

 private:
  bool IsGround(size_t v) const { return kinds_[v] == ShorePoint::kGround; }
  double Rise(const Link& link) const { return points_[link.b].z() - points_[link.a].z(); }
  double Distance(int32_t a, int32_t b) const { return (points_[b] - points_[a]).head<2>().norm(); }

  bool IsWall(const Link& link) const {
    const double ground = rule_.noise + rule_.slope * Distance(link.a, link.b);
    return std::abs(Rise(link)) > std::max(rule_.lift, ground);
  }

  bool IsLevel(const Link& link) const {
    return link.over_object ? std::abs(Rise(link)) <= rule_.same_level : !IsWall(link);
  }

  // Along edges, and over each object between the lowest point beside it and the others.
  std::vector<Link> Links() const {
    std::vector<Link> links;
    DisjointSets objects(static_cast<int32_t>(points_.size()));
    for (const DirectedEdge& e : edges_) {
      if (IsGround(e.from) && IsGround(e.to)) links.push_back({e.from, e.to, false});
      if (!IsGround(e.from) && !IsGround(e.to)) objects.Join(e.from, e.to);
    }
    std::map<int32_t, std::vector<int32_t>> beside;
    for (const DirectedEdge& e : edges_) {
      if (IsGround(e.from) != IsGround(e.to)) {
        beside[objects.LowestOf(IsGround(e.from) ? e.to : e.from)].push_back(IsGround(e.from) ? e.from : e.to);
      }
    }
    for (const auto& [object, ground] : beside) {
      const int32_t lowest = *std::min_element(ground.begin(), ground.end(), [&](int32_t a, int32_t b) {
        return std::pair(points_[a].z(), a) < std::pair(points_[b].z(), b);
      });
      for (const int32_t v : ground) {
        if (v != lowest) links.push_back({lowest, v, true});
      }
    }
    return links;
  }

  // The heights of a level and of all that walls lead to from there, over the ground.
  void MeasureTogether(int32_t first) {
    height_[first] = 0;
    std::vector<int32_t> together = {first};
    for (size_t i = 0; i < together.size(); ++i) {
      for (const auto& [to, rise] : walls_[together[i]]) {
        if (height_.try_emplace(to, height_[together[i]] + rise).second) together.push_back(to);
      }
    }
    const double ground = CommonHeight(together);
    for (const int32_t level : together) height_[level] -= ground;
  }

  // That of the level that most of the shore is at, less than a lift up or down.
  double CommonHeight(const std::vector<int32_t>& together) {
    double common = 0, longest = -1;
    for (const int32_t level : together) {
      double length = 0;
      for (const int32_t other : together) {
        if (std::abs(height_[other] - height_[level]) < rule_.lift) length += length_[other];
      }
      if (length > longest) common = height_[level];
      longest = std::max(longest, length);
    }
    return common;
  }

  const std::span<const Point3> points_;
  const std::span<const ShorePoint> kinds_;
  const std::span<const DirectedEdge> edges_;
  const LevelRule rule_;
  DisjointSets levels_;                                               // of the ground
  std::map<int32_t, std::vector<std::pair<int32_t, double>>> walls_;  // of a level: where to, and how far up
  std::map<int32_t, double> length_;
  std::map<int32_t, double> height_;
};

}  // namespace

std::vector<bool> OnRaisedLevels(std::span<const Point3> points, std::span<const ShorePoint> kinds,
                                 std::span<const DirectedEdge> edges, const LevelRule& rule) {
  return Levels(points, kinds, edges, rule).Raised();
}

}  // namespace tilemend
