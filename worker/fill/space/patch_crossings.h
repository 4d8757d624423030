// Whether a patch passes through itself or through the surface around it.
#ifndef TILEMEND_WORKER_FILL_SPACE_PATCH_CROSSINGS_H_
#define TILEMEND_WORKER_FILL_SPACE_PATCH_CROSSINGS_H_

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

Eigen::AlignedBox3d BoxOf(const SpaceTriangle& triangle);

// Whether the corners lie on no line; exact.
bool HasArea(const SpaceTriangle& triangle);

// Whether segment pq has a point in common with a triangle. Exact; false for a triangle without area.
bool SegmentCrosses(const Point3& p, const Point3& q, const SpaceTriangle& t);

// Whether two triangles have a point in common besides their common corners and edge, or are one. Also whether they are
// folded onto each other at their edge (closer than the angle with sine 0.02). Corners at equal positions are one
// vertex. Exact, but for the folds. Precondition: they have area.
bool TrianglesCross(const SpaceTriangle& a, const SpaceTriangle& b);

// Whether two triangles of the patch cross, or one of the patch and one of the surface (TrianglesCross). Surface
// triangles without area are passed over. Precondition: patch triangles have area. O(n log n) where few extents
// overlap.
bool PatchCrosses(std::span<const SpaceTriangle> patch, std::span<const SpaceTriangle> surface);

// The numbers of the patch triangles that cross one of the surface or of the patch, rising. Precondition and cost as
// above.
std::vector<int32_t> CrossedTriangles(std::span<const SpaceTriangle> patch, std::span<const SpaceTriangle> surface);

// The pairs of a triangle of the patch and one of the surface that cross, in order. Precondition and cost as above.
std::vector<std::pair<int32_t, int32_t>> SurfaceCrossings(std::span<const SpaceTriangle> patch,
                                                          std::span<const SpaceTriangle> surface);

// The pairs of triangles of the patch that cross, the lower number first, in order. Precondition and cost as above.
std::vector<std::pair<int32_t, int32_t>> SelfCrossings(std::span<const SpaceTriangle> patch);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SPACE_PATCH_CROSSINGS_H_
