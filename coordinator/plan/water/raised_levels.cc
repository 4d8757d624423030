#include "coordinator/plan/water/raised_levels.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "common/mesh/disjoint_sets.h"

namespace tilemend {
namespace {

class Levels {
 public:
  Levels(std::span<const Point3> points, std::span<const ShorePoint> kinds, std::span<const DirectedEdge> edges,
         std::span<const int32_t> ends, const LevelRule& rule)
      : points_(points), kinds_(kinds), edges_(edges), rule_(rule), levels_(static_cast<int32_t>(points.size())) {
    objects_ = GroundBesideObjects(points, kinds, edges);
    const std::vector<GroundLink> links = LinkGround(kinds, edges, objects_);
    for (const GroundLink& link : links) {
      if (IsLevel(link)) levels_.Join(link.a, link.b);
    }
    for (const GroundLink& link : links) {
      if (IsWall(link)) Lead(levels_.LowestOf(link.a), levels_.LowestOf(link.b), Rise(link));
    }
    LinkAcross(ends);
    for (const DirectedEdge& e : edges_) {
      if (levels_.LowestOf(e.from) == levels_.LowestOf(e.to))
        length_[levels_.LowestOf(e.from)] += Distance(e.from, e.to);
    }
  }

  std::vector<bool> Raised() {
    for (const auto& [level, ways] : ways_) {
      if (!height_.contains(level)) MeasureTogether(level);
    }
    std::vector<bool> raised(points_.size());
    for (size_t v = 0; v < points_.size(); ++v) {
      const auto height = height_.find(levels_.LowestOf(static_cast<int32_t>(v)));
      raised[v] = IsGround(v) && height != height_.end() && height->second >= rule_.lift;
    }
    RaiseLedges(raised);
    return raised;
  }

 private:
  bool IsGround(size_t v) const { return kinds_[v] == ShorePoint::kGround; }
  double Rise(const GroundLink& link) const { return points_[link.b].z() - points_[link.a].z(); }
  double Distance(int32_t a, int32_t b) const { return (points_[b] - points_[a]).head<2>().norm(); }

  bool IsWall(const GroundLink& link) const {
    const double ground = rule_.noise + rule_.slope * Distance(link.a, link.b);
    return std::abs(Rise(link)) > std::max(rule_.lift, ground);
  }

  bool IsLevel(const GroundLink& link) const {
    return link.over_object ? std::abs(Rise(link)) <= rule_.same_level : !IsWall(link);
  }

  void Lead(int32_t from, int32_t to, double rise) {
    ways_[from].emplace_back(to, rise);
    ways_[to].emplace_back(from, -rise);
  }

  using Square = std::pair<int64_t, int64_t>;
  Square SquareOf(const Point3& p) const {
    return {static_cast<int64_t>(std::floor(p.x() / rule_.across)),
            static_cast<int64_t>(std::floor(p.y() / rule_.across))};
  }

  // From levels at ends to those as high, and down to those lower by a wall, each where they are nearest.
  void LinkAcross(std::span<const int32_t> ends) {
    std::set<int32_t> at_end;
    for (const int32_t v : ends) at_end.insert(levels_.LowestOf(v));
    std::map<Square, std::vector<int32_t>> ground;
    for (int32_t v = 0; !at_end.empty() && v < std::ssize(points_); ++v) {
      if (IsGround(v)) ground[SquareOf(points_[v])].push_back(v);
    }
    std::map<std::pair<int32_t, int32_t>, std::pair<double, double>> nearest;  // how far, how much higher the end is
    const auto compare = [&](int32_t v, int32_t other) {
      const GroundLink link{other, v, true};
      const double far = Distance(v, other);
      const std::pair levels(levels_.LowestOf(other), levels_.LowestOf(v));
      const bool leads = std::abs(Rise(link)) <= rule_.same_level || (Rise(link) > 0 && IsWall(link));
      if (far > rule_.across || levels.first == levels.second || !leads) return;
      const auto [it, fresh] = nearest.try_emplace(levels, far, Rise(link));
      if (!fresh) it->second = std::min(it->second, std::pair(far, Rise(link)));
    };
    for (const auto& [square, points] : ground) {
      for (const int32_t v : points) {
        if (!at_end.contains(levels_.LowestOf(v))) continue;
        for (int64_t k = 0; k < 9; ++k) {
          const auto near = ground.find({square.first + k % 3 - 1, square.second + k / 3 - 1});
          if (near == ground.end()) continue;
          for (const int32_t other : near->second) compare(v, other);
        }
      }
    }
    for (const auto& [levels, way] : nearest) Lead(levels.first, levels.second, way.second);
  }

  void RaiseLedges(std::vector<bool>& raised) {
    std::map<int32_t, double> lift;  // of levels on objects that lead to raised ones: over the other ground there
    std::set<int32_t> at_raised;
    for (const std::vector<int32_t>& ground : objects_) {
      const bool leads = std::any_of(ground.begin(), ground.end(), [&](int32_t v) { return raised[v]; });
      for (const int32_t v : ground) {
        const int32_t level = levels_.LowestOf(v);
        if (leads) at_raised.insert(level);
        double& most = lift[level];
        most = std::max(most, points_[v].z() - points_[ground[0]].z());
      }
    }
    for (size_t v = 0; v < points_.size(); ++v) {
      const int32_t level = levels_.LowestOf(static_cast<int32_t>(v));
      const bool ledge = at_raised.contains(level) && length_[level] < rule_.ledge && lift[level] > rule_.ledge_lift;
      if (IsGround(v) && ledge) raised[v] = true;
    }
  }

  // The heights of a level and of all that walls lead to from there, over the ground.
  void MeasureTogether(int32_t first) {
    height_[first] = 0;
    std::vector<int32_t> together = {first};
    for (size_t i = 0; i < together.size(); ++i) {
      for (const auto& [to, rise] : ways_[together[i]]) {
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
  DisjointSets levels_;                                              // of the ground
  std::vector<std::vector<int32_t>> objects_;                        // of each: the ground beside it, the lowest first
  std::map<int32_t, std::vector<std::pair<int32_t, double>>> ways_;  // of a level: where to, and how far up
  std::map<int32_t, double> length_;
  std::map<int32_t, double> height_;
};

}  // namespace

std::vector<bool> OnRaisedLevels(std::span<const Point3> points, std::span<const ShorePoint> kinds,
                                 std::span<const DirectedEdge> edges, std::span<const int32_t> ends,
                                 const LevelRule& rule) {
  return Levels(points, kinds, edges, ends, rule).Raised();
}

}  // namespace tilemend
