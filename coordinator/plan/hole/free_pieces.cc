#include "coordinator/plan/hole/free_pieces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "common/mesh/bin_grid.h"
#include "common/mesh/edge_loops.h"
#include "common/mesh/exact_signs.h"
#include "common/mesh/triangle_shape.h"
#include "coordinator/plan/hole/cell_boundary.h"
#include "coordinator/plan/hole/hole_regions.h"
#include "coordinator/plan/rim/rim.h"
#include "coordinator/plan/types/meet_tolerance.h"

namespace tilemend {
namespace {

// Square metres of wall for one that closes the piece: more are a curtain. (docs/decisions/2026-11-30-free-pieces.md)
constexpr double kCurtain = 10;
constexpr size_t kMostAsked = 8;  // vertices of a piece

// The pieces of one tile.
class PieceFinder {
 public:
  PieceFinder(const SurveyRecord& record, const RimGround& ground) : record_(record), ground_(ground) {}

  std::set<int32_t> Find() {
    std::map<int32_t, std::vector<DirectedEdge>> edges_of;
    for (const BoundaryEdge& e : record_.edges) edges_of[e.piece].push_back({e.from, e.to});
    std::set<int32_t> pieces;
    for (const auto& [piece, edges] : edges_of) {
      const bool stands_off = std::ranges::all_of(
          edges, [this](const DirectedEdge& e) { return Above(e.from) > 0 && !LiesOnOutline(e.from); });
      if (stands_off && WallOf(edges) > kCurtain * ClosingOf(edges) && IsOverHole(piece, edges)) pieces.insert(piece);
    }
    return pieces;
  }

 private:
  const Point3& Position(int32_t v) const { return record_.vertices[v].position; }

  // How far a vertex stands above the ground, metres; NaN: it stands on it, or that is not known.
  double Above(int32_t v) const {
    if (!ground_.on_object[v]) return std::numeric_limits<double>::quiet_NaN();
    return Position(v).z() - ground_.ground[v];
  }

  bool LiesOnOutline(int32_t v) const {
    const auto to_lo = (Position(v) - record_.lo).head<2>(), to_hi = (record_.hi - Position(v)).head<2>();
    return std::min(to_lo.minCoeff(), to_hi.minCoeff()) <= kMeetTolerance;
  }

  double WallOf(const std::vector<DirectedEdge>& edges) const {
    double wall = 0;
    for (const auto& [from, to] : edges) {
      wall += (Position(to) - Position(from)).head<2>().norm() * (Above(from) + Above(to)) / 2;
    }
    return wall;
  }

  // The triangles from the loops' edges to the middle of their vertices.
  double ClosingOf(const std::vector<DirectedEdge>& edges) const {
    double area = 0;
    for (const EdgeWalk& loop : LinkEdges(edges)) {
      Point3 middle = Point3::Zero();
      for (const int32_t e : loop.edges) middle += Position(edges[e].from) / static_cast<double>(loop.edges.size());
      for (const int32_t e : loop.edges) area += TriangleArea(Position(edges[e].from), Position(edges[e].to), middle);
    }
    return area;
  }

  // A curtain around a crown would pass through what hangs below that.
  bool IsOverHole(int32_t piece, const std::vector<DirectedEdge>& edges) {
    const size_t step = std::max<size_t>(1, edges.size() / kMostAsked);
    for (size_t i = 0; i < edges.size(); i += step) {
      if (SheetsOver(Position(edges[i].from).head<2>(), piece) > 0) return false;
    }
    return true;
  }

  // How many sheets of other pieces lie over or under a place: how often their boundaries wind around it.
  int SheetsOver(const Point2& p, int32_t piece) {
    if (!bins_) MakeBins();
    int winding = 0;
    for (const int32_t i : bins_->In({p, Point2(std::numeric_limits<double>::infinity(), p.y())})) {
      const BoundaryEdge& e = record_.edges[i];
      if (e.piece == piece) continue;
      const Point2 a = Position(e.from).head<2>(), b = Position(e.to).head<2>();
      if (a.y() <= p.y() && b.y() > p.y()) winding += TurnOf(a, b, p) > 0;
      if (a.y() > p.y() && b.y() <= p.y()) winding -= TurnOf(a, b, p) < 0;
    }
    return winding;
  }

  Eigen::AlignedBox2d BoxOf(int32_t e) const {
    const Point2 a = Position(record_.edges[e].from).head<2>(), b = Position(record_.edges[e].to).head<2>();
    return {a.cwiseMin(b), a.cwiseMax(b)};
  }

