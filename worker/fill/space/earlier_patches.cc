#include "worker/fill/space/earlier_patches.h"

#include <algorithm>

namespace tilemend {

SpaceTriangle EarlierPatches::InSpace(const HolePatch& patch, const Triangle& t) const {
  const auto at = [&](int32_t v) { return v >= 0 ? cell_.vertices[v].position : patch.new_points[-1 - v]; };
  return {at(t[0]), at(t[1]), at(t[2])};
}

void EarlierPatches::TakeLast() {
  const HolePatch& patch = patches_.back();
  if (patch.triangles.empty()) return;
  Eigen::AlignedBox3d box;
  for (const Triangle& t : patch.triangles) box.extend(BoxOf(InSpace(patch, t)));
  Tree last{{patches_.size() - 1}, {box}, {}};
  while (!trees_.empty() && trees_.back().numbers.size() == last.numbers.size()) {
    Tree& other = trees_.back();
    last.numbers.insert(last.numbers.end(), other.numbers.begin(), other.numbers.end());
    last.boxes.insert(last.boxes.end(), other.boxes.begin(), other.boxes.end());
    trees_.pop_back();
  }
  last.tree = BoxTree(last.boxes);
  trees_.push_back(std::move(last));
}

void EarlierPatches::AppendNear(const Eigen::AlignedBox3d& box, std::vector<SpaceTriangle>& found) const {
  std::vector<size_t> near;
  for (const Tree& tree : trees_) {
    tree.tree.AnyMeeting(box, [&](int32_t i) {
      near.push_back(tree.numbers[static_cast<size_t>(i)]);
      return false;
    });
  }
  std::ranges::sort(near);
  for (const size_t number : near) {
    for (const Triangle& t : patches_[number].triangles) {
      const SpaceTriangle triangle = InSpace(patches_[number], t);
      if (box.intersects(BoxOf(triangle))) found.push_back(triangle);
    }
  }
}

}  // namespace tilemend
