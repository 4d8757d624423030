#include "worker/check/box_pairs.h"

#include <algorithm>
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

  void Run(std::vector<int32_t> group, int depth) const {
    if (group.size() <= kFew || depth >= kDeepest) return CompareAll(group);
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
    if (static_cast<double>(on_both) > kMostOnBoth * static_cast<double>(group.size())) return CompareAll(group);
    group = {};
    Run(std::move(below), depth + 1);
    Run(std::move(above), depth + 1);
  }

 private:
  // Along x, so that far ones are not compared.
  void CompareAll(std::vector<int32_t>& group) const {
    std::sort(group.begin(), group.end(), [&](int32_t a, int32_t b) {
      return std::pair(boxes_[a].min().x(), a) < std::pair(boxes_[b].min().x(), b);
    });
    for (size_t i = 0; i < group.size(); ++i) {
      for (size_t k = i + 1; k < group.size() && boxes_[group[k]].min().x() <= boxes_[group[i]].max().x(); ++k) {
        if (boxes_[group[i]].intersects(boxes_[group[k]])) {
          const auto [a, b] = std::minmax(group[i], group[k]);
          found_(a, b);
        }
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
  PairFinder(boxes, found).Run(std::move(all), 0);
}

}  // namespace tilemend
