#include "coordinator/plan/plan.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "coordinator/plan/division.h"
#include "coordinator/plan/doubtful_numbers.h"
#include "coordinator/plan/drop_vertices.h"
#include "coordinator/plan/hole/free_pieces.h"
#include "coordinator/plan/hole/layers.h"
#include "coordinator/plan/hole/rim_slopes.h"
#include "coordinator/plan/hole/touching_holes.h"
#include "coordinator/plan/mesh/plan_mesh.h"
#include "coordinator/plan/overlap/area_outside.h"
#include "coordinator/plan/overlap/joint_ground.h"
#include "coordinator/plan/overlap/joint_tiles.h"
#include "coordinator/plan/overlap/own_regions.h"
#include "coordinator/plan/overlap/reached_holes.h"
#include "coordinator/plan/overlap/strip_edges.h"
#include "coordinator/plan/overlap/wall_feet.h"
#include "coordinator/plan/rim/area_proposal.h"
#include "coordinator/plan/rim/border_audit.h"
#include "coordinator/plan/rim/closing_cells.h"
#include "coordinator/plan/rim/grid_lines.h"
#include "coordinator/plan/rim/outline_turn.h"
#include "coordinator/plan/rim/piece_layout.h"
#include "coordinator/plan/rim/rim.h"
#include "coordinator/plan/rim/rim_index.h"
#include "coordinator/plan/rim/rim_sizes.h"
#include "coordinator/plan/seam/area_edge.h"
#include "coordinator/plan/water/clear_shores.h"
#include "coordinator/plan/water/decided_holes.h"
#include "coordinator/plan/water/hole_groups.h"
#include "coordinator/plan/water/known_water.h"
#include "coordinator/plan/water/mark_objects.h"
#include "coordinator/plan/water/water.h"
#include "coordinator/plan/water/water_answers.h"

