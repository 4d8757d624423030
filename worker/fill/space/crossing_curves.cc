#include "worker/fill/space/crossing_curves.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "common/mesh/disjoint_sets.h"
#include "common/mesh/position_index.h"
#include "common/mesh/vertex_lists.h"
#include "worker/fill/space/patch_crossings.h"

namespace tilemend {
namespace {

bool HasCorner(const Triangle& t, int32_t v) { return std::ranges::find(t, v) != t.end(); }

class CurveTracer {
 public:
  CurveTracer(std::span<const Point3> points, std::span<const Triangle> triangles, const std::vector<bool>& is_added,
              std::span<const CrossingPair> pairs)
      : points_(points),
        triangles_(triangles),
        is_added_(is_added),
        pairs_(pairs),
        corners_(CornersAt(triangles, points.size())),
        curves_(static_cast<int32_t>(pairs.size())),
        goes_on_(pairs.size(), false) {}

  std::vector<bool> Run() {
    for (int32_t i = 0; i < std::ssize(pairs_); ++i) {
      GoOn(i, pairs_[i].a, pairs_[i].b);
      GoOn(i, pairs_[i].b, pairs_[i].a);
    }
    std::vector<bool> of_curve(pairs_.size(), false);
    for (int32_t i = 0; i < std::ssize(pairs_); ++i) {
      if (goes_on_[i]) of_curve[curves_.LowestOf(i)] = true;
    }
    for (int32_t i = 0; i < std::ssize(pairs_); ++i) goes_on_[i] = of_curve[curves_.LowestOf(i)];
    return std::move(goes_on_);
  }

 private:
  // Follows the curve of pair i over the edges of `own` that pass through `other`.
  void GoOn(int32_t i, int32_t own, int32_t other) {
    const Triangle &t = triangles_[own], &through = triangles_[other];
    const SpaceTriangle in_space = {points_[through[0]], points_[through[1]], points_[through[2]]};
    for (int k = 0; k < 3; ++k) {
      const int32_t u = t[k], v = t[(k + 1) % 3];
      if (HasCorner(through, u) || HasCorner(through, v)) continue;
      if (!SegmentCrosses(points_[u], points_[v], in_space)) continue;
      for (const int32_t corner : corners_.Of(u)) {
        const int32_t next = corner >> 2;
        if (next != own && HasCorner(triangles_[next], v)) GoOnTo(i, next, other);
      }
    }
  }

  void GoOnTo(int32_t i, int32_t next, int32_t other) {
    if (!is_added_[next] && !is_added_[other]) {
      goes_on_[i] = true;
      return;
    }
    const CrossingPair pair = {std::min(next, other), std::max(next, other)};
    const auto there = std::ranges::lower_bound(pairs_, pair);
    if (there != pairs_.end() && *there == pair) curves_.Join(i, static_cast<int32_t>(there - pairs_.begin()));
  }

  const std::span<const Point3> points_;
  const std::span<const Triangle> triangles_;
  const std::vector<bool>& is_added_;
  const std::span<const CrossingPair> pairs_;
  const VertexLists corners_;
  DisjointSets curves_;
  std::vector<bool> goes_on_;  // of each pair, at its own edges; then along its curve
};

}  // namespace

std::vector<bool> ContinueCrossings(std::span<const Point3> points, std::span<const Triangle> triangles,
                                    const std::vector<bool>& is_added, std::span<const CrossingPair> pairs) {
  return CurveTracer(points, triangles, is_added, pairs).Run();
}

std::vector<int32_t> AvoidableCrossings(std::span<const SpaceTriangle> patch, std::span<const SpaceTriangle> surface,
                                        std::span<const SpaceTriangle> earlier) {
  std::vector<CrossingPair> pairs;
  const auto add_pairs = [&](const auto& found, size_t first_of_a, size_t first_of_b) {
    for (const auto& [a, b] : found) {
      pairs.push_back({static_cast<int32_t>(first_of_a) + a, static_cast<int32_t>(first_of_b) + b});
    }
  };
  std::vector<SpaceTriangle> before;
  std::ranges::copy_if(earlier, std::back_inserter(before), HasArea);
  const size_t own = patch.size(), added = own + before.size();
  add_pairs(SelfCrossings(patch), 0, 0);
  add_pairs(SurfaceCrossings(patch, before), 0, own);
  add_pairs(SurfaceCrossings(patch, surface), 0, added);
  if (pairs.empty()) return {};
  add_pairs(SelfCrossings(before), own, own);
  add_pairs(SurfaceCrossings(before, surface), own, added);
  std::ranges::sort(pairs);
  PositionIndex index;
  std::vector<Triangle> triangles;
  for (const std::span<const SpaceTriangle> part : {patch, std::span<const SpaceTriangle>(before), surface}) {
    for (const SpaceTriangle& t : part) {
      triangles.push_back({index.Insert(t[0]), index.Insert(t[1]), index.Insert(t[2])});
    }
  }
  std::vector<bool> is_added(triangles.size(), false);
  std::fill_n(is_added.begin(), added, true);
  const std::vector<bool> of_input = ContinueCrossings(index.positions(), triangles, is_added, pairs);
  std::set<int32_t> avoidable;
  for (size_t i = 0; i < pairs.size(); ++i) {
    if (of_input[i]) continue;
    for (const int32_t t : {pairs[i].a, pairs[i].b}) {
      if (t < std::ssize(patch)) avoidable.insert(t);
    }
  }
  return {avoidable.begin(), avoidable.end()};
}

}  // namespace tilemend
