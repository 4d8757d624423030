#include "worker/fill/wang/minimum_area.h"

#include <limits>
#include <utility>

#include "common/mesh/triangle_shape.h"

namespace tilemend {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

class LeastArea {
 public:
  LeastArea(std::span<const Point3> loop, const std::function<bool(int32_t, int32_t)>& joins,
            const std::function<bool(int32_t, int32_t, int32_t)>& fits)
      : loop_(loop), joins_(joins), fits_(fits), n_(static_cast<int32_t>(loop.size())) {
    area_.assign(static_cast<size_t>(n_) * n_, 0);
    apex_.assign(static_cast<size_t>(n_) * n_, -1);
  }

  std::vector<Triangle> Run() {
    for (int32_t span = 2; span < n_; ++span) {
      for (int32_t i = 0; i + span < n_; ++i) Solve(i, i + span);
    }
    std::vector<Triangle> triangles;
    if (area_[At(0, n_ - 1)] == kNever) return triangles;
    std::vector<std::pair<int32_t, int32_t>> open = {{0, n_ - 1}};
    while (!open.empty()) {
      const auto [i, k] = open.back();
      open.pop_back();
      if (k - i < 2) continue;
      const int32_t j = apex_[At(i, k)];
      triangles.push_back({i, j, k});
      open.emplace_back(i, j);
      open.emplace_back(j, k);
    }
    return triangles;
  }

 private:
  size_t At(int32_t i, int32_t k) const { return static_cast<size_t>(i) * n_ + k; }

  void Solve(int32_t i, int32_t k) {
    double best = kNever;
    const bool closes = i == 0 && k == n_ - 1;
    if (closes || joins_(i, k)) {
      for (int32_t j = i + 1; j < k; ++j) {
        const double parts = area_[At(i, j)] + area_[At(j, k)];
        if (!(parts < best)) continue;
        const double own = TriangleArea(loop_[i], loop_[j], loop_[k]);
        if (!(own > 0) || !(parts + own < best) || !fits_(i, j, k)) continue;
        best = parts + own;
        apex_[At(i, k)] = j;
      }
    }
    area_[At(i, k)] = best;
  }

  std::span<const Point3> loop_;
  const std::function<bool(int32_t, int32_t)>& joins_;
  const std::function<bool(int32_t, int32_t, int32_t)>& fits_;
  const int32_t n_;
  std::vector<double> area_;  // least, of what lies between loop[i] and loop[k]
  std::vector<int32_t> apex_;
};

}  // namespace

std::vector<Triangle> TriangulateLeastArea(std::span<const Point3> loop,
                                           const std::function<bool(int32_t, int32_t)>& joins,
                                           const std::function<bool(int32_t, int32_t, int32_t)>& fits) {
  if (loop.size() < 3) return {};
  return LeastArea(loop, joins, fits).Run();
}

}  // namespace tilemend
