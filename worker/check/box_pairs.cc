#include "worker/check/box_pairs.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace tilemend {
namespace {

constexpr size_t kFew = 48;          // boxes are compared each with each
constexpr int kDeepest = 60;         // boxes that all overlap cannot be parted
constexpr double kMostOnBoth = 0.5;  // share of the boxes that lie on both sides of a cut that parts too little

class PairFinder {
 public:
  PairFinder(std::span<const Eigen::AlignedBox3d> boxes, const std::function<void(int32_t, int32_t)>& found)
      : boxes_(boxes), found_(found) {}

  // Finds pairs among the group whose first common place, the lowest in each coordinate, lies in the part of space
  // beyond `from` up to `to`: cuts part space, so that each pair is found in one group.
  void Run(std::vector<int32_t> group, const Eigen::Vector3d& from, const Eigen::Vector3d& to, int depth) const {
    if (group.size() <= kFew || depth >= kDeepest) return CompareAll(group, from, to);
    Eigen::AlignedBox3d middles;
    for (const int32_t i : group) middles.extend(Eigen::Vector3d(boxes_[i].center()));
    int axis = 0;
    middles.sizes().maxCoeff(&axis);
    const auto half = group.begin() + static_cast<ptrdiff_t>(group.size() / 2);
    std::nth_element(group.begin(), half, group.end(),
                     [&](int32_t a, int32_t b) { return boxes_[a].center()[axis] < boxes_[b].center()[axis]; });
    const double cut = boxes_[*half].center()[axis];
    std::vector<int32_t> below, above;
    for (const int32_t i : group) {
      if (boxes_[i].min()[axis] <= cut) below.push_back(i);
      if (boxes_[i].max()[axis] >= cut) above.push_back(i);
    }
    const size_t on_both = below.size() + above.size() - group.size();
    if (static_cast<double>(on_both) > kMostOnBoth * static_cast<double>(group.size())) {
      return CompareAll(group, from, to);
    }
    group = {};
    Eigen::Vector3d at_cut = to;
    at_cut[axis] = std::min(to[axis], cut);
    Run(std::move(below), from, at_cut, depth + 1);
    at_cut = from;
    at_cut[axis] = std::max(from[axis], cut);
    Run(std::move(above), at_cut, to, depth + 1);
  }

 private:
  // Along x, so that far ones are not compared.
  void CompareAll(std::vector<int32_t>& group, const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
    std::sort(group.begin(), group.end(), [&](int32_t a, int32_t b) {
      return std::pair(boxes_[a].min().x(), a) < std::pair(boxes_[b].min().x(), b);
    });
    for (size_t i = 0; i < group.size(); ++i) {
      for (size_t k = i + 1; k < group.size() && boxes_[group[k]].min().x() <= boxes_[group[i]].max().x(); ++k) {
        const Eigen::AlignedBox3d &one = boxes_[group[i]], &other = boxes_[group[k]];
        if (!one.intersects(other)) continue;
        const Eigen::Vector3d first = one.min().cwiseMax(other.min());
        if (!(first.array() > from.array()).all() || !(first.array() <= to.array()).all()) continue;
        const auto [a, b] = std::minmax(group[i], group[k]);
        found_(a, b);
      }
    }
  }

  std::span<const Eigen::AlignedBox3d> boxes_;
  const std::function<void(int32_t, int32_t)>& found_;
};

}  // namespace

void ForBoxPairs(std::span<const Eigen::AlignedBox3d> boxes, const std::function<void(int32_t a, int32_t b)>& found) {
  std::vector<int32_t> all(boxes.size());
  std::iota(all.begin(), all.end(), 0);
  constexpr double kFar = std::numeric_limits<double>::infinity();
  PairFinder(boxes, found).Run(std::move(all), Eigen::Vector3d::Constant(-kFar), Eigen::Vector3d::Constant(kFar), 0);
}

}  // namespace tilemend
