// The holes of one cell, as they travel from the plan to the workers that sample and fill them.
#ifndef TILEMEND_COMMON_RECORDS_CELL_HOLES_H_
#define TILEMEND_COMMON_RECORDS_CELL_HOLES_H_

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/grid/scene.h"
#include "common/mesh/tri_mesh.h"
#include "common/records/water_surface.h"

namespace tilemend {

// A vertex on the boundary of a hole: an original vertex of some tile, or a seam vertex that the plan made. The tile is
// often the cell's own; it is a neighbour's if the hole closes on the neighbour's border.
struct RimVertex {
  CellId tile;               // whose vertex it is; meaningless for a seam vertex
  int32_t index = -1;        // in that tile; -1: a seam vertex
  int32_t seam_vertex = -1;  // the plan's number of the vertex, where its height is asked for or told; else -1
  uint8_t lines = 0;  // of a seam vertex: 1 if it lies on a line x = const, 2 if on y = const, 3 on a grid corner
  Point3 position{0, 0, 0};  // exact for originals; z of a seam vertex counts when height_known
  bool height_known = true;
  double centroid_height = 0;    // originals: see BoundaryVertex
  double size = 0;               // wanted edge length here, metres
  bool laplacian_known = false;  // on seams, from the surface of the whole cluster: its Laplacian here, 1 / metre
  double laplacian = 0;
  bool on_object = false;  // an original that stands on a tree, a house, a wall: its height does not shape the surface
  bool on_ground = false;  // an original of which the ground filter says that it stands on the ground
  // Of a seam vertex on a tile's own outline: the seam vertex on the grid line whose height it takes; else -1.
  int32_t follows = -1;
  std::optional<double> ground;  // where the surface of its cluster passes below or above it, metres
};

// A segment of a hole's boundary; seen from above, the hole lies to the left of from -> to.
struct RimSegment {
  int32_t from = 0;  // into CellHoles::vertices
  int32_t to = 0;
  bool seam = false;  // a stretch of grid boundary; else an original edge
};

// The ground around a hole.
struct GroundTrend {
  Point2 slope{0, 0};    // dz/dx, dz/dy
  double steepness = 0;  // rise / run of the ground beside that slope: what is steeper is a wall; 0: nothing is told

  bool is_told() const { return steepness > 0; }
  // Whether it may be that of triangles none of which is steeper than 5 in 1.
  bool is_possible() const {
    return std::abs(slope.x()) <= 5 && std::abs(slope.y()) <= 5 && steepness >= 0.01 && steepness <= 10;
  }
};

// A tension of the thin-plate surface and how well it foretold heights that were left out
// (worker/fill/surface/choose_tension.h).
struct HoldOut {
  double tension = 0;         // 1 / metre^2
  double error = 0;           // mean |error| with it, metres
  double error_at_start = 0;  // with the tension that the search begins with
  int32_t blocks = 0;         // stretches left out; 0: not tested, the errors mean nothing
  GroundTrend walls = {};     // where the surface is ground with walls instead (worker/fill/surface/walled_ground.h)
};

struct CellHole {
  int32_t id = 0;     // in the plan
  bool open = false;  // reaches the cell's grid boundary: filled as heights over the plane
  std::vector<RimSegment> segments = {};
  std::vector<RimSegment> inner_edges = {};  // edges that the patch has inside its boundary; in any direction
  Point2 slope{0, 0};                        // dz/dx, dz/dy of the ground that its cluster lies in
  std::optional<double> tension = {};        // that of its cluster, where it has been chosen
  GroundTrend walls = {};                    // likewise: HoldOut::walls
  std::optional<double> level = {};          // filled flat: the height of every new vertex, metres, on the lattice
  WaterSurface river = {};                   // with stations: water whose heights are LevelAt these; level is set too
  bool in_ground = false;                    // closed, and filled as an open one: its rim lies on the ground
  bool own_outline = false;                  // it ends at the tile's own outline: no other tile shares its seams
};

struct CellHoles {
  CellId cell;
  bool float32 = true;      // number type of the output tile
  double lattice_step = 0;  // power of two, metres: where new vertices lie
  bool upright = true;      // z is up; false: a mesh that may lie in any way, where no direction is preferred
  std::vector<RimVertex> vertices;
  std::vector<CellHole> holes;
  // The original triangles around the holes. band.points[0 .. vertices.size()) stand for the rim vertices.
  TriMesh band;
};

// How a hole was filled.
enum class FillWay : uint8_t {
  kNone,         // it was not
  kWater,        // flat, at the level of the water
  kGround,       // heights over the ground
  kOwnPlane,     // heights over the plane of its own boundary
  kFacingPlane,  // heights over a plane that the surface around it faces
  kCreases,      // in parts, along sharp edges
  kUnrolled,     // its boundary unrolled into a plane, bent in space
  kSpace,        // triangles of its boundary in space
  kFoldsCut,     // heights over a plane, with folds of its boundary cut off
  kBare,         // triangles of its boundary in space alone, where no new vertex could be laid
  // With the filler of that name (Filler), in its order.
  kAdvancingFrontNormal,
  kAdvancingFrontCurvature,
  kAdvancingFrontPoisson,
  kSvmLaplacian,
  kMinimumArea,
};

// New geometry for one hole. A corner k >= 0 is rim vertex k of the CellHoles; -1 - k is new_points[k].
struct HolePatch {
  int32_t hole = 0;
  std::string failure = {};  // not empty: the hole stays open, for this reason
  FillWay way = FillWay::kNone;
  std::vector<Point3> new_points = {};
  std::vector<Triangle> triangles = {};
  std::optional<HoldOut> hold_out = {};  // where the tension was chosen for this hole alone
  int32_t creases = 0;                   // of a published patch: edges at which it turns by more than 120 degrees
  int32_t loop_cuts = 0;                 // of `wang`: how often its boundary was cut to be triangulated (WangOptions)
  bool rim_is_crossed = false;           // the surface passes through the boundary, and so through any patch
  // Of patches over the ground that were tested for it: triangles that cross others of the patch, or surface that does
  // not pass through the boundary.
  int32_t crossings = 0;
};

// A new height of a new point of a cell's patches; their new points are numbered through from the first patch on.
struct SmoothedPoint {
  int32_t point = 0;
  double height = 0;  // metres
};

// The extent of a hole's boundary grown by half its diagonal: where a patch may go that is no height over the ground.
// Precondition: the hole has segments.
inline Eigen::AlignedBox3d ReachOf(const CellHoles& cell, const CellHole& hole) {
  Eigen::AlignedBox3d box;
  for (const RimSegment& s : hole.segments) box.extend(cell.vertices[s.from].position);
  const Point3 reach = Point3::Constant(box.diagonal().norm() / 2);
  return {box.min() - reach, box.max() + reach};
}

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RECORDS_CELL_HOLES_H_
