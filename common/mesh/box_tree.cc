#include "common/mesh/box_tree.h"

#include <algorithm>
#include <utility>

namespace tilemend {
namespace {

constexpr int32_t kBoxesPerLeaf = 6;

}  // namespace

BoxTree::BoxTree(std::span<const Eigen::AlignedBox3d> boxes) {
  items_.reserve(boxes.size());
  for (const Eigen::AlignedBox3d& box : boxes) items_.push_back({box, static_cast<int32_t>(items_.size())});
  if (!items_.empty()) Build(0, static_cast<int32_t>(items_.size()));
}

void BoxTree::Build(int32_t first, int32_t last) {
  const size_t at = nodes_.size();
  Node node{{}, first, last, 0, last - first <= kBoxesPerLeaf};
  Eigen::AlignedBox3d middles;
  for (int32_t i = first; i < last; ++i) {
    node.box.extend(items_[i].box);
    middles.extend(Eigen::Vector3d(items_[i].box.center()));
  }
  nodes_.push_back(node);
  if (!node.is_leaf) {
    int axis = 0;
    middles.sizes().maxCoeff(&axis);
    const int32_t half = first + (last - first) / 2;
    const auto place = [axis](const Item& item) {
      return std::pair(item.box.min()[axis] + item.box.max()[axis], item.number);
    };
    std::nth_element(items_.begin() + first, items_.begin() + half, items_.begin() + last,
                     [&](const Item& a, const Item& b) { return place(a) < place(b); });
    Build(first, half);
    Build(half, last);
  }
  nodes_[at].next = static_cast<int32_t>(nodes_.size());
}

}  // namespace tilemend
