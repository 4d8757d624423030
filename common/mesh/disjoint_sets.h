// Things joined to groups, pair by pair (union-find).
#ifndef TILEMEND_COMMON_MESH_DISJOINT_SETS_H_
#define TILEMEND_COMMON_MESH_DISJOINT_SETS_H_

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace tilemend {

// Each thing, 0 to count - 1, begins as a group of its own. Join and LowestOf take O(log n) on average over all calls.
// The groups do not depend on the order in which pairs are joined.
class DisjointSets {
 public:
  explicit DisjointSets(int32_t count) : parent_(static_cast<size_t>(count)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  // Puts the groups of a and b together.
  void Join(int32_t a, int32_t b) {
    // Equal for most pairs, where things are joined to the same ones again and again. This test alone is inlined.
    if (parent_[a] != parent_[b]) JoinGroups(a, b);
  }

  // The lowest thing in i's group: the same for all of the group.
  int32_t LowestOf(int32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  // The group of each thing, numbered from 0 in order of their lowest things. O(n log n).
  std::vector<int32_t> Groups() {
    std::vector<int32_t> group(parent_.size());
    int32_t count = 0;
    for (int32_t i = 0; i < static_cast<int32_t>(group.size()); ++i) {
      const int32_t lowest = LowestOf(i);
      group[i] = lowest == i ? count++ : group[lowest];
    }
    return group;
  }

 private:
  // Inlined, it would keep Join from being so in the survey's loops.
  [[gnu::noinline]] void JoinGroups(int32_t a, int32_t b) {
    const auto [low, high] = std::minmax({LowestOf(a), LowestOf(b)});
    parent_[high] = low;
  }

  std::vector<int32_t> parent_;  // never higher than the thing
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_MESH_DISJOINT_SETS_H_