namespace tilemend {
namespace {

constexpr double kFinestStep = 0x1p-10;  // metres
constexpr uint8_t kFixedVertex = 3;      // as RimVertex::lines: like a grid corner

// The finest power-of-two step, at least 2^-10 m, whose multiples the tiles' number type holds exactly out to the
// farthest coordinate.
double LatticeStep(const PlanInput& input) {
  double farthest = 1;
  bool float32 = false;
  for (const auto& [cell, record] : input.cells) {
    if (record == nullptr || record->vertex_count == 0) continue;
    float32 |= record->float32;
    farthest = std::max({farthest, record->lo.cwiseAbs().maxCoeff(), record->hi.cwiseAbs().maxCoeff()});
  }
  const int digits = float32 ? 24 : 53;
  const double representable = std::ldexp(1.0, std::ilogb(farthest) + 1 - digits);
  return std::max(kFinestStep, representable);
}

// Whether cells without a tile get float32: unless every tile has float64.
bool NewTilesAreFloat32(const PlanInput& input) {
  bool any = false;
  for (const auto& [cell, record] : input.cells) {
    if (record == nullptr) continue;
    if (record->float32) return true;
    any = true;
  }
  return !any;
}

// Of the vertices of a tile's boundary that are in the plan.
void StoreGround(const RimGround& rim, std::span<const int32_t> vertices, Plan& plan) {
  for (size_t i = 0; i < std::min(vertices.size(), rim.on_object.size()); ++i) {
    if (vertices[i] < 0) continue;
    PlanVertex& vertex = plan.vertices[vertices[i]];
    (rim.on_object[i] ? vertex.on_object : vertex.on_ground) = true;
    if (rim.on_object[i] && !std::isnan(rim.ground[i])) vertex.ground = rim.ground[i];
  }
}

// Appends the rim points and seam vertices of a part. Returns the number of the first.
int32_t StoreVertices(const PlanInput& input, Rim& rim, const SeamLayout& seams, Plan& plan) {
  const auto base = static_cast<int32_t>(plan.vertices.size());
  plan.vertices.reserve(plan.vertices.size() + rim.points.size() + seams.vertices.size());
  for (auto& [cell, points] : rim.point_of) {
    for (int32_t& p : points) p = p < 0 ? -1 : p + base;
    plan.vertex_of_boundary[cell] = std::move(points);
  }
  for (const RimPoint& p : rim.points) {
    const uint8_t lines = p.index < 0 ? kFixedVertex : 0;
    plan.vertices.push_back({p.tile, p.index, p.position, p.centroid_height, p.size, lines});
  }
  for (const auto& [cell, ground] : input.rim_ground) StoreGround(ground, VerticesOf(plan, cell), plan);
  for (const SeamVertex& v : seams.vertices) {
    const double height = v.beside >= 0 ? rim.points[v.beside].position.z() : 0;
    const Point3 position(v.position.x(), v.position.y(), height);
    plan.vertices.push_back({{}, -1, position, 0, v.size, v.lines, v.beside >= 0});
  }
  return base;
}

void StoreHoles(FoundHoles found, int32_t base, Plan& plan) {
  for (PlannedHole& hole : found.holes) {
    for (RimSegment& s : hole.segments) {
      s.from += base;
      s.to += base;
    }
    plan.holes.push_back(std::move(hole));
  }
  plan.left.insert(plan.left.end(), found.left.begin(), found.left.end());
  plan.outer_rims += found.outer_rims;
}

// Walks along the rim that end somewhere. Each cell has its edges of them; the fault lies in those with an end.
void LeaveUnlinked(const Rim& rim, Plan& plan) {
  std::map<int32_t, int> ending;  // at each point: walks that end there, less those that begin
  for (const int32_t e : rim.unlinked) ++ending[rim.edges[e].to], --ending[rim.edges[e].from];
  struct Edges {
    int64_t count = 0;
    int32_t first_end = -1;
  };
  std::map<CellId, Edges> of_cell;
  for (const int32_t e : rim.unlinked) {
    Edges& edges = of_cell[rim.edges[e].owner];
    ++edges.count;
    for (const int32_t p : {rim.edges[e].from, rim.edges[e].to}) {
      if (ending.at(p) != 0 && edges.first_end < 0) edges.first_end = p;
    }
  }
  for (const auto& [cell, edges] : of_cell) {
    if (edges.first_end < 0) {
      plan.left.push_back({cell, "boundary edges that form no loop with those of other cells", -1, edges.count});
    } else {
      plan.left.push_back({cell, "boundary edges that form no loop: the surface is not manifold there", -1, edges.count,
                           true, rim.points[edges.first_end].position});
    }
  }
}

std::set<CellId> CellsOf(const PlanInput& input) {
  std::set<CellId> cells;
  for (const auto& [cell, record] : input.cells) cells.insert(cell);
  return cells;
}

// Leaves of the rim what bounds holes inside the area's polygon.
void CutByPolygon(const PlanInput& input, const GridLines& lines, const PlanOptions& options, Rim& rim, Plan& plan) {
  const RimIndex index(rim);
  const std::set<CellId> cells = CellsOf(input);
  AreaCut cut = CutByArea({cells, lines, rim, index, options, plan.lattice_step}, input);
  plan.left.insert(plan.left.end(), cut.left.begin(), cut.left.end());
  rim = std::move(cut.rim);
}

// Plans the holes of cells whose tiles share vertices and stores them.
void PlanPart(const PlanInput& input, const PlanInput& own, const GridLines& lines, const PlanOptions& options,
              Plan& plan) {
  // What becomes of tiles that overlap is found on their own outlines.
  Rim rim = BuildRim(input, lines.joined ? RimPoints::kAll : RimPoints::kOfEdges);
  if (!input.area.empty()) CutByPolygon(input, lines, options, rim, plan);
  if (options.cancelled()) return;
  const ClosingCells closing = FindClosingCells(input, lines, rim);
  RaiseSmallSizes(plan.lattice_step, rim);
  RaiseSizesAtShortEdges(rim);
  const Part part{input, own, lines, options, rim, plan.lattice_step};
  if (options.cancelled()) return;
  Division division = DivideScene(part, closing);
  const int32_t base = StoreVertices(input, rim, division.seams, plan);
  for (auto& [cell, found] : division.holes) StoreHoles(std::move(found), base, plan);
  for (Seam& seam : division.seams.seams) {
    for (int32_t& v : seam.vertices) v += base;
    plan.seams.push_back(std::move(seam));
  }
  plan.continuous += rim.continuous;
  LeaveUnlinked(rim, plan);
}

// The rim of the tiles as they are says how far apart vertices along the area's edge are to be.
JointTiles JoinInArea(const PlanInput& input, const JointTiles& whole, const GridLines& outlines,
                      const PlanOptions& options, double lattice_step) {
  const Rim rim = BuildRim(whole.input);
  const RimIndex index(rim);
  const std::set<CellId> cells = CellsOf(input);
  const SeamSite site{cells, whole.lines, rim, index, options, lattice_step};
  const std::vector<std::vector<Point2>> rings = SpacedRings(site, input);
  return JoinTiles(input, outlines, lattice_step, &rings);
}

// How the tiles of a scene meet. It does not depend on the area: the plans of one scene with different areas share it.
struct TileLayout {
  double lattice_step = 0;
  std::vector<BorderAudit> borders;
  GridLines lines;
  std::optional<PieceLayout> pieces;  // of a scene of one tile that is stored in pieces
  std::optional<JointTiles> joint;    // of tiles that share no vertices; without the area
};

// Of a scene of one tile that is stored in pieces. Cells may be there that only the area makes a part of the scene.
std::optional<PieceLayout> PiecesOf(const PlanInput& input) {
  const auto has_tile = [](const auto& of_cell) { return of_cell.second != nullptr; };
  if (std::ranges::count_if(input.cells, has_tile) != 1) return std::nullopt;
  return FindPieceLayout(*std::ranges::find_if(input.cells, has_tile)->second.Outline());
}

// Cost: O(n log n) in the boundary edges.
TileLayout LayOutTiles(const PlanInput& input) {
  TileLayout layout;
  layout.lattice_step = LatticeStep(input);
  if (!input.has_grid) return layout;
  BorderFindings findings = AuditBorders(input);
  layout.lines = FindGridLines(input, findings, layout.lattice_step);
  layout.borders = std::move(findings.borders);
  layout.pieces = PiecesOf(input);
  if (layout.pieces) {
    findings.independent = true;
    layout.lines.pieces = *layout.pieces;
  }
  if (!findings.independent) return layout;
  layout.joint = JoinTiles(input, layout.lines, layout.lattice_step);
  layout.joint->input.rim_ground = JointGround(*layout.joint, input.rim_ground);
  return layout;
}

void PlanJoint(const PlanInput& input, const GridLines& outlines, const JointTiles& joint, const PlanOptions& options,
               Plan& plan) {
  PlanPart(joint.input, input, joint.lines, options, plan);
  LayOwnRegions(input, outlines, joint, plan);
}

// Plans tiles that share no vertices as the clipped scene that they stand for.
void PlanOverlapping(const PlanInput& input, const TileLayout& layout, const PlanOptions& options, Plan& plan) {
  if (input.area.empty()) return PlanJoint(input, layout.lines, *layout.joint, options, plan);
  JointTiles inside = JoinInArea(input, *layout.joint, layout.lines, options, plan.lattice_step);
  inside.input.rim_ground = JointGround(inside, input.rim_ground);
  PlanJoint(input, layout.lines, inside, options, plan);
}

void StoreLayers(Plan& plan) {
  std::vector<bool> open, outermost;
  for (const PlannedHole& hole : plan.holes) {
    open.push_back((hole.kind != HoleKind::kClosed || !hole.own_regions.empty()) && hole.failure.empty());
    // Islands count, which the hole's own boundary does not.
    outermost.push_back(
        std::any_of(hole.segments.begin(), hole.segments.end(), [](const RimSegment& s) { return !s.seam; }));
  }
  std::vector<std::pair<int32_t, int32_t>> touching = HolesThatTouch(plan);
  const std::vector<std::pair<int32_t, int32_t>> reached = HolesReached(plan, open, touching);
  touching.insert(touching.end(), reached.begin(), reached.end());
  const Layering layering = LayerHoles(open, outermost, touching);
  plan.clusters = layering.clusters;
  plan.layers = layering.layers;
  for (size_t h = 0; h < plan.holes.size(); ++h) {
    plan.holes[h].cluster = layering.cluster[h];
    plan.holes[h].layer = layering.layer[h];
  }
}

// Twice the area inside the boundary, seen from above: not above zero where the surface faces down, or has no outline.
double TwiceArea(const SurveyRecord& record) {
  double area = 0;
  for (const BoundaryEdge& e : record.edges) {
    const Point3 &a = record.vertices[e.from].position, &b = record.vertices[e.to].position;
    area += (a.x() - record.lo.x()) * (b.y() - record.lo.y()) - (b.x() - record.lo.x()) * (a.y() - record.lo.y());
  }
  return area;
}

// Of tiles that face down nothing is seen from above: their cells would be paved.
void RefuseTilesThatFaceDown(const PlanInput& input, Plan& plan) {
  constexpr char kReason[] =
      "the tile faces down, or its surface has no outline; turn its triangles or repair it first";
  std::set<CellId> cells;
  for (const auto& [cell, record] : input.cells) {
    if (record == nullptr || record->triangle_count == 0) continue;
    const auto outline = record.Outline();
    if (TwiceArea(*outline) > 0) continue;
    cells.insert(cell);
    plan.left.push_back({cell, kReason, -1, std::ssize(outline->edges)});
  }
  for (PlannedHole& hole : plan.holes) {
    if (hole.failure.empty() && cells.contains(hole.cell)) hole.failure = kReason;
  }
}

// Whether a vertex of the original surface is on the rim, or one whose height is known.
bool HasHeight(const Plan& plan, const PlannedHole& hole) {
  bool has_height = false;
  ForRimSegments(hole, [&](const RimSegment& s) {
    const PlanVertex& v = plan.vertices[s.from];
    has_height = has_height || v.index >= 0 || v.height_known;
  });
  return has_height;
}

// Holes that meet no surface at all, as where a polygon took it all out, or where the area ends inside a hole. Nothing
// tells how high anything lies there, unless it is water whose level was given.
void LeaveWithoutHeight(Plan& plan) {
  for (const std::vector<int32_t>& group : GroupAllHoles(plan)) {
    const auto is_known = [&](int32_t h) { return plan.holes[h].water >= 0 || HasHeight(plan, plan.holes[h]); };
    if (std::ranges::any_of(group, is_known)) continue;
    for (const int32_t h : group) {
      PlannedHole& hole = plan.holes[h];
      if (!hole.failure.empty()) continue;
      hole.failure = "no surface is at its rim, so nothing tells its height";
      plan.left.push_back({hole.cell, hole.failure, h, hole.boundary_vertices});
    }
  }
}

void LeaveFailedHoles(Plan& plan) {
  for (size_t h = 0; h < plan.holes.size(); ++h) {
    const PlannedHole& hole = plan.holes[h];
    if (hole.failure.empty()) continue;
    plan.left.push_back({hole.cell, hole.failure, static_cast<int32_t>(h), hole.boundary_vertices});
  }
}

Plan PlanGrid(const PlanInput& input, const PlanOptions& options, const TileLayout& layout) {
  Plan plan;
  plan.lattice_step = layout.lattice_step;
  plan.borders = layout.borders;
  if (layout.pieces) plan.remarks.piece_reach = layout.pieces->reach;
  if (layout.joint) {
    PlanOverlapping(input, layout, options, plan);
  } else {
    PlanPart(input, input, layout.lines, options, plan);
  }
  return plan;
}

// The tiles as they are, and which pieces of them are planned apart (hole/free_pieces.h).
struct WholeTiles {
  const PlanInput& input;
  const FreePieces& free_pieces;
};

// Holes, clusters, layers: all that does not depend on objects and water.
//   input  without the free pieces
Plan PlanHoles(const PlanInput& input, const PlanOptions& options, const TileLayout& layout, const WholeTiles& tiles) {
  Plan plan = input.has_grid ? PlanGrid(input, options, layout) : PlanMesh(input, options);
  AddFreePieces(tiles.input, tiles.free_pieces, options, plan);
  if (input.has_grid) RefuseTilesThatFaceDown(tiles.input, plan);
  plan.remarks.has_polygon = !input.area.empty();
  RemarkOnNumbers(tiles.input, plan.remarks);
  StoreLayers(plan);
  DecideHoles(options.water.areas, plan, options.is_cancelled);
  LeaveFailedHoles(plan);
  return plan;
}

// Adds objects and water.
void TellWater(const PlanInput& input, const PlanOptions& options, const KnownWater& known, Plan& plan) {
  FindRimSlopes(plan);
  if (!options.cancelled()) MarkObjects(plan);
  if (!options.cancelled()) FindWater(input, options.water, known, plan, options.is_cancelled);
  if (known.bodies.empty() || options.cancelled()) return;
  StoreLayers(plan);
  FindRimSlopes(plan);
}

bool MayHaveWater(const WaterOptions& water) {
  return water.find || std::ranges::any_of(water.areas, [](const WaterArea& area) { return area.water; });
}

// The water of the scene without its area, where there is one: the area may leave too little of a shore, and the hole
// around a scene goes on into its lakes. Where the surface ends inside the cells there is such a hole without the area,
// too: so up to the outline of the surface first. `layout` is that of `input`.
KnownWater WaterOfScene(const PlanInput& input, const PlanOptions& options, const TileLayout& layout,
                        const WholeTiles& tiles, const Plan& plan) {
  if ((input.area.empty() && input.added.empty()) || plan.holes.empty() || !MayHaveWater(options.water)) return {};
  PlanInput scene = input;
  for (const CellId cell : input.added) scene.cells.erase(cell);
  scene.added.clear();
  const std::optional<TileLayout> own = input.added.empty() ? std::nullopt : std::optional(LayOutTiles(scene));
  KnownWater known;
  known.body_of.assign(plan.holes.size(), -1);
  const auto add_water_up_to = [&](const PlanePolygon& area) {
    scene.area = area;
    Plan whole = PlanHoles(scene, options, own ? *own : layout, tiles);
    if (!options.cancelled()) TellWater(scene, options, {}, whole);
    AddKnownWater(FindKnownWater(whole, plan), known);
  };
  const PlanePolygon outline = OutlineInsideCells(scene.grid, scene.cells);
  if (!outline.empty()) add_water_up_to(outline);
  if (!options.cancelled()) add_water_up_to({});
  return known;
}

//   input  as of PlanHoles
Plan PlanScene(const PlanInput& input, const PlanOptions& options, const WholeTiles& tiles) {
  TileLayout layout = LayOutTiles(input);
  Plan plan = PlanHoles(input, options, layout, tiles);
  plan.float32 = NewTilesAreFloat32(input);
  if (layout.joint && !layout.pieces) plan.remarks.turn = TurnOfTiles(input);
  if (!plan.upright) return options.cancelled() ? Plan() : plan;
  if (!options.cancelled()) TellWater(input, options, WaterOfScene(input, options, layout, tiles, plan), plan);
  if (!options.cancelled()) LeaveWithoutHeight(plan);
  layout.joint.reset();  // large
  if (!options.cancelled()) MarkClearedShores(options.water.areas, plan, options.is_cancelled);
  if (!options.cancelled()) LayWallFeet(plan);
  if (!options.cancelled()) LayStripEdges(layout.lines, plan);
  if (options.cancelled()) return {};
  if (input.has_grid) LeaveClearedCells(input.grid, options.water.areas, plan, options.is_cancelled);
  AnswerWaterAreas(options.water, plan, BoundsOfCells(input), options.is_cancelled);
  if (options.cancelled()) return {};
  DropUnusedVertices(plan);
  return plan;
}

}  // namespace

Plan MakePlan(const PlanInput& input, const PlanOptions& options) {
  const FreePieces pieces = FindFreePieces(input);
  const WholeTiles tiles{input, pieces};
  return pieces.empty() ? PlanScene(input, options, tiles) : PlanScene(WithoutPieces(input, pieces), options, tiles);
}

}  // namespace tilemend
