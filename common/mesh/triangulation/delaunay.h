// The mesh that triangulation and refinement share: a constrained Delaunay triangulation in flat arrays.
//
// A half-edge is 4 * triangle + k: the edge opposite to corner k, from corner k+1 to corner k+2 (mod 3). Triangles are
// counter-clockwise. Ghost triangles, which have the corner kGhost, cover the plane outside the hull, while there is
// one. A region cut out of it has walls instead.
#ifndef TILEMEND_COMMON_MESH_TRIANGULATION_DELAUNAY_H_
#define TILEMEND_COMMON_MESH_TRIANGULATION_DELAUNAY_H_

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "common/mesh/predicates.h"
#include "common/mesh/triangulation/region_triangulation.h"

namespace tilemend::internal {

inline constexpr int32_t kGhost = -1;

// Stops the program for a caller's mistake (the CHECK of this library, which has no logging).
void Require(bool condition, const char* what);

constexpr int Next(int k) { return k == 2 ? 0 : k + 1; }
constexpr int Previous(int k) { return k == 0 ? 2 : k - 1; }

struct MeshTriangle {
  std::array<int32_t, 3> corner;
  uint32_t flags = 0;  // bit k: edge k is constrained (while building); free for the owner afterwards
  // The half-edge across edge k, or ~s at a wall: nothing across, and the edge is segment s.
  std::array<int32_t, 3> twin;
  int32_t tag = 0;  // the component, once regions are cut out

  bool IsGhost() const { return (corner[0] | corner[1] | corner[2]) < 0; }
};
static_assert(sizeof(MeshTriangle) == 32);

// Where a point lies.
struct Location {
  enum class Kind { kInside, kOnEdge, kOnVertex, kBlocked };
  Kind kind;
  int32_t
      triangle;  // kInside: may be a ghost (the point sees its edge); kBlocked: where a wall or the step limit stopped
  int32_t k;     // kOnEdge: the edge; kOnVertex: the corner
};

class DelaunayMesh {
 public:
  std::vector<Point32> points;
  std::vector<MeshTriangle> triangles;

  int32_t Origin(int32_t half_edge) const { return triangles[half_edge >> 2].corner[Next(half_edge & 3)]; }
  int32_t Target(int32_t half_edge) const { return triangles[half_edge >> 2].corner[Previous(half_edge & 3)]; }
  int32_t Apex(int32_t half_edge) const { return triangles[half_edge >> 2].corner[half_edge & 3]; }
  int32_t Twin(int32_t half_edge) const { return triangles[half_edge >> 2].twin[half_edge & 3]; }
  bool IsConstrained(int32_t half_edge) const { return (triangles[half_edge >> 2].flags >> (half_edge & 3)) & 1; }

  // Makes a and b each other's twins. b may be a wall.
  void Link(int32_t a, int32_t b) {
    triangles[a >> 2].twin[a & 3] = b;
    if (b >= 0) triangles[b >> 2].twin[b & 3] = a;
  }

  // The first triangle and its three ghosts; a, b, c turn left.
  void Start(int32_t a, int32_t b, int32_t c);

  // Walks from `start` towards p. Ends at the first wall in the way, or after `step_limit` steps: a walk in a
  // constrained Delaunay triangulation could go round in circles. Precondition: start is no ghost.
  Location Locate(Point32 p, int32_t start, int64_t step_limit = INT64_MAX);

  // Finds the triangles whose circle p lies in and that p sees: those that inserting p replaces. The mesh stays as is.
  // Precondition: where = Locate(p) is kInside, or kOnEdge of an edge that is no wall.
  void FindCavity(Point32 p, const Location& where);

  // The half-edges, seen from inside the cavity, that bound the last found cavity, counter-clockwise.
  std::span<const int32_t> cavity_rim() const { return rim_; }
  std::span<const int32_t> cavity_triangles() const { return cavity_; }

  // Replaces the last found cavity by the star of `vertex`; flags of the new triangles are 0, the tag is kept. Returns
  // the new triangles; corner 2 of each is `vertex`.
  std::span<const int32_t> FillCavity(int32_t vertex);

  // Turns the edge between two triangles; constraint bits move along. Precondition: not a wall, the quadrilateral is
  // strictly convex.
  void Flip(int32_t half_edge);

  // True if the edge is no wall, not between ghosts, and the far corner lies inside the near triangle's circle.
  bool IsIllegal(int32_t half_edge) const;

 private:
  bool InConflict(const MeshTriangle& t, Point32 p) const;

  struct RimEdge {
    int32_t from;
    int32_t to;
    int32_t outer;
  };

  uint32_t random_ = 1;  // breaks ties in Locate; a fixed start keeps it deterministic
  std::vector<int32_t> cavity_;
  std::vector<int32_t> rim_;
  std::vector<int32_t> stack_;
  std::vector<int32_t> star_;
  std::vector<RimEdge> rim_edges_;
};

// The regions that segments bound, as a mesh with walls and without ghosts. On conflicts the mesh has no triangles.
struct RegionMesh {
  DelaunayMesh mesh;
  int32_t component_count = 0;
  std::vector<RegionConflict> conflicts;
};

RegionMesh BuildRegionMesh(std::span<const LatticePoint> points, std::span<const RegionSegment> segments,
                           const std::function<bool()>& is_cancelled = {});
RegionTriangulation ExportRegion(const RegionMesh& region, size_t segment_count);

}  // namespace tilemend::internal

#endif  // TILEMEND_COMMON_MESH_TRIANGULATION_DELAUNAY_H_
