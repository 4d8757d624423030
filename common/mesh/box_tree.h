// Finds boxes in space by where they lie.
#ifndef TILEMEND_COMMON_MESH_BOX_TREE_H_
#define TILEMEND_COMMON_MESH_BOX_TREE_H_

#include <Eigen/Geometry>
#include <cstdint>
#include <span>
#include <vector>

namespace tilemend {

// A binary tree of boxes over boxes, parted at the median of their middles along the longest axis. Things of very
// different size may be together, as long as most overlap few others. Building: O(n log n); some 60 bytes a box.
// Deterministic; safe from any thread once built.
class BoxTree {
 public:
  BoxTree() = default;
  explicit BoxTree(std::span<const Eigen::AlignedBox3d> boxes);

  // Calls visit(i) for the number i of each box that meets `box` until one returns true; returns whether one did. In an
  // order that depends on the boxes alone.
  template <typename Visit>
  bool AnyMeeting(const Eigen::AlignedBox3d& box, const Visit& visit) const {
    return AnyWhere([&](const Eigen::AlignedBox3d& other) { return other.intersects(box); }, visit);
  }

  // The same for the boxes for which meets(box) holds; it must hold for a box that has one in it for which it does.
  template <typename Meets, typename Visit>
  bool AnyWhere(const Meets& meets, const Visit& visit) const;

 private:
  struct Node {
    Eigen::AlignedBox3d box;
    int32_t first = 0, last = 0;  // of items_
    int32_t next = 0;             // the node after this one and all below it
    bool is_leaf = false;
  };
  struct Item {
    Eigen::AlignedBox3d box;
    int32_t number;
  };

  void Build(int32_t first, int32_t last);

  std::vector<Item> items_;
  std::vector<Node> nodes_;  // each before those below it
};

template <typename Meets, typename Visit>
bool BoxTree::AnyWhere(const Meets& meets, const Visit& visit) const {
  const auto count = static_cast<int32_t>(nodes_.size());
  for (int32_t n = 0; n < count;) {
    const Node& node = nodes_[n];
    if (!meets(node.box)) {
      n = node.next;
      continue;
    }
    if (node.is_leaf) {
      for (int32_t i = node.first; i < node.last; ++i) {
        if (meets(items_[i].box) && visit(items_[i].number)) return true;
      }
    }
    ++n;
  }
  return false;
}

}  // namespace tilemend

#endif  // TILEMEND_COMMON_MESH_BOX_TREE_H_
