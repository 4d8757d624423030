#include "worker/papers/wang/minimum_area.h"

#include <limits>

#include "common/mesh/triangle_shape.h"
#include "worker/fill/mesh/span_triangulation.h"

namespace tilemend {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

class LeastArea {
 public:
  LeastArea(std::span<const Point3> loop, const std::function<bool(int32_t, int32_t)>& joins,
            const std::function<bool(int32_t, int32_t, int32_t)>& fits, const std::function<bool()>& is_cancelled)
      : loop_(loop), joins_(joins), fits_(fits), is_cancelled_(is_cancelled), n_(static_cast<int32_t>(loop.size())) {
    area_.assign(static_cast<size_t>(n_) * n_, 0);
    apex_.assign(static_cast<size_t>(n_) * n_, -1);
    closed_.resize(n_);
    for (int32_t i = 0; i + 1 < n_; ++i) closed_[i] = {i + 1};
  }

  std::vector<Triangle> Run() {
    return TriangulateSpans(
        n_, [this](int32_t i, int32_t k) { Solve(i, k); }, [this](int32_t i, int32_t k) { return apex_[At(i, k)]; });
  }

 private:
  size_t At(int32_t i, int32_t k) const { return static_cast<size_t>(i) * n_ + k; }

  void Solve(int32_t i, int32_t k) {
    double best = kNever;
    const bool closes = i == 0 && k == n_ - 1, cancelled = is_cancelled_ && is_cancelled_();
    if (!cancelled && (closes || joins_(i, k))) {
      for (const int32_t j : closed_[i]) {
        const double parts = area_[At(i, j)] + area_[At(k, j)];
        if (!(parts < best)) continue;
        const double own = TriangleArea(loop_[i], loop_[j], loop_[k]);
        if (!(own > 0) || !(parts + own < best) || !fits_(i, j, k)) continue;
        best = parts + own;
        apex_[At(i, k)] = j;
      }
    }
    area_[At(i, k)] = area_[At(k, i)] = best;
    if (best < kNever) closed_[i].push_back(k);
  }

  std::span<const Point3> loop_;
  const std::function<bool(int32_t, int32_t)>& joins_;
  const std::function<bool(int32_t, int32_t, int32_t)>& fits_;
  const std::function<bool()>& is_cancelled_;
  const int32_t n_;
  std::vector<double> area_;  // least, of what lies between loop[i] and loop[k]; the same at (k, i), for rows
  // For each i the places after it, in order, up to which what lies between can be closed: mostly few.
  std::vector<std::vector<int32_t>> closed_;
  std::vector<int32_t> apex_;
};

}  // namespace

std::vector<Triangle> TriangulateLeastArea(std::span<const Point3> loop,
                                           const std::function<bool(int32_t, int32_t)>& joins,
                                           const std::function<bool(int32_t, int32_t, int32_t)>& fits,
                                           const std::function<bool()>& is_cancelled) {
  if (loop.size() < 3) return {};
  return LeastArea(loop, joins, fits, is_cancelled).Run();
}

}  // namespace tilemend
