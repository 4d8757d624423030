#include "coordinator/plan/seam/seam_path.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace tilemend {
namespace {

constexpr size_t kLookAhead = 8;    // vertices of the way that may be passed over to get around an obstacle
constexpr size_t kMaxDetour = 200;  // rim points that a detour considers
// A rim point nearer than this share of an edge's length to the edge makes a triangle with it of quality below 0.3.
constexpr double kFlat = 0.2;

class PathFinder {
 public:
  PathFinder(const std::vector<int32_t>& way, const Rim& rim, const RimIndex& index,
             const std::function<Point2(int32_t)>& position)
      : way_(way), rim_(rim), index_(index), position_(position) {
    points_ = static_cast<int32_t>(rim.points.size());
  }

  std::optional<std::vector<int32_t>> Find() {
    std::vector<int32_t> path = {way_.front()};
    for (size_t i = 0; i + 1 < way_.size();) {
      const size_t last = std::min(way_.size() - 1, i + kLookAhead);
      size_t next = i + 1;
      while (next <= last && !Joined(way_[i], way_[next])) ++next;
      if (next > last) {
        const auto detour = Detour(i);
        if (!detour) return std::nullopt;
        path.insert(path.end(), detour->first.begin(), detour->first.end());
        i = detour->second;
        continue;
      }
      path.push_back(way_[next]);
      i = next;
    }
    return path;
  }

  // The way, which is a path already, bent over rim points beside it.
  std::vector<int32_t> Bend(double reach) const {
    std::set<int32_t> taken(way_.begin(), way_.end());
    std::vector<int32_t> path = {way_.front()};
    std::vector<int32_t> ahead(way_.rbegin(), way_.rend() - 1);
    while (!ahead.empty()) {
      const int32_t beside = PointBeside(path.back(), ahead.back(), taken, reach);
      if (beside >= 0) {
        taken.insert(beside);
        ahead.push_back(beside);
      } else {
        path.push_back(ahead.back());
        ahead.pop_back();
      }
    }
    return path;
  }

 private:
  // The rim point nearest to the line from a to b, and within `reach` of it, that the path between them can be bent to;
  // -1: none.
  int32_t PointBeside(int32_t a, int32_t b, const std::set<int32_t>& taken, double reach) const {
    if (IsRimEdge(a, b)) return -1;
    const Point2 p = position_(a), way = position_(b) - p;
    const double length2 = way.squaredNorm(), length = std::sqrt(length2);
    const Point2 beside = Point2::Constant(std::min(kFlat * length, reach));
    double nearest = std::min(kFlat * length2, reach * length);  // distance from the line times length
    int32_t best = -1;
    for (const int32_t i : index_.EdgesIn(p.cwiseMin(p + way) - beside, p.cwiseMax(p + way) + beside)) {
      const int32_t v = rim_.edges[i].from;
      const Point2 to = position_(v) - p;
      const double off = std::abs(way.x() * to.y() - way.y() * to.x()), along = way.dot(to);
      if (off >= nearest || along <= 0 || along >= length2 || taken.contains(v)) continue;
      if (!Joined(a, v) || !Joined(v, b)) continue;
      nearest = off;
      best = v;
    }
    return best;
  }

  int32_t RimPointOf(int32_t v) const { return v < points_ ? v : -1; }

  bool IsRimEdge(int32_t a, int32_t b) const { return a < points_ && b < points_ && index_.EdgeBetween(a, b) >= 0; }

  bool Joined(int32_t a, int32_t b) const {
    return index_.IsFree(position_(a), RimPointOf(a), position_(b), RimPointOf(b)) || IsRimEdge(a, b);
  }

  // Shortest way from way[i] over rim points near the line to a later vertex of the way. Returns the vertices after
  // way[i] and the place of the last one in the way.
  std::optional<std::pair<std::vector<int32_t>, size_t>> Detour(size_t i) const {
    const size_t last = std::min(way_.size() - 1, i + 4 * kLookAhead);
    std::vector<int32_t> nodes(way_.begin() + static_cast<ptrdiff_t>(i),
                               way_.begin() + static_cast<ptrdiff_t>(last) + 1);
    const size_t on_way = nodes.size();
    AddRimPoints(position_(way_[i]), position_(way_[last]), nodes);
    std::vector<double> cost(nodes.size(), std::numeric_limits<double>::infinity());
    std::vector<int32_t> from(nodes.size(), -1);
    std::vector<bool> done(nodes.size(), false);
    cost[0] = 0;
    while (true) {
      size_t u = nodes.size();
      for (size_t k = 0; k < nodes.size(); ++k) {
        if (!done[k] && cost[k] < std::numeric_limits<double>::infinity() && (u == nodes.size() || cost[k] < cost[u]))
          u = k;
      }
      if (u == nodes.size()) return std::nullopt;
      done[u] = true;
      if (u != 0 && u < on_way) return Trace(nodes, from, u, i);
      for (size_t k = 1; k < nodes.size(); ++k) {
        if (done[k]) continue;
        const double c = cost[u] + (position_(nodes[k]) - position_(nodes[u])).norm();
        if (c < cost[k] && Joined(nodes[u], nodes[k])) {
          cost[k] = c;
          from[k] = static_cast<int32_t>(u);
        }
      }
    }
  }

  void AddRimPoints(const Point2& a, const Point2& b, std::vector<int32_t>& nodes) const {
    const Point2 reach = Point2::Constant(4 * index_.mean_size());
    std::set<int32_t> found;
    for (const int32_t i : index_.EdgesIn(a.cwiseMin(b) - reach, a.cwiseMax(b) + reach)) {
      found.insert(rim_.edges[i].from);
      found.insert(rim_.edges[i].to);
    }
    for (const int32_t v : nodes) found.erase(v);
    std::vector<std::pair<double, int32_t>> near;
    for (const int32_t v : found) near.emplace_back((position_(v) - a).norm(), v);
    std::sort(near.begin(), near.end());
    if (near.size() > kMaxDetour) near.resize(kMaxDetour);
    for (const auto& [distance, v] : near) nodes.push_back(v);
  }

  static std::pair<std::vector<int32_t>, size_t> Trace(const std::vector<int32_t>& nodes,
                                                       const std::vector<int32_t>& from, size_t end, size_t i) {
    std::vector<int32_t> path;
    for (auto k = static_cast<int32_t>(end); k != 0; k = from[k]) path.push_back(nodes[k]);
    std::reverse(path.begin(), path.end());
    return {path, i + end};
  }

  const std::vector<int32_t>& way_;
  const Rim& rim_;
  const RimIndex& index_;
  const std::function<Point2(int32_t)>& position_;
  int32_t points_;
};

}  // namespace

std::optional<std::vector<int32_t>> FindSeamPath(const std::vector<int32_t>& way, const Rim& rim, const RimIndex& index,
                                                 const std::function<Point2(int32_t)>& position) {
  return PathFinder(way, rim, index, position).Find();
}

std::vector<int32_t> BendToRim(const std::vector<int32_t>& path, const Rim& rim, const RimIndex& index,
                               const std::function<Point2(int32_t)>& position, double reach) {
  return PathFinder(path, rim, index, position).Bend(reach);
}

}  // namespace tilemend
