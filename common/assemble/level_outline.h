// The outlines of what one level of detail lacks of the surface that its finest level has.
#ifndef TILEMEND_COMMON_ASSEMBLE_LEVEL_OUTLINE_H_
#define TILEMEND_COMMON_ASSEMBLE_LEVEL_OUTLINE_H_

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "common/assemble/finest_patch.h"
#include "common/assemble/level_region.h"
#include "common/assemble/plan_view.h"
#include "common/codec/mesh_file.h"
#include "common/mesh/tri_mesh.h"

namespace tilemend {

// The arguments are those of FillLevel and must outlive it. It keeps its region, to which points may be added.
class LevelOutline {
 public:
  LevelOutline(const TriMesh& level, const TriMesh& finest, const FilePatch& patch, const TriMesh& cleared);
  LevelOutline(const LevelOutline&) = delete;

  // The boundary of what is to be filled, without those of its own corners that lie closer than the level's edges are
  // long. In one piece; if that bounds no region, hole by hole, so that one hole does not take others with it. Once.
  std::vector<RegionBoundary> Boundaries();
  // The middle of each hole whose outline bounds no region even so.
  const std::vector<Point2>& open() const { return open_; }

  LevelRegion& region() { return region_; }
  const FinestPatch& finest_patch() const { return finest_patch_; }
  const PlanView& on_patch() const { return on_patch_; }
  const PlanView& on_cleared() const { return on_cleared_; }
  // The edges of the level beside the patch are this long, metres.
  double edge() const { return edge_; }
  // The boundary of the patch seen from above.
  const RegionBoundary& footprint() const { return footprint_; }
  // Vertices of the patch, those of its rim among them.
  const std::vector<Point3>& places_of_patch() const { return patch_outline_.positions; }
  // The vertex of the level at a point of the region; -1 for other points.
  int32_t LevelVertexAt(int32_t v) const;
  // The vertex at a point of the region, of the patch, of what was cleared, or of the finest level where it was
  // cleared; null for other points.
  const Point3* PlaceOf(int32_t v) const;

 private:
  bool HasCleared() const { return !cleared_.triangles.empty(); }
  // Vertices that the level has, or had before it was cleared.
  bool IsOfLevel(int32_t v) const { return v < patch_first_; }
  bool IsBetween(int32_t a, int32_t b, int32_t v) const;
  bool IsBoundary(const RegionBoundary& segments) const;
  LatticeWindow Window() const;
  double EdgeBeside(const TriMesh& level) const;
  std::vector<Triangle> TrianglesNear(const TriMesh& mesh, double reach) const;
  std::vector<Triangle> TrianglesNear(const TriMesh& mesh) const;
  SurfaceOutline OutlineNear(const TriMesh& mesh) const;
  int32_t AddPlaced(const SurfaceOutline& outline);
  std::vector<RegionLoop> Loops();
  RegionLoop AlongLevel(RegionLoop loop) const;
  RegionLoop Thinned(const RegionLoop& loop, VertexThinning& thinning) const;
  std::optional<RegionBoundary> BoundaryOf(const std::vector<RegionLoop>& whole,
                                           const std::vector<RegionLoop>& thinned);
  void LeaveOpen(const RegionLoop& outline);

  const FilePatch& patch_;
  const TriMesh& cleared_;
  const FinestPatch finest_patch_;
  const PlanView on_patch_, on_cleared_;
  const double edge_;
  const SurfaceOutline level_outline_, cleared_outline_, patch_outline_, seen_outline_, finest_outline_;
  LevelRegion region_;
  RegionBoundary footprint_;
  std::vector<std::pair<int32_t, const SurfaceOutline*>> placed_;  // by the numbers of their first points
  int32_t patch_first_ = 0;                                        // number of a point of the region
  std::vector<Point2> open_;
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_ASSEMBLE_LEVEL_OUTLINE_H_
