// The crossings of a patch while its triangles change.
#ifndef TILEMEND_WORKER_FILL_SPACE_LIVE_CROSSINGS_H_
#define TILEMEND_WORKER_FILL_SPACE_LIVE_CROSSINGS_H_

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "common/mesh/box_tree.h"
#include "common/mesh/position_index.h"
#include "common/mesh/tri_mesh.h"
#include "common/mesh/vertex_lists.h"
#include "worker/fill/space/crossing_curves.h"

namespace tilemend {

// Two triangles that cross avoidably (AvoidableCrossings), by their numbers in the patch; below 0: not of it.
struct PatchCrossing {
  CrossingPair pair;
  std::vector<Point3> points;  // where edges of the one pass through the other
};

// Finds what AvoidableCrossings finds. A change is tried at the cost of the curves that change (WeightWith), and made
// at that of all curves. Triangles of the patch are numbered as they come.
class LiveCrossings {
 public:
  //   surface  of the input
  //   earlier  of other patches
  // Those two may have triangles without area: they cross nothing. Precondition: triangles of the patch have area.
  LiveCrossings(std::span<const SpaceTriangle> surface, std::span<const SpaceTriangle> earlier,
                std::span<const SpaceTriangle> patch);

  // Of all avoidable crossings: the length of their curves in metres, and kPairWeight for each pair.
  double weight() const { return weight_; }
  // What the weight would be with `in` instead of the triangles `out`.
  double WeightWith(std::span<const int32_t> out, std::span<const SpaceTriangle> in);
  void Change(std::span<const int32_t> out, std::span<const SpaceTriangle> in);
  // Undoes the last change that is not undone: its `out`, and the number of its first triangle.
  void Undo(std::span<const int32_t> out, int32_t first);

  std::vector<PatchCrossing> Avoidable() const;

 private:
  // An edge of triangle `own` that passes through `other`.
  struct Pierced {
    int32_t own, other, from, to;
  };
  struct Crossing {
    CrossingPair pair;
    std::vector<Pierced> pierced;
    double weight = 0;
    int32_t curve = -1;
  };

  int32_t Insert(const SpaceTriangle& triangle);
  void AddToPatch(std::span<const SpaceTriangle> in);
  void RemoveFrom(int32_t t, size_t crossings);
  void FindCrossings(int32_t t);
  void AddCrossing(CrossingPair pair);
  void AddPierced(int32_t own, int32_t other, Crossing& crossing) const;
  Point3 PointOf(const Pierced& pierced) const;
  bool IsThere(const Crossing& c) const { return !is_gone_[c.pair.a] && !is_gone_[c.pair.b]; }
  bool IsOfPatch(const Crossing& c) const { return c.pair.b >= first_; }
  int32_t Find(CrossingPair pair) const;
  template <typename Use, typename GoesOn>
  void FollowCurve(const Crossing& crossing, const Use& use, const GoesOn& goes_on) const;
  template <typename Use>
  void ForEachAt(int32_t from, int32_t to, const Use& use) const;
  void FindCurves();
  double WeightOf(std::span<const int32_t> crossings, std::vector<int32_t>* curve_of = nullptr);

  PositionIndex index_;
  std::vector<SpaceTriangle> placed_;  // of the surface, of earlier patches, of the patch
  std::vector<Triangle> triangles_;    // the same, by positions
  std::vector<bool> is_gone_;
  int32_t of_surface_ = 0, first_ = 0;          // how many are of the surface; how many are not of the patch
  VertexLists corners_{0, [](const auto&) {}};  // of those that are not of the patch, by position
  int32_t fixed_positions_ = 0;                 // of those
  BoxTree fixed_tree_, tree_;
  int32_t planted_ = 0;                                         // triangles in trees
  std::unordered_map<uint64_t, std::vector<int32_t>> at_edge_;  // triangles of the patch
  std::vector<Crossing> crossings_;
  std::vector<std::vector<int32_t>> of_triangle_;  // crossings
  std::vector<std::vector<int32_t>> curves_;       // crossings
  std::vector<double> curve_weight_;               // 0: not avoidable
  double weight_ = 0;
  std::vector<int32_t> place_;  // of a crossing among those that WeightOf looks at
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SPACE_LIVE_CROSSINGS_H_
