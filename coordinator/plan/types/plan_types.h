// What a plan is made from and what it says.
#ifndef TILEMEND_COORDINATOR_PLAN_TYPES_PLAN_TYPES_H_
#define TILEMEND_COORDINATOR_PLAN_TYPES_PLAN_TYPES_H_

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "common/grid/scene.h"
#include "common/grid/water_areas.h"
#include "common/grid/water_profile.h"
#include "common/records/cell_holes.h"
#include "common/records/fill_colour.h"
#include "common/records/rim_ground.h"
#include "common/records/stored_record.h"
#include "common/records/surface.h"
#include "common/records/water_surface.h"

namespace tilemend {

// What is taken for water (water.h).
struct WaterOptions {
  bool find = true;                          // else only where an area says so
  WaterProfile profile = kWaterProfiles[0];  // what `find` finds
  std::vector<WaterArea> areas;              // the last one that covers more than half of a hole decides on it
};

// Which loops of a single mesh are filled.
struct MeshHoleOptions {
  bool fill_outlines = false;             // outlines of pieces as well
  std::optional<int64_t> largest_hole{};  // edges: longer loops stay open
  // Holes no wider are dislocations, in the mesh's own units (Zhang 2022, 4.1 (2)); none: in lengths of their edges.
  std::optional<double> dislocation_width{};
};

struct PlanOptions {
  // Seam vertices grow apart from the rim inward by this factor per edge (>= 1), up to size_limit times the rim's mean
  // edge.
  double gradation = 1.3;
  double size_limit = 16.0;
  bool uniform = false;
  WaterOptions water;
  MeshHoleOptions mesh;
  std::optional<Rgb> water_colour = {};          // of the faces; none: as the rim has it
  SeamPoints seam_points = SeamPoints::kSpaced;  // of seams between cells of the area
  // Asked at borders, seam vertices, cells, areas of water, and segments that a triangulation takes in. It is not asked
  // while the rim is gathered and its boundaries are sorted. Once true the plan ends soon and is empty. None: never.
  std::function<bool()> is_cancelled = {};
  bool cancelled() const { return is_cancelled && is_cancelled(); }
};

struct PlanInput {
  Grid grid;
  bool area_known = true;                // else the rim of the area stays open
  bool has_grid = true;                  // false: one mesh, each loop a closed hole or an outer rim
  std::map<CellId, StoredRecord> cells;  // the area; null: no surface
  PlanePolygon area = {};                // what of the cells is to be covered; empty: all (Scene::area)
  std::set<CellId> added = {};           // cells that only an area made part of the scene (SceneTile::added)
  // Of the boundary vertices of a cell's record; those of cells that are not there stand on the ground.
  std::map<CellId, RimGround> rim_ground = {};
};

// How the tiles of two neighbouring cells meet (docs/architecture.md, "Two kinds of cut").
enum class BorderKind { kExact, kNear, kOverlap, kGap, kOpen };  // kOpen: one or both have no surface there

// How far apart two surfaces are, metres.
struct SurfaceGap {
  double median = 0, ninth_decile = 0, percentile_99 = 0;
  int64_t places = 0;  // where they were compared; 0: nothing is known
};

struct BorderAudit {
  CellId a, b;  // b is east or north of a
  BorderKind kind = BorderKind::kOpen;
  int64_t shared_vertices = 0;
  double offset = 0;                   // metres: > 0 overlap, < 0 gap
  std::array<double, 2> margins = {};  // of a and b: how far each one's own outline lies beyond the grid line
  SurfaceGap apart = {};               // kOverlap: the originals
};

enum class HoleKind { kClosed, kOpenI, kOpenII };
enum class HoleType { kNone, kA, kB, kC, kD };                                      // open holes: Wang 3.1, figure 5
enum class SingleType { kNone, kCrack, kDislocation, kAnnular, kIsland, kSimple };  // Zhang 2022, 4.1

enum class Standing : uint8_t {
  kElse,
  kInGround,  // the rim has a vertex on the ground (mark_objects.h)
  kHanging,   // in a piece of surface that hangs over other holes (hole/free_pieces.h)
};

struct PlannedHole {
  CellId cell;
  HoleKind kind = HoleKind::kClosed;
  HoleType type = HoleType::kNone;
  SingleType single = SingleType::kNone;
  bool continuous = false;              // of a single mesh: touches another hole, or itself, at a vertex
  bool projects = true;                 // its boundary is simple seen from above
  Standing standing = Standing::kElse;  // closed holes
  int32_t cluster = -1;                 // open holes
  int32_t layer = 0;                    // open holes: from 1
  double area = 0;       // m2, seen from above (closed holes that do not project: of the boundary's vector area)
  double perimeter = 0;  // metres of original boundary
  int32_t boundary_vertices = 0;
  Point2 centre{0, 0};
  Point2 slope{0, 0};                // of the ground that its cluster lies in (rim_slopes.h)
  int32_t water = -1;                // into Plan::water; -1: not filled flat
  int32_t evidence = -1;             // into Plan::evidence; -1: too small to be judged
  std::string failure;               // not empty: it can't be filled, for this reason
  std::vector<RimSegment> segments;  // into Plan::vertices
  // Where tiles end at outlines of their own: what bounds the parts that are filled, each up to such an outline. None:
  // `segments` does.
  std::vector<std::vector<RimSegment>> own_regions;
  std::vector<RimSegment> inner_edges = {};  // of what is filled, between new vertices inside it (strip_edges.h)
};

// Whether the area of a hole is known. It is not of open holes that were given up before their region was found.
inline bool IsAreaKnown(const PlannedHole& hole) { return hole.kind == HoleKind::kClosed || hole.area > 0; }

// A vertex of a hole boundary: a vertex of one or more tiles, or a new one on a seam.
struct PlanVertex {
  CellId tile;
  int32_t index = -1;  // -1: a seam vertex
  Point3 position{0, 0, 0};
  double centroid_height = 0;
  double size = 0;
  uint8_t lines = 0;  // as RimVertex::lines
  // Of a seam vertex: its height is that of a rim vertex a hair beside it, or of the water on one side alone.
  bool height_given = false;
  bool height_known = false;  // of a new vertex that is on no seam
  // Of a vertex on a tile's own outline: the vertex on the grid line beside it. It takes the cluster's surface from
  // there; an original one only its Laplacian.
  int32_t follows = -1;
  // Of such a new vertex: the neighbour has surface there. Where that is an object, a wall goes up to it.
  bool on_neighbour = false;
  bool on_ground = false;  // of an original vertex: the ground filter says so
  // Of an original vertex: the fill passes below it, as it stands on a tree, a house, a wall; or above it, as it is
  // street on the rim of a roof (mark_objects.h).
  bool on_object = false;
  std::optional<float> ground = {};  // of such a vertex: the height of the fill there, metres, where it is known
};

// A stretch of grid line through a hole, from one junction or grid corner to the next, in order of the coordinate along
// the line.
struct Seam {
  CellId a, b;                    // b is east or north of a; one of them may lie outside the area
  std::vector<int32_t> vertices;  // into Plan::vertices
};

enum class BodyKind { kWater, kLevelGround };

// What is filled flat: a cluster of open holes, a closed hole, or several that hold one water. Or a river, over one or
// more of them.
struct WaterBody {
  BodyKind kind = BodyKind::kWater;  // kLevelGround: nothing says that it is water; never a river
  std::vector<int32_t> holes;        // into Plan::holes, ascending
  double level = 0;                  // metres, on the lattice; of a river at its lower end
  WaterSurface river;                // no stations: level water
  std::vector<RemovedRise> removed_rises;
  double sigma = 0;                // metres: standard deviation of the level (LevelEvidence::sigma)
  double lowest = 0, highest = 0;  // of the rim's heights
  int64_t rim_vertices = 0;
  bool forced = false;          // an area says that it is water
  bool level_is_given = false;  // as `level_m` of that area
  double shore_level = 0;       // that the shore has, whatever was given; not of a river
  std::string reason = {};      // as HoleEvidence::reason
};

// Metres: a given level farther from the shore's own may be a mistake.
inline constexpr double kLevelOff = 1;

inline double LevelAt(const WaterBody& body, const Point2& p, double lattice_step) {
  return body.river.stations.empty() ? body.level : LevelAt(body.river, p, lattice_step);
}

// What a hole or cluster of at least 100 m2, or beside water, was taken for, and why (water.h).
struct HoleEvidence {
  enum class Verdict { kLake, kRiver, kLevelGround, kNoWater };
  Verdict verdict = Verdict::kNoWater;
  bool has_level = false;             // of its rim
  double level = 0;                   // metres: of the water; else that its rim tells
  std::optional<double> sigma = 0.0;  // metres: standard deviation of `level`; none: the user gave the level
  std::string reason;                 // what the verdict follows from, in words
  bool is_of_whole_scene = false;     // its level is told by the scene without the area (known_water.h)
  int32_t area = -1;                  // into Plan::water_answers: that of the user's area that decides on it
  double dry_difference = 0;          // metres: how far a dry surface is from level water there (LevelEvidence)
  double chance_wrong = 0;            // of the verdict, 0 to 0.5 (verdict_chance.h); 0: nothing was tested
};

// What became of an area of the user's (water_answers.h).
struct WaterAnswer {
  std::string label;                                // of the area
  bool water = true;                                // what the area says
  bool taken = false;                               // some hole is filled as it says
  std::vector<int32_t> holes;                       // those, into Plan::holes
  std::string reason;                               // not taken, or not for the hole of which it covers most: why
  std::string doubt = {};                           // not empty: taken, but likely wrong
  std::optional<double> clear_height = {};          // of an area with `clear`
  ReviewDecision decision = ReviewDecision::kNone;  // of the area
  bool is_over_hole = true;                         // it covers some of a hole
  bool has_cleared = false;                         // surface was taken out under it
};

struct LeftOpen {
  CellId cell;
  std::string reason;
  int32_t hole = -1;                        // -1: found before there was a hole
  int64_t edges = 0;                        // boundary edges that stay open
  bool is_hole = true;                      // false: open by right, such as the outline of a piece
  std::optional<Point3> at = std::nullopt;  // one end of the first of the edges, where there is no hole
};

// Tiles whose heights lie further apart than on Earth.
struct ImpossibleHeights {
  int64_t tiles = 0;
  CellId first;                    // of them
  double lowest = 0, highest = 0;  // of that
};

// Of a plan, for the report alone.
struct PlanRemarks {
  bool has_polygon = false;  // PlanInput::area is not empty
  double turn = 0;           // radians: the tiles' outlines against the grid (rim/outline_turn.h)
  double piece_reach = 0;    // metres: a scene of one tile whose pieces overlap by less than this; 0: it is one piece
  double tiny_cell = 0;      // the shorter side of cells that are too small for metres; 0: they are not
  ImpossibleHeights impossible_heights;
};

struct Plan {
  std::vector<PlanVertex> vertices;
  std::vector<PlannedHole> holes;   // by cell, then in order of their first segment
  std::vector<FillColour> colours;  // of the holes
  std::vector<Seam> seams;
  std::vector<WaterBody> water;            // in order of their first hole
  std::vector<HoleEvidence> evidence;      // in order of the first holes that it is about
  std::vector<WaterAnswer> water_answers;  // one for each of WaterOptions::areas
  std::map<int32_t, int32_t> decisions;    // holes that a reviewer decided on: into water_answers
  std::vector<BorderAudit> borders;        // in order of a; of one a that to the east first
  std::vector<LeftOpen> left;
  int32_t clusters = 0;
  int32_t layers = 0;
  int32_t continuous = 0;    // groups of holes that touch at a vertex (Zhang: continuous holes), split into single ones
  int64_t outer_rims = 0;    // loops that are the outline of a detached piece, not a hole
  double lattice_step = 0;   // power of two, metres
  bool single_mesh = false;  // without a grid: the lattice suits its edges, in units of its own
  bool upright = true;       // as CellHoles
  bool float32 = true;       // the number type of cells without a tile: false if every tile has float64
  PlanRemarks remarks;
  // Per tile: the plan vertex of each boundary vertex of its record; -1: it bounds no hole. Tiles of which none does
  // are not there.
  std::map<CellId, std::vector<int32_t>> vertex_of_boundary;
};

// Plan::vertex_of_boundary of a tile; empty if it is not there.
inline std::span<const int32_t> VerticesOf(const Plan& plan, CellId tile) {
  const auto found = plan.vertex_of_boundary.find(tile);
  return found == plan.vertex_of_boundary.end() ? std::span<const int32_t>() : found->second;
}

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_TYPES_PLAN_TYPES_H_
