#include "worker/fill/space/minimum_weight.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "worker/fill/mesh/span_triangulation.h"

namespace tilemend {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
// Angles are compared in steps of this, so that area decides between triangulations that bend alike.
constexpr double kAngleStep = 1.0 / 64;

double Bend(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  if (a.isZero() || b.isZero()) return 0;
  return std::floor((1 - a.dot(b)) / kAngleStep) * kAngleStep;
}

}  // namespace

LoopTriangulation::LoopTriangulation(std::span<const Point3> loop, std::span<const Eigen::Vector3d> outside,
                                     const std::function<bool(int32_t, int32_t)>& allowed,
                                     const std::function<bool(int32_t, int32_t, int32_t)>& fits)
    : loop_(loop), outside_(outside), allowed_(allowed), fits_(fits), n_(static_cast<int32_t>(loop.size())) {
  const auto spans = static_cast<size_t>(n_) * static_cast<size_t>(n_);
  best_.resize(spans);
  best_by_end_.resize(spans);
  choice_.assign(spans, -1);
  normal_.assign(spans, Eigen::Vector3d::Zero());
  is_stale_.assign(spans, 1);
  for (int32_t i = 0; i + 1 < n_; ++i) normal_[At(i, i + 1)] = outside_[i];
}

std::vector<Triangle> LoopTriangulation::Run() {
  if (n_ < 3) return {};
  changed_from_.assign(static_cast<size_t>(n_), n_);
  changed_to_.assign(static_cast<size_t>(n_), -1);
  return TriangulateSpans(
      n_, [this](int32_t i, int32_t k) { Solve(i, k); }, [this](int32_t i, int32_t k) { return choice_[At(i, k)]; });
}

// What lies from i to k depends on the spans that begin at i and those that end at k, all solved before.
void LoopTriangulation::Solve(int32_t i, int32_t k) {
  const size_t at = At(i, k);
  if (!is_stale_[at] && changed_from_[i] >= k && changed_to_[k] <= i) return;
  is_stale_[at] = 0;
  Weight best{kNever, kNever};
  int32_t choice = -1;
  const bool closing = i == 0 && k == n_ - 1;
  if (closing || allowed_(i, k)) {
    for (int32_t j = i + 1; j < k; ++j) Try(i, j, k, closing, best, choice);
  }
  if (choice == choice_[at] && best.angle == best_[at].angle && best.area == best_[at].area) return;
  best_[at] = best_by_end_[At(k, i)] = best;
  choice_[at] = choice;
  normal_[at] = choice < 0 ? Eigen::Vector3d::Zero() : Eigen::Vector3d(AreaVector(i, choice, k).normalized());
  changed_from_[i] = std::min(changed_from_[i], k);
  changed_to_[k] = std::max(changed_to_[k], i);
}

void LoopTriangulation::Try(int32_t i, int32_t j, int32_t k, bool closing, Weight& best, int32_t& choice) const {
  const Weight &left = best_[At(i, j)], &right = best_by_end_[At(k, j)];
  if (left.angle == kNever || right.angle == kNever) return;
  // The triangle itself only adds to these.
  if (!(Weight{std::max(left.angle, right.angle), left.area + right.area} < best)) return;
  const Eigen::Vector3d area = AreaVector(i, j, k);
  const double size = area.norm();
  if (size <= 0) return;
  const Eigen::Vector3d normal = area / size;
  double angle = std::max({left.angle, right.angle, Bend(normal, normal_[At(i, j)]), Bend(normal, normal_[At(j, k)])});
  if (closing) angle = std::max(angle, Bend(normal, outside_[k]));
  const Weight weight{angle, left.area + right.area + size};
  if (!(weight < best) || (fits_ && !fits_(i, j, k))) return;
  best = weight;
  choice = j;
}

std::vector<Triangle> TriangulateLoop(std::span<const Point3> loop, std::span<const Eigen::Vector3d> outside,
                                      const std::function<bool(int32_t, int32_t)>& allowed,
                                      const std::function<bool(int32_t, int32_t, int32_t)>& fits) {
  return LoopTriangulation(loop, outside, allowed, fits).Run();
}

}  // namespace tilemend
