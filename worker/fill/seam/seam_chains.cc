#include "worker/fill/seam/seam_chains.h"

#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace tilemend {
namespace {

constexpr uint8_t kCorner = 3;  // RimVertex::lines

using Edge = std::pair<int32_t, int32_t>;

class ChainFinder {
 public:
  explicit ChainFinder(const CellHoles& cluster) : cluster_(cluster) {
    for (const CellHole& hole : cluster.holes) {
      for (const RimSegment& s : hole.segments) {
        if (!s.seam) continue;
        directed_.insert({s.from, s.to});
        neighbours_[s.from].insert(s.to);
        neighbours_[s.to].insert(s.from);
      }
    }
  }

  std::vector<SeamChain> Run() {
    std::vector<SeamChain> chains;
    for (const auto& [v, neighbours] : neighbours_) {
      if (IsInner(v)) continue;
      for (const int32_t next : neighbours) {
        if (!walked_.contains({v, next})) chains.push_back(Walk(v, next));
      }
    }
    return chains;
  }

 private:
  // Whether a chain goes on through v: a new vertex on one grid line between two segments of the same directions.
  bool IsInner(int32_t v) const {
    const RimVertex& vertex = cluster_.vertices[v];
    const std::set<int32_t>& around = neighbours_.at(v);
    if (vertex.index >= 0 || vertex.lines == kCorner || around.size() != 2) return false;
    const int32_t a = *around.begin(), b = *around.rbegin();
    return directed_.contains({a, v}) == directed_.contains({v, b}) &&
           directed_.contains({v, a}) == directed_.contains({b, v});
  }

  SeamChain Walk(int32_t from, int32_t to) {
    SeamChain chain;
    chain.forward = directed_.contains({from, to});
    chain.backward = directed_.contains({to, from});
    chain.vertices = {from};
    while (true) {
      chain.vertices.push_back(to);
      walked_.insert({from, to});
      walked_.insert({to, from});
      if (!IsInner(to)) return chain;
      const std::set<int32_t>& around = neighbours_.at(to);
      const int32_t next = *around.begin() == from ? *around.rbegin() : *around.begin();
      from = std::exchange(to, next);
    }
  }

  const CellHoles& cluster_;
  std::set<Edge> directed_, walked_;
  std::map<int32_t, std::set<int32_t>> neighbours_;
};

// The slope at the middle one of three knots of the parabola through them.
double ParabolaSlope(double x0, double x1, double x2, double y0, double y1, double y2) {
  const double left = (y1 - y0) / (x1 - x0), right = (y2 - y1) / (x2 - x1);
  return (left * (x2 - x1) + right * (x1 - x0)) / (x2 - x0);
}

}  // namespace

std::vector<SeamChain> SeamChains(const CellHoles& cluster) { return ChainFinder(cluster).Run(); }

std::vector<size_t> ThinnedChain(const CellHoles& cluster, const SeamChain& chain, double factor) {
  std::vector<size_t> kept = {0};
  double since = 0;
  for (size_t i = 1; i + 1 < chain.vertices.size(); ++i) {
    const RimVertex& v = cluster.vertices[chain.vertices[i]];
    since += (v.position - cluster.vertices[chain.vertices[i - 1]].position).head<2>().norm();
    if (since < factor * v.size) continue;
    kept.push_back(i);
    since = 0;
  }
  kept.push_back(chain.vertices.size() - 1);
  return kept;
}

std::vector<double> LinearAlong(std::span<const double> knots, std::span<const double> values,
                                std::span<const double> at) {
  std::vector<double> result;
  size_t i = 0;
  for (const double x : at) {
    while (i + 2 < knots.size() && x > knots[i + 1]) ++i;
    result.push_back(std::lerp(values[i], values[i + 1], (x - knots[i]) / (knots[i + 1] - knots[i])));
  }
  return result;
}

std::vector<double> InterpolatedAlong(std::span<const double> knots, std::span<const double> values,
                                      std::span<const double> at) {
  const size_t n = knots.size();
  const auto chord = [&](size_t i) { return (values[i + 1] - values[i]) / (knots[i + 1] - knots[i]); };
  std::vector<double> slopes(n);
  for (size_t i = 1; i + 1 < n; ++i) {
    slopes[i] = ParabolaSlope(knots[i - 1], knots[i], knots[i + 1], values[i - 1], values[i], values[i + 1]);
  }
  // The parabola of the nearest three knots goes on to the ends.
  slopes[0] = n > 2 ? 2 * chord(0) - slopes[1] : chord(0);
  slopes[n - 1] = n > 2 ? 2 * chord(n - 2) - slopes[n - 2] : chord(0);
  std::vector<double> result;
  size_t i = 0;
  for (const double x : at) {
    while (i + 2 < n && x > knots[i + 1]) ++i;
    const double length = knots[i + 1] - knots[i], t = (x - knots[i]) / length, s = 1 - t;
    result.push_back(values[i] * s * s * (1 + 2 * t) + values[i + 1] * t * t * (1 + 2 * s) +
                     length * s * t * (slopes[i] * s - slopes[i + 1] * t));
  }
  return result;
}

}  // namespace tilemend
