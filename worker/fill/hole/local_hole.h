// A hole, or a part of one, with its boundary vertices numbered from 0: what every way of filling it works on.
#ifndef TILEMEND_WORKER_FILL_HOLE_LOCAL_HOLE_H_
#define TILEMEND_WORKER_FILL_HOLE_LOCAL_HOLE_H_

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "common/mesh/triangulation/region_triangulation.h"
#include "common/records/cell_holes.h"
#include "worker/fill/hole/cell_band.h"
#include "worker/fill/hole/rim_loops.h"

namespace tilemend {

// An edge without direction: the lower number first.
using VertexPair = std::pair<int32_t, int32_t>;
inline VertexPair Undirected(int32_t a, int32_t b) { return {std::min(a, b), std::max(a, b)}; }

// The cell and its band must outlive it.
struct LocalHole {
  const CellHoles* cell = nullptr;
  const CellBand* band = nullptr;
  bool open = false;
  Point2 slope{0, 0};                    // as in CellHole
  std::optional<double> tension, level;  // likewise
  GroundTrend walls;                     // likewise
  WaterSurface river;                    // likewise
  bool in_ground = false;                // likewise, and the hole faces up
  bool own_outline = false;              // likewise

  // One for each vertex.
  std::vector<int32_t> vertices;  // in CellHoles::vertices; -1: a new point on a crease
  std::vector<Point3> positions;
  std::vector<double> sizes;             // wanted edge lengths, metres
  std::vector<bool> has_equation;        // whether the patch goes on with the slope of the surface there
  std::vector<Eigen::Vector3d> normals;  // unit, of the surface that goes on into the hole, evened out; zero where none

  std::vector<bool> on_object;                // RimVertex::on_object; empty: none is
  std::vector<std::optional<double>> ground;  // RimVertex::ground; empty: none has

  std::vector<RegionSegment> segments;  // the hole on the left
  std::vector<VertexPair> boundary;     // the same, sorted, as edges
  // Of the boundary with own_outline: edges that neither the surface nor another hole of the cell has; sorted.
  std::vector<VertexPair> free_edges;
  std::vector<RimLoop> loops;  // the outer one first; none if the segments do not form loops

  std::vector<RegionSegment> inner_edges;  // CellHole::inner_edges, each in both directions

  int32_t size() const { return static_cast<int32_t>(vertices.size()); }

  // Whether a new edge may join two vertices: the surface or the boundary may have it already.
  bool MayJoin(int32_t a, int32_t b) const;
  // How many triangles the surface has at the edge between two vertices.
  int TrianglesBeside(int32_t a, int32_t b) const;
  // Unit normal of the original triangle at a segment; zero if there is none.
  Eigen::Vector3d NormalBeside(int32_t from, int32_t to) const;
  Eigen::Vector3d VectorArea() const;
  // Of the water that the hole is filled as, metres, on the lattice; nullopt if it is filled as none.
  std::optional<double> WaterLevelAt(const Point2& p) const;
  // The place on the lattice, near p, that the output can hold.
  Point3 Storable(const Point3& p) const;
};

// Numbers the vertices of segments in order of appearance, then those of inner edges. Without loops and normals;
// vertices at seams and inside have no equation.
LocalHole NumberVertices(const CellHoles& cell, const CellBand& band, std::span<const RimSegment> segments,
                         std::span<const RimSegment> inner_edges = {});

// The hole; a closed one with its loops and normals (an open one is filled over the plane, which takes neither).
// O(n log n).
LocalHole MakeLocalHole(const CellHoles& cell, const CellBand& band, const CellHole& hole);

// A vertex on the boundary of a part of a hole.
struct PartCorner {
  int32_t vertex = 0;                                // of the hole; size() + k: new point k of its patch, on a crease
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // as LocalHole::normals; zero on a crease
  bool ends_crease = false;
};

// A region of a hole that its boundary and creases bound: loops with the region on the left, the outer one first.
using PartBoundary = std::vector<std::vector<PartCorner>>;

struct HolePart {
  LocalHole hole;
  std::vector<int32_t> vertices;  // each one's number in the hole that it is a part of, as PartCorner::vertex
};

// Numbers the vertices of a part. None has an equation on creases, at their ends, and at folds.
HolePart MakePart(const LocalHole& hole, std::span<const Point3> new_points, const PartBoundary& boundary);

// Takes away the equation of vertices beside band triangles that face away from the surface that goes on into the hole.
// The patch may bend there.
void FreeAtFolds(LocalHole& hole);

// A triangle that faces further off than this belongs to another part of the surface: the slope does not go on there.
inline constexpr double kSamePartCosine = 0.5;

struct BandTriangles {
  std::vector<Triangle> triangles;  // corners: vertices of the hole, else `first` + k for others[k]
  std::vector<int32_t> others;      // in CellHoles::band.points
};

// The band triangles at the vertices that are chosen, in the order of the band.
BandTriangles BandAt(const LocalHole& hole, const std::vector<bool>& chosen, int32_t first);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_HOLE_LOCAL_HOLE_H_
