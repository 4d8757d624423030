// Regions between the outlines of surfaces, seen from above: what one level of detail lacks.
#ifndef TILEMEND_COMMON_ASSEMBLE_LEVEL_REGION_H_
#define TILEMEND_COMMON_ASSEMBLE_LEVEL_REGION_H_

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "common/mesh/edge_loops.h"
#include "common/mesh/lattice.h"
#include "common/mesh/tri_mesh.h"
#include "common/mesh/triangulation/region_triangulation.h"

namespace tilemend {

// The boundary edges of a surface on welded positions: the surface is on their left, seen from above.
struct SurfaceOutline {
  std::vector<Point3> positions;  // of all vertices of the triangles
  std::vector<int32_t> vertex;    // the first vertex at each position
  std::vector<DirectedEdge> edges;
};

// An edge belongs to it as often as triangles pass it in one direction more than in the other. O(n).
SurfaceOutline SurfaceOutlineOf(std::span<const Triangle> triangles, const std::function<Point3(int32_t)>& point_of);

using RegionLoop = std::vector<int32_t>;           // points of a region, each once
using RegionBoundary = std::vector<DirectedEdge>;  // between points of a region, which is on its left

// The sides of loops.
RegionBoundary SegmentsOf(const std::vector<RegionLoop>& loops);

// Each triangle counter-clockwise, seen from above, without those that stand upright. What their outline winds around
// is all that they cover, even where they overlap.
std::vector<Triangle> FacingUp(const TriMesh& mesh, std::vector<Triangle> triangles);

// Makes regions of the plane, given by directed segments with the region on their left, from others. All segments are
// between points of one lattice; each step adds the corners that it makes. Cost of each as of FindWoundRegion.
class LevelRegion {
 public:
  explicit LevelRegion(const LatticeWindow& window) : window_(window) {}

  // Adds a point, or all positions of an outline; the number of the first.
  int32_t Add(const Point2& p);
  int32_t AddAll(const SurfaceOutline& outline);
  const std::vector<LatticePoint>& points() const { return points_; }
  Point2 At(int32_t v) const { return window_.ToMetres(points_[v]); }

  // What the edges wind around, as a simple boundary: such boundaries are what the steps below take.
  std::vector<DirectedEdge> Simple(const std::vector<DirectedEdge>& edges);
  std::vector<DirectedEdge> Both(std::vector<DirectedEdge> a, const std::vector<DirectedEdge>& b);
  std::vector<DirectedEdge> Either(std::vector<DirectedEdge> a, const std::vector<DirectedEdge>& b);
  std::vector<DirectedEdge> Without(std::vector<DirectedEdge> a, const std::vector<DirectedEdge>& b);
  // The region and all within a square of 2 * `reach` metres about a point of its boundary.
  std::vector<DirectedEdge> Grown(const std::vector<DirectedEdge>& edges, double reach);
  // Simple loops that do not cross, by the holes that they bound: the numbers of one counter-clockwise loop and of the
  // clockwise ones in it, without those in a smaller such loop. A clockwise loop that lies in no other is left out.
  // O(loops * points).
  std::vector<std::vector<int32_t>> HolesOf(const std::vector<RegionLoop>& loops) const;
  // The region between segments. Of the points that no segment uses only those of `free` are inserted. Conflicts are
  // possible where points of a boundary were left out.
  RegionTriangulation Triangulated(const RegionBoundary& segments, const std::vector<int32_t>& free) const;
  // The same segments between the first points at their places.
  std::vector<DirectedEdge> AtFirstPoints(std::vector<DirectedEdge> edges) const;

 private:
  bool IsCounterClockwise(const RegionLoop& loop) const;
  bool HasInside(const RegionLoop& loop, const RegionLoop& other) const;
  void AddHull(LatticePoint a, LatticePoint b, int64_t reach, std::vector<DirectedEdge>& edges);
  std::vector<DirectedEdge> Everything();

  const LatticeWindow window_;
  std::vector<LatticePoint> points_;
};

// The edges of an outline whose positions are points from `first` on.
std::vector<DirectedEdge> EdgesFrom(const SurfaceOutline& outline, int32_t first);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_ASSEMBLE_LEVEL_REGION_H_
