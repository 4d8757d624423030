// The patches of a cell's holes that were made so far, by where they lie.
#ifndef TILEMEND_WORKER_FILL_SPACE_EARLIER_PATCHES_H_
#define TILEMEND_WORKER_FILL_SPACE_EARLIER_PATCHES_H_

#include <Eigen/Geometry>
#include <vector>

#include "common/mesh/box_tree.h"
#include "worker/fill/hole/local_patch.h"
#include "worker/fill/space/patch_crossings.h"

namespace tilemend {

// Grows with each patch: it keeps trees of sizes that are powers of two, and two of one size become one (Bentley and
// Saxe 1980), O(log^2 n) a patch.
class EarlierPatches {
 public:
  // Both must outlive it. Patches are taken by their numbers, so `patches` may grow.
  EarlierPatches(const CellHoles& cell, const std::vector<HolePatch>& patches) : cell_(cell), patches_(patches) {}

  // Takes in the last of the patches.
  void TakeLast();
  // Appends their triangles that meet the box, in their order.
  void AppendNear(const Eigen::AlignedBox3d& box, std::vector<SpaceTriangle>& found) const;

 private:
  SpaceTriangle InSpace(const HolePatch& patch, const Triangle& t) const;

  struct Tree {
    std::vector<size_t> numbers;  // of patches
    std::vector<Eigen::AlignedBox3d> boxes;
    BoxTree tree;
  };

  const CellHoles& cell_;
  const std::vector<HolePatch>& patches_;
  std::vector<Tree> trees_;  // the larger before the smaller
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SPACE_EARLIER_PATCHES_H_
