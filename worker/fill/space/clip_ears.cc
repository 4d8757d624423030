#include "worker/fill/space/clip_ears.h"

#include <Eigen/Geometry>
#include <limits>
#include <queue>
#include <tuple>

namespace tilemend {
namespace {

using Eigen::Vector3d;

// Three places in a row whose triangle is flatter than this have no normal to go by.
constexpr double kLeastSine = 1e-6;
// Cosines between an ear and the surface beside it, and how much longer its edge counts below each. Noise along a rim
// tilts ears; a notch turns them over.
constexpr std::pair<double, double> kTilts[] = {{0.8, 1}, {0.5, 2}, {0, 4}, {-0.3, 16}};
constexpr double kNever = std::numeric_limits<double>::infinity();

class EarClipper {
 public:
  EarClipper(std::span<const Point3> loop, std::span<const Vector3d> outside,
             const std::function<bool(int32_t, int32_t)>& allowed, CrossingIndex& taken)
      : loop_(loop), allowed_(allowed), taken_(taken), left_(static_cast<int32_t>(loop.size())) {
    clipped_.outside.assign(outside.begin(), outside.end());
    for (int32_t i = 0; i < left_; ++i) {
      next_.push_back((i + 1) % left_);
      before_.push_back((i + left_ - 1) % left_);
    }
    version_.assign(loop.size(), 0);
  }

  ClippedLoop Run(int32_t most) {
    for (int32_t i = 0; i < static_cast<int32_t>(loop_.size()); ++i) Push(i);
    int32_t last = 0;
    while (left_ > most && !ears_.empty()) {
      const auto [cost, tip, version] = ears_.top();
      ears_.pop();
      if (version != version_[tip]) continue;
      const Triangle ear{before_[tip], tip, next_[tip]};
      const SpaceTriangle in_space{loop_[ear[0]], loop_[ear[1]], loop_[ear[2]]};
      if (taken_.IsCrossedBy(in_space)) continue;
      taken_.Add(in_space);
      Clip(ear);
      last = ear[0];
    }
    CollectRest(last);
    return std::move(clipped_);
  }

 private:
  using Ear = std::tuple<double, int32_t, int32_t>;  // what it costs, its tip, the version of that

  Vector3d AreaVector(int32_t a, int32_t b, int32_t c) const {
    return (loop_[b] - loop_[a]).cross(loop_[c] - loop_[b]);
  }

  double CostOf(int32_t tip) const {
    const int32_t a = before_[tip], c = next_[tip];
    const Vector3d area = AreaVector(a, tip, c);
    const double size = area.norm();
    if (size <= kLeastSine * (loop_[tip] - loop_[a]).norm() * (loop_[c] - loop_[tip]).norm()) return kNever;
    if (!allowed_(a, c)) return kNever;
    const Vector3d beside = clipped_.outside[a] + clipped_.outside[tip];
    const double cosine = beside.isZero() ? 1 : area.dot(beside) / (size * beside.norm());
    for (const auto& [least, factor] : kTilts) {
      if (cosine > least) return factor * (loop_[c] - loop_[a]).norm();
    }
    return kNever;
  }

  void Push(int32_t tip) {
    const double cost = CostOf(tip);
    if (cost < kNever) ears_.push({cost, tip, version_[tip]});
  }

  void Clip(const Triangle& ear) {
    const auto& [a, tip, c] = ear;
    clipped_.triangles.push_back(ear);
    clipped_.outside[a] = AreaVector(a, tip, c).normalized();
    next_[a] = c;
    before_[c] = a;
    ++version_[tip];
    --left_;
    for (const int32_t v : {a, c}) {
      ++version_[v];
      Push(v);
    }
  }

  void CollectRest(int32_t first) {
    std::vector<Vector3d> outside;
    for (int32_t i = first, k = 0; k < left_; i = next_[i], ++k) {
      clipped_.rest.push_back(i);
      outside.push_back(clipped_.outside[i]);
    }
    clipped_.outside = std::move(outside);
  }

  std::span<const Point3> loop_;
  const std::function<bool(int32_t, int32_t)>& allowed_;
  CrossingIndex& taken_;
  int32_t left_;
  std::vector<int32_t> next_, before_, version_;
  std::priority_queue<Ear, std::vector<Ear>, std::greater<>> ears_;
  ClippedLoop clipped_;  // `outside` by place until the end
};

}  // namespace

ClippedLoop ClipEars(std::span<const Point3> loop, std::span<const Vector3d> outside,
                     const std::function<bool(int32_t, int32_t)>& allowed, int32_t most, CrossingIndex& taken) {
  return EarClipper(loop, outside, allowed, taken).Run(most);
}

}  // namespace tilemend
