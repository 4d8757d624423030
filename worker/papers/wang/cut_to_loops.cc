#include "worker/papers/wang/cut_to_loops.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <tuple>
#include <utility>

#include "common/mesh/disjoint_sets.h"

namespace tilemend {
namespace {

// Side k of a triangle lies opposite to its corner k.
struct Side {
  int32_t triangle = -1;
  int k = 0;
};

class Cutter {
 public:
  Cutter(const RegionTriangulation& region, std::span<const LatticePoint> points, int32_t longest)
      : region_(region), points_(points), longest_(longest) {
    for (const auto& neighbors : region.neighbors) {
      walls_.push_back({neighbors[0] < 0, neighbors[1] < 0, neighbors[2] < 0});
    }
  }

  CutRegion Run() {
    BuildBridges();
    std::vector<bool> seen(region_.triangles.size(), false);
    for (int32_t t = 0; t < std::ssize(region_.triangles); ++t) {
      if (!seen[t]) TakePart(t, seen);
    }
    return std::move(cut_);
  }

 private:
  int32_t From(const Side& s) const { return region_.triangles[s.triangle][(s.k + 1) % 3]; }
  int32_t To(const Side& s) const { return region_.triangles[s.triangle][(s.k + 2) % 3]; }

  Side Across(const Side& s) const {
    const int32_t other = region_.neighbors[s.triangle][s.k];
    for (int k = 0; k < 3; ++k) {
      if (region_.neighbors[other][k] == s.triangle && From({other, k}) == To(s)) return {other, k};
    }
    return {};
  }

  void Wall(const Side& s) {
    const Side other = Across(s);
    walls_[s.triangle][s.k] = walls_[other.triangle][other.k] = true;
  }

  int64_t SquaredLength(const Side& s) const {
    const LatticePoint &a = points_[From(s)], &b = points_[To(s)];
    return (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
  }

  void BuildBridges() {
    DisjointSets joined(static_cast<int32_t>(points_.size()));
    std::vector<std::tuple<int64_t, int32_t, int>> inner;
    for (int32_t t = 0; t < std::ssize(region_.triangles); ++t) {
      for (int k = 0; k < 3; ++k) {
        const Side s{t, k};
        if (walls_[t][k]) {
          joined.Join(From(s), To(s));
        } else if (From(s) < To(s)) {
          inner.emplace_back(SquaredLength(s), t, k);
        }
      }
    }
    std::sort(inner.begin(), inner.end());
    for (const auto& [length, t, k] : inner) {
      const Side s{t, k};
      if (joined.LowestOf(From(s)) == joined.LowestOf(To(s))) continue;
      joined.Join(From(s), To(s));
      Wall(s);
    }
  }

  // The triangles that no wall parts from the first, each with the side through which it was reached.
  std::vector<Side> PartAt(int32_t first) const {
    std::vector<Side> part = {{first, -1}};
    for (size_t i = 0; i < part.size(); ++i) {
      const Side reached = part[i];
      for (int k = 0; k < 3; ++k) {
        if (k == reached.k || walls_[reached.triangle][k]) continue;
        part.push_back(Across({reached.triangle, k}));
      }
    }
    return part;
  }

  // Without points inside, the triangles of a part are a tree.
  void TakePart(int32_t first, std::vector<bool>& seen) {
    std::vector<int32_t> open = {first};
    while (!open.empty()) {
      const std::vector<Side> part = PartAt(open.back());
      if (std::ssize(part) + 2 > longest_) {
        const Side cut = MostEvenCut(part);
        open.push_back(cut.triangle);
        Wall(cut);
        ++cut_.cuts;
        continue;
      }
      open.pop_back();
      for (const Side& s : part) seen[s.triangle] = true;
      cut_.loops.push_back(LoopAround(part.front().triangle));
    }
  }

  Side MostEvenCut(const std::vector<Side>& part) const {
    std::vector<int64_t> below(region_.triangles.size(), 0);
    std::tuple<int64_t, int64_t, size_t> best{std::ssize(part) + 1, 0, 0};
    for (size_t i = part.size(); i-- > 1;) {
      const Side& reached = part[i];
      const int64_t own = ++below[reached.triangle];
      below[region_.neighbors[reached.triangle][reached.k]] += own;
      const int64_t uneven = std::abs(2 * own - std::ssize(part));
      best = std::min(best, {uneven, SquaredLength(reached), i});
    }
    return part[std::get<2>(best)];
  }

  std::vector<int32_t> LoopAround(int32_t triangle) const {
    // Every part has a wall at one of its triangles.
    const std::vector<Side> part = PartAt(triangle);
    Side start;
    for (size_t i = 0; start.triangle < 0; ++i) {
      for (int k = 0; k < 3; ++k) {
        if (walls_[part[i].triangle][k]) start = {part[i].triangle, k};
      }
    }
    std::vector<int32_t> loop;
    Side s = start;
    do {
      loop.push_back(From(s));
      s.k = (s.k + 1) % 3;  // the side that begins where this one ends
      while (!walls_[s.triangle][s.k]) {
        s = Across(s);
        s.k = (s.k + 1) % 3;
      }
    } while (s.triangle != start.triangle || s.k != start.k);
    return loop;
  }

  const RegionTriangulation& region_;
  std::span<const LatticePoint> points_;
  const int32_t longest_;
  std::vector<std::array<bool, 3>> walls_;
  CutRegion cut_;
};

}  // namespace

CutRegion CutToLoops(const RegionTriangulation& triangulation, std::span<const LatticePoint> points, int32_t longest) {
  return Cutter(triangulation, points, longest).Run();
}

}  // namespace tilemend
