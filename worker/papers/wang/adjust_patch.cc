#include "worker/papers/wang/adjust_patch.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace tilemend {
namespace {

// Nearer neighbours weigh no more than one at this distance, metres: two points are never at one place for long.
constexpr double kLeastDistance = 1e-6;

class Adjuster {
 public:
  Adjuster(const PatchSurroundings& around, NewPatch& patch)
      : around_(around), patch_(patch), neighbors_(patch.points.size() + around.points.size(), [&](const auto& use) {
          for (const std::vector<Triangle>* triangles : {&std::as_const(patch.triangles), &around.triangles}) {
            for (const Triangle& t : *triangles) {
              for (int k = 0; k < 3; ++k) {
                use(t[k], t[(k + 1) % 3]);
                use(t[k], t[(k + 2) % 3]);
              }
            }
          }
        }) {}

  void Run() {
    PointMover mover(patch_);
    for (const std::vector<int32_t>& ring : Rings()) {
      std::vector<Point3> moved;
      for (const int32_t v : ring) moved.push_back(WeightedMean(v));
      for (size_t i = 0; i < ring.size(); ++i) mover.Move(ring[i], moved[i]);
    }
  }

 private:
  // New points by their distance from the rim in edges, each ring in rising order.
  std::vector<std::vector<int32_t>> Rings() const {
    std::vector<bool> seen(patch_.points.size(), false);
    std::vector<std::vector<int32_t>> rings(1);
    for (int32_t v = 0; v < patch_.rim_count; ++v) {
      seen[v] = true;
      rings[0].push_back(v);
    }
    while (!rings.back().empty()) {
      std::vector<int32_t> next;
      for (const int32_t v : rings.back()) {
        for (const int32_t n : neighbors_.Of(v)) {
          if (n >= patch_.size() || seen[n]) continue;
          seen[n] = true;
          next.push_back(n);
        }
      }
      std::sort(next.begin(), next.end());
      rings.push_back(std::move(next));
    }
    rings.erase(rings.begin());
    return rings;
  }

  const Point3& At(int32_t v) const { return v < patch_.size() ? patch_.points[v] : around_.points[v - patch_.size()]; }

  Point3 WeightedMean(int32_t v) const {
    std::vector<int32_t> all;
    for (const int32_t n : neighbors_.Of(v)) {
      all.push_back(n);
      for (const int32_t second : neighbors_.Of(n)) all.push_back(second);
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    Point3 sum = Point3::Zero();
    double weights = 0;
    for (const int32_t n : all) {
      if (n == v) continue;
      const double weight = 1 / std::max((At(n) - At(v)).norm(), kLeastDistance);
      sum += weight * At(n);
      weights += weight;
    }
    return weights > 0 ? Point3(sum / weights) : At(v);
  }

  const PatchSurroundings& around_;
  NewPatch& patch_;
  const VertexLists neighbors_;  // first neighbours; most of them twice
};

}  // namespace

void AdjustPatch(const PatchSurroundings& around, NewPatch& patch) { Adjuster(around, patch).Run(); }

}  // namespace tilemend
