// A patch while it is refined: by production in space, and by the surface of Wang 2021.
#ifndef TILEMEND_WORKER_FILL_SHAPE_NEW_PATCH_H_
#define TILEMEND_WORKER_FILL_SHAPE_NEW_PATCH_H_

#include <Eigen/Geometry>
#include <cstdint>
#include <utility>
#include <vector>

#include "common/mesh/tri_mesh.h"
#include "common/mesh/vertex_lists.h"

namespace tilemend {

// Points of the rim and of edges inside that are to stay, then the new ones. Where the hole projects, z is the height
// over the plane it projects on. Every triangle turns left there, so the patch covers no place twice.
struct NewPatch {
  std::vector<Point3> points;
  std::vector<double> sizes;  // wanted edge length at each point, metres
  int32_t rim_count = 0;
  std::vector<Triangle> triangles;
  std::vector<std::pair<int32_t, int32_t>> fixed_edges;  // inside; each with its lower end first, sorted
  bool projects = true;
  // Where the hole projects, refinement makes no triangle flatter on the plane than so many metres. A flatter one could
  // turn over where the output rounds.
  double least_height = 0;
  bool spreads = false;  // points that refinement adds in one round keep their sizes apart
  // Of points of the rim: StripsBeside. A triangle whose corners have one in common is left as it is. So two tiles have
  // the same triangles in the strip that both fill. Empty: no strips.
  std::vector<uint8_t> strips;

  bool LiesInStrip(const Triangle& t) const {
    const auto size = static_cast<int32_t>(strips.size());
    if (t[0] >= size || t[1] >= size || t[2] >= size) return false;
    return (strips[t[0]] & strips[t[1]] & strips[t[2]]) != 0;
  }

  int32_t size() const { return static_cast<int32_t>(points.size()); }
};

// The surface around a patch: points after those of the patch, and triangles over both. May be empty.
struct PatchSurroundings {
  std::vector<Point3> points;
  std::vector<Triangle> triangles;
  std::vector<bool> has_equation;  // of the rim: patch and surroundings surround the point
};

// Moves new points of a patch whose triangles stay, within the extent of the rim grown by half its diagonal. At walls
// beside the rim the fairing may throw points far off. Holds lists of the triangles around each: O(triangles).
class PointMover {
 public:
  // The patch must outlive it.
  explicit PointMover(NewPatch& patch);

  // Moves a new point, as far as the reach goes. Where the hole projects, no triangle may turn over on the plane or get
  // closer to that than it was. If one would, the point moves by half the way, a quarter, and last only in height.
  // O(degree).
  void Move(int32_t v, const Point3& to);
  // Whether all triangles at a point turn left on the plane; exact.
  bool TurnsLeftAround(int32_t v) const;

 private:
  double LeastHeightAround(int32_t v) const;

  NewPatch& patch_;
  const VertexLists corners_;
  Eigen::AlignedBox3d reach_;
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_SHAPE_NEW_PATCH_H_
