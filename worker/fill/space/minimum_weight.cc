#include "worker/fill/space/minimum_weight.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "worker/fill/mesh/span_triangulation.h"

namespace tilemend {
namespace {

// Worst dihedral angle (as 1 - cosine, 0 flat, 2 folded back), then area.
struct Weight {
  double angle = 0;
  double area = 0;
  bool operator<(const Weight& other) const { return angle != other.angle ? angle < other.angle : area < other.area; }
};

constexpr double kNever = std::numeric_limits<double>::infinity();
// Angles are compared in steps of this, so that area decides between triangulations that bend alike.
constexpr double kAngleStep = 1.0 / 64;

class LoopTriangulator {
 public:
  LoopTriangulator(std::span<const Point3> loop, std::span<const Eigen::Vector3d> outside,
                   const std::function<bool(int32_t, int32_t)>& allowed,
                   const std::function<bool(int32_t, int32_t, int32_t)>& fits)
      : loop_(loop), outside_(outside), allowed_(allowed), fits_(fits), n_(static_cast<int32_t>(loop.size())) {
    best_.resize(static_cast<size_t>(n_) * n_);
    choice_.assign(static_cast<size_t>(n_) * n_, -1);
  }

  std::vector<Triangle> Run() {
    return TriangulateSpans(
        n_, [this](int32_t i, int32_t k) { Solve(i, k); }, [this](int32_t i, int32_t k) { return choice_[At(i, k)]; });
  }

 private:
  size_t At(int32_t i, int32_t k) const { return static_cast<size_t>(i) * n_ + k; }

  Eigen::Vector3d AreaVector(int32_t i, int32_t j, int32_t k) const {
    return (loop_[j] - loop_[i]).cross(loop_[k] - loop_[i]) / 2;
  }

  // Normal of the triangle on the other side of chord (a, b), a < b, as far as it is settled.
  Eigen::Vector3d Beyond(int32_t a, int32_t b) const {
    if (b - a == 1) return outside_[a];
    const int32_t m = choice_[At(a, b)];
    return m < 0 ? Eigen::Vector3d::Zero() : Eigen::Vector3d(AreaVector(a, m, b).normalized());
  }

  static double Bend(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    if (a.isZero() || b.isZero()) return 0;
    return std::floor((1 - a.dot(b)) / kAngleStep) * kAngleStep;
  }

  void Solve(int32_t i, int32_t k) {
    Weight best{kNever, kNever};
    const bool closing = i == 0 && k == n_ - 1;
    if (closing || allowed_(i, k)) {
      for (int32_t j = i + 1; j < k; ++j) Try(i, j, k, closing, best);
    }
    best_[At(i, k)] = best;
  }

  void Try(int32_t i, int32_t j, int32_t k, bool closing, Weight& best) {
    const Weight left = j - i > 1 ? best_[At(i, j)] : Weight{}, right = k - j > 1 ? best_[At(j, k)] : Weight{};
    if (left.angle == kNever || right.angle == kNever) return;
    // The triangle itself only adds to these.
    if (!(Weight{std::max(left.angle, right.angle), left.area + right.area} < best)) return;
    const Eigen::Vector3d area = AreaVector(i, j, k);
    const double size = area.norm();
    if (size <= 0) return;
    const Eigen::Vector3d normal = area / size;
    double angle = std::max({left.angle, right.angle, Bend(normal, Beyond(i, j)), Bend(normal, Beyond(j, k))});
    if (closing) angle = std::max(angle, Bend(normal, outside_[k]));
    const Weight weight{angle, left.area + right.area + size};
    if (!(weight < best) || (fits_ && !fits_(i, j, k))) return;
    best = weight;
    choice_[At(i, k)] = j;
  }

  std::span<const Point3> loop_;
  std::span<const Eigen::Vector3d> outside_;
  const std::function<bool(int32_t, int32_t)>& allowed_;
  const std::function<bool(int32_t, int32_t, int32_t)>& fits_;
  int32_t n_;
  std::vector<Weight> best_;
  std::vector<int32_t> choice_;
};

}  // namespace

std::vector<Triangle> TriangulateLoop(std::span<const Point3> loop, std::span<const Eigen::Vector3d> outside,
                                      const std::function<bool(int32_t, int32_t)>& allowed,
                                      const std::function<bool(int32_t, int32_t, int32_t)>& fits) {
  if (loop.size() < 3) return {};
  return LoopTriangulator(loop, outside, allowed, fits).Run();
}

}  // namespace tilemend