  // As many bins as edges.
  void MakeBins() {
    const auto count = static_cast<int32_t>(record_.edges.size());
    Eigen::AlignedBox2d extent;
    for (int32_t e = 0; e < count; ++e) extent.extend(BoxOf(e));
    const Point2 sides = extent.sizes();
    const double step = std::max(std::sqrt(sides.x() * sides.y() / count), sides.maxCoeff() / count);
    bins_.emplace(extent, step > 0 ? step : 1, count, [this](int32_t e) { return BoxOf(e); });
  }

  const SurveyRecord& record_;
  const RimGround& ground_;
  std::optional<BinGrid> bins_;  // of the edges
};

// The record with the edges of the pieces alone, or without them.
std::shared_ptr<SurveyRecord> PartOf(const SurveyRecord& record, const std::set<int32_t>& pieces, bool of_pieces) {
  auto part = std::make_shared<SurveyRecord>(record);
  std::erase_if(part->edges, [&](const BoundaryEdge& e) { return pieces.contains(e.piece) != of_pieces; });
  return part;
}

// The plan's vertices of a tile's rim of pieces. They are on no object that the fill passes below: it ends there.
//   of_others  whether a boundary vertex is on other pieces as well
std::vector<int32_t> PlanVerticesOf(CellId cell, const std::vector<bool>& of_others, const Rim& rim, Plan& plan) {
  std::vector<int32_t>& of = plan.vertex_of_boundary[cell];
  of.resize(of_others.size(), -1);
  std::vector<int32_t> numbers(rim.points.size(), -1);
  const std::vector<int32_t>& points = rim.point_of.at(cell);
  for (size_t i = 0; i < points.size(); ++i) {
    if (points[i] < 0) continue;
    const RimPoint& p = rim.points[points[i]];
    const PlanVertex vertex{cell, p.index, p.position, p.centroid_height, p.size};
    if (of[i] < 0) {
      of[i] = static_cast<int32_t>(plan.vertices.size());
      plan.vertices.push_back(vertex);
    } else if (!of_others[i]) {
      plan.vertices[of[i]] = vertex;
    }
    numbers[points[i]] = of[i];
  }
  return numbers;
}

void AddPieces(const PlanInput& input, CellId cell, const std::set<int32_t>& pieces, Plan& plan) {
  const StoredRecord& stored = input.cells.at(cell);
  const StoredRecord::Pointer whole = stored.Outline();
  const std::shared_ptr<SurveyRecord> record = PartOf(*whole, pieces, true);
  std::vector<bool> of_others(whole->vertices.size(), false);
  for (const BoundaryEdge& e : whole->edges) {
    if (!pieces.contains(e.piece)) of_others[e.from] = of_others[e.to] = true;
  }
  const Rim rim = BuildRim({.grid = input.grid, .cells = {{cell, StoredRecord(record.get())}}}, RimPoints::kOfEdges);
  std::vector<Point3> position;
  for (const RimPoint& p : rim.points) position.push_back(p.position);
  CellBoundary boundary;
  boundary.cell = cell;
  boundary.surface = &stored;
  for (const std::vector<int32_t>& loop : rim.loops) boundary.closed_loops.push_back(Reversed(rim, loop));
  FoundHoles found = FindHoles({{cell}, {}, rim, position}, boundary);
  const std::vector<int32_t> numbers = PlanVerticesOf(cell, of_others, rim, plan);
  for (PlannedHole& hole : found.holes) {
    for (RimSegment& s : hole.segments) s = {numbers[s.from], numbers[s.to], s.seam};
    plan.holes.push_back(std::move(hole));
  }
  std::ranges::move(found.left, std::back_inserter(plan.left));
  plan.outer_rims += found.outer_rims;
}

}  // namespace

FreePieces FindFreePieces(const PlanInput& input) {
  FreePieces pieces;
  for (const auto& [cell, ground] : input.rim_ground) {
    const auto stored = input.cells.find(cell);
    if (stored == input.cells.end() || stored->second == nullptr || ground.on_object.empty()) continue;
    std::set<int32_t> of_tile = PieceFinder(*stored->second.Outline(), ground).Find();
    if (!of_tile.empty()) pieces[cell] = std::move(of_tile);
  }
  return pieces;
}

PlanInput WithoutPieces(PlanInput input, const FreePieces& pieces) {
  for (const auto& [cell, of_tile] : pieces) {
    StoredRecord& stored = input.cells.at(cell);
    stored = StoredRecord(StoredRecord::Pointer(PartOf(*stored.WithBand(), of_tile, false)));
  }
  return input;
}

void AddFreePieces(const PlanInput& input, const FreePieces& pieces, Plan& plan) {
  for (const auto& [cell, of_tile] : pieces) AddPieces(input, cell, of_tile, plan);
  std::ranges::stable_sort(plan.holes, {}, &PlannedHole::cell);
}

}  // namespace tilemend
