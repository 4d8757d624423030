// Whether a patch is a sound part of the surface around it.
#ifndef TILEMEND_WORKER_FILL_SPACE_PATCH_SOUNDNESS_H_
#define TILEMEND_WORKER_FILL_SPACE_PATCH_SOUNDNESS_H_

#include <Eigen/Geometry>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "worker/fill/hole/fill_options.h"
#include "worker/fill/hole/local_patch.h"
#include "worker/fill/hole/projection_frame.h"
#include "worker/fill/space/earlier_patches.h"

namespace tilemend {

// Why the patch would not close its hole to a manifold surface with area everywhere. Faults are a flat triangle, one
// that the surface has already, an edge with three triangles, a rim segment without one. O(n).
FillFailure FaultOf(const LocalHole& hole, const LocalPatch& patch);

// Whether the surface has a triangle of the patch already.
bool IsOfSurface(const LocalHole& hole, const Triangle& t);

// Whether a triangle of the patch does not face up.
bool FacesDown(const LocalHole& hole, const LocalPatch& patch, const ProjectionFrame& frame);

// Finds patches of one hole that pass through themselves, the surface around it, or patches made before.
//
// Triangles of the surface that pass through the hole's boundary do so through any patch: they do not count.
class CrossingCheck {
 public:
  //   reach    where a patch may go (ReachOf)
  //   near     gives the surface; without it the band stands for it. Asked when a patch is first tested
  //   earlier  patches of the cell's holes before; null: there is none
  // `hole` and `earlier` must outlive it.
  CrossingCheck(const LocalHole& hole, const Eigen::AlignedBox3d& reach, SurfaceNear near,
                const EarlierPatches* earlier)
      : hole_(hole), reach_(reach), near_(std::move(near)), earlier_(earlier) {}

  // Whether the patch keeps within reach.
  bool StaysNear(const LocalPatch& patch) const;
  bool Crosses(const LocalPatch& patch);
  // The numbers of the triangles that cross, rising.
  std::vector<int32_t> Crossed(const LocalPatch& patch);
  // The same, of crossings that not every patch has (AvoidableCrossings); surface that passes through the hole's
  // boundary counts, and patches made before are none of the input.
  std::vector<int32_t> CrossedAvoidably(const LocalPatch& patch);
  // Neither a fault nor a crossing.
  bool IsSound(const LocalPatch& patch) { return FaultOf(hole_, patch) == FillFailure::kNone && !Crosses(patch); }
  // The surface within reach, without what passes through the boundary. Valid until a patch is next tested.
  std::span<const SpaceTriangle> Surface();
  // Surface that passes through the boundary; empty until Surface(), Crossed() or CrossedAvoidably() is called or a
  // patch is found to cross any. Valid until a patch is next tested.
  std::span<const SpaceTriangle> ThroughRim() const { return through_rim_; }
  // All known surface of the input, and of patches made before.
  std::vector<SpaceTriangle> InputSurface() const;
  std::vector<SpaceTriangle> EarlierSurface() const;
  // Whether any surface was found to pass through the boundary.
  bool rim_is_crossed() const { return !through_rim_.empty(); }

 private:
  // The patch in space; it and all within reach.
  std::pair<std::vector<SpaceTriangle>, Eigen::AlignedBox3d> Place(const LocalPatch& patch) const;
  const std::vector<SpaceTriangle>& Surroundings(const Eigen::AlignedBox3d& box);
  void LeaveOutCrossed();
  void AddTaken(const LocalPatch& patch, std::vector<int32_t>& crossed) const;

  const LocalHole& hole_;
  const Eigen::AlignedBox3d reach_;
  const SurfaceNear near_;
  const EarlierPatches* const earlier_;
  Eigen::AlignedBox3d looked_at_;
  std::vector<SpaceTriangle> surroundings_;  // within looked_at_, without those that pass through the rim once known
  std::vector<SpaceTriangle> through_rim_;   // those
  size_t of_input_ = 0, of_input_through_rim_ = 0;  // how many of them are no patches made before; these come first
  bool knows_crossed_ = false;
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SPACE_PATCH_SOUNDNESS_H_
