#include "worker/fill/space/minimum_weight.h"

#include <algorithm>
#include <utility>

#include "worker/fill/mesh/span_triangulation.h"

namespace tilemend {
namespace {

// Angles are compared in steps of this, so that area decides between triangulations that bend alike.
constexpr double kAngleStep = 1.0 / 64;

// Of a triangle that is taken though it does not fit: no angle is as large, and no area in m2.
constexpr double kMisfitAngle = 4, kMisfitArea = 1e9;

// Of a unit normal and another one; 0 where that is unknown.
double Bend(const Eigen::Vector3d& normal, const Eigen::Vector4d& other) {
  return static_cast<int>((other.w() - normal.dot(other.head<3>())) / kAngleStep) * kAngleStep;
}

// A unit normal, or zero where unknown, with 1 or 0 behind.
Eigen::Vector4d Marked(const Eigen::Vector3d& normal) {
  return {normal.x(), normal.y(), normal.z(), normal.isZero() ? 0.0 : 1.0};
}

}  // namespace

LoopTriangulation::LoopTriangulation(std::span<const Point3> loop, std::span<const Eigen::Vector3d> outside,
                                     const std::function<bool(int32_t, int32_t)>& allowed,
                                     const std::function<bool(int32_t, int32_t, int32_t)>& fits, Misfits misfits)
    : loop_(loop),
      outside_(outside),
      allowed_(allowed),
      fits_(fits),
      misfits_(misfits),
      n_(static_cast<int32_t>(loop.size())) {
  const auto spans = static_cast<size_t>(n_) * static_cast<size_t>(n_);
  best_.resize(spans);
  best_by_end_.resize(spans);
  choice_.assign(spans, -1);
  normal_.assign(spans, Eigen::Vector4d::Zero());
  normal_by_end_ = normal_;
  is_stale_.assign(spans, 1);
  for (int32_t i = 0; i + 1 < n_; ++i) normal_[At(i, i + 1)] = normal_by_end_[At(i + 1, i)] = Marked(outside_[i]);
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
  const auto [best, choice] = (i == 0 && k == n_ - 1) || allowed_(i, k) ? Choose(i, k) : Choice();
  if (choice == choice_[at] && best.angle == best_[at].angle && best.area == best_[at].area) return;
  best_[at] = best_by_end_[At(k, i)] = best;
  choice_[at] = choice;
  normal_[at] = normal_by_end_[At(k, i)] =
      choice < 0 ? Eigen::Vector4d::Zero() : Marked(AreaVector(i, choice, k).normalized());
  changed_from_[i] = std::min(changed_from_[i], k);
  changed_to_[k] = std::max(changed_to_[k], i);
}

// Most often the best of all triangles fits, and is the only one that is asked for.
LoopTriangulation::Choice LoopTriangulation::Choose(int32_t i, int32_t k) const {
  Choice best;
  for (int32_t j = i + 1; j < k; ++j) Try(i, j, k, best);
  if (best.vertex < 0 || !fits_ || fits_(i, best.vertex, k)) return best;
  std::vector<Choice> others;
  for (int32_t j = i + 1; j < k; ++j) {
    Choice other;
    if (j != best.vertex) Try(i, j, k, other);
    if (other.vertex >= 0) others.push_back(other);
  }
  std::sort(others.begin(), others.end());
  const auto fitting = std::ranges::find_if(others, [&](const Choice& other) { return fits_(i, other.vertex, k); });
  if (fitting != others.end()) return *fitting;
  if (misfits_ == Misfits::kNone) return {};
  best.weight.angle = kMisfitAngle;
  best.weight.area += kMisfitArea;
  return best;
}

// Takes triangle i, j, k where that is better.
void LoopTriangulation::Try(int32_t i, int32_t j, int32_t k, Choice& best) const {
  const Weight &left = best_[At(i, j)], &right = best_by_end_[At(k, j)];
  double angle = std::max(left.angle, right.angle);
  const double sides = left.area + right.area;
  if (!(Weight{angle, sides} < best.weight)) return;  // the triangle itself only adds to these
  const Eigen::Vector3d area = AreaVector(i, j, k);
  const double size = area.norm();
  if (size <= 0) return;
  const Eigen::Vector3d normal = area / size;
  angle = std::max({angle, Bend(normal, normal_[At(i, j)]), Bend(normal, normal_by_end_[At(k, j)])});
  if (i == 0 && k == n_ - 1) angle = std::max(angle, Bend(normal, Marked(outside_[static_cast<size_t>(k)])));
  const Weight weight{angle, sides + size};
  if (weight < best.weight) best = {weight, j};
}

std::vector<Triangle> TriangulateLoop(std::span<const Point3> loop, std::span<const Eigen::Vector3d> outside,
                                      const std::function<bool(int32_t, int32_t)>& allowed,
                                      const std::function<bool(int32_t, int32_t, int32_t)>& fits) {
  return LoopTriangulation(loop, outside, allowed, fits).Run();
}

}  // namespace tilemend
