#include "coordinator/plan/hole/free_pieces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "common/mesh/edge_loops.h"
#include "common/mesh/exact_signs.h"
#include "common/mesh/plane_polygon.h"
#include "common/mesh/triangle_shape.h"
#include "coordinator/plan/hole/cell_boundary.h"
#include "coordinator/plan/hole/hole_regions.h"
#include "coordinator/plan/rim/rim.h"
#include "coordinator/plan/rim/rim_sizes.h"

namespace tilemend {
namespace {

// A piece hangs free if a wall to the ground has more than this many times the area of its openings.
// (docs/decisions/2026-11-30-free-pieces.md)
constexpr double kMinWallPerOpening = 10;
constexpr size_t kMaxAskedVertices = 8;     // of a piece
constexpr int64_t kMaxLooks = 100'000'000;  // of places at edges level with them: half a second

struct AskedPlace {
  Point2 at{0, 0};
  int32_t piece = 0;
  int winding = 0;  // of the other pieces' boundaries
};

// The pieces of one tile.
class PieceFinder {
 public:
  PieceFinder(const PlanInput& input, CellId cell, const SurveyRecord& record, const RimGround& ground)
      : input_(input), record_(record), ground_(ground) {
    const Point2 corner = input.grid.corner + Point2(cell.col, cell.row).cwiseProduct(input.grid.cell_size);
    inside_ = Eigen::AlignedBox2d(corner, corner + input.grid.cell_size)
                  .intersection(Eigen::AlignedBox2d(record.lo.head<2>(), record.hi.head<2>()));
  }

  std::set<int32_t> Find() const {
    std::map<int32_t, std::vector<DirectedEdge>> edges_of;
    for (const BoundaryEdge& e : record_.edges) edges_of[e.piece].push_back({e.from, e.to});
    std::set<int32_t> pieces;
    std::vector<AskedPlace> places;
    for (const auto& [piece, edges] : edges_of) {
      if (!StandsOff(edges) || !HangsHigh(edges) || !IsInArea(edges)) continue;
      pieces.insert(piece);
      const size_t step = (edges.size() + kMaxAskedVertices - 1) / kMaxAskedVertices;
      for (size_t i = 0; i < edges.size(); i += step) places.push_back({At(edges[i].from), piece});
    }
    if (!AskAll(places)) return {};
    for (const AskedPlace& place : places) {
      if (place.winding != 0) pieces.erase(place.piece);
    }
    return pieces;
  }

 private:
  Point2 At(int32_t v) const { return record_.vertices[v].position.head<2>(); }

  // Nothing if the vertex stands on the ground, or that is not known.
  std::optional<double> HeightAboveGround(int32_t v) const {
    const double height = record_.vertices[v].position.z() - ground_.ground[v];
    return ground_.on_object[v] && height > 0 ? std::optional(height) : std::nullopt;
  }

  // Where the tile is cut, the rest of the piece is in the next one.
  bool StandsOff(const std::vector<DirectedEdge>& edges) const {
    double longest = 0;
    for (const auto& [from, to] : edges) longest = std::max(longest, (At(to) - At(from)).norm());
    return std::ranges::all_of(edges, [&](const DirectedEdge& e) {
      const Point2 p = At(e.from);
      const double to_outline = std::min((p - inside_.min()).minCoeff(), (inside_.max() - p).minCoeff());
      return HeightAboveGround(e.from) && to_outline > longest;
    });
  }

  // Precondition: StandsOff.
  bool HangsHigh(const std::vector<DirectedEdge>& edges) const {
    double wall = 0, closing = 0;
    for (const EdgeWalk& loop : LinkEdges(edges)) {
      if (!loop.closed) return false;
      Point3 middle = Point3::Zero();
      for (const int32_t e : loop.edges) {
        middle += record_.vertices[edges[e].from].position / static_cast<double>(loop.edges.size());
      }
      for (const int32_t e : loop.edges) {
        const auto& [from, to] = edges[e];
        wall += (At(to) - At(from)).norm() * (*HeightAboveGround(from) + *HeightAboveGround(to)) / 2;
        closing += TriangleArea(record_.vertices[from].position, record_.vertices[to].position, middle);
      }
    }
    return wall > kMinWallPerOpening * closing;
  }

  bool IsInArea(const std::vector<DirectedEdge>& edges) const {
    const auto is_inside = [&](const DirectedEdge& e) { return Contains(input_.area, At(e.from)); };
    return input_.area.empty() || std::ranges::all_of(edges, is_inside);
  }

  // Sorts the places. False if it would take too long.
  bool AskAll(std::vector<AskedPlace>& places) const {
    const auto height = [](const AskedPlace& place) { return place.at.y(); };
    std::ranges::sort(places, {}, [](const AskedPlace& p) { return std::tuple(p.at.y(), p.at.x(), p.piece); });
    int64_t looks = 0;
    for (const BoundaryEdge& e : record_.edges) {
      const Point2 a = At(e.from), b = At(e.to);
      const auto first = std::ranges::lower_bound(places, std::min(a.y(), b.y()), {}, height);
      const auto last = std::ranges::lower_bound(places, std::max(a.y(), b.y()), {}, height);
      looks += last - first;
      if (looks > kMaxLooks) return false;
      for (auto place = first; place != last; ++place) {
        if (place->piece == e.piece) continue;
        const int turn = TurnOf(a, b, place->at);
        if (turn != 0 && (turn > 0) == (b.y() > a.y())) place->winding += turn;
      }
    }
    return true;
  }

  const PlanInput& input_;
  const SurveyRecord& record_;
  const RimGround& ground_;
  Eigen::AlignedBox2d inside_;  // of the cell and of the tile
};

// The record with the edges of the pieces alone, or with all others. It has a band if that is asked for.
std::shared_ptr<SurveyRecord> PartOf(const SurveyRecord& whole, const std::set<int32_t>& pieces, bool of_pieces,
                                     bool with_band) {
  auto part = std::make_shared<SurveyRecord>();
  static_cast<SurveySummary&>(*part) = whole;
  part->vertices = whole.vertices;
  part->colours = whole.colours;
  std::ranges::copy_if(whole.edges, std::back_inserter(part->edges),
                       [&](const BoundaryEdge& e) { return pieces.contains(e.piece) == of_pieces; });
  if (with_band) part->band = whole.band;
  return part;
}

// A record without the edges of some pieces, made anew each time that it is asked for.
class RestOfRecord : public StoredRecord::Source {
 public:
  RestOfRecord(StoredRecord whole, std::set<int32_t> pieces) : whole_(std::move(whole)), pieces_(std::move(pieces)) {}

  const SurveySummary& summary() const override { return *whole_; }

  StoredRecord::Pointer Read(bool with_band) const override {
    return PartOf(with_band ? *whole_.WithBand() : *whole_.Outline(), pieces_, false, with_band);
  }

 private:
  const StoredRecord whole_;
  const std::set<int32_t> pieces_;
};

// Of each boundary vertex, whether it is on other pieces as well.
std::vector<bool> VerticesOfOthers(const SurveyRecord& record, const std::set<int32_t>& pieces) {
  std::vector<bool> of_others(record.vertices.size(), false);
  for (const BoundaryEdge& e : record.edges) {
    if (!pieces.contains(e.piece)) of_others[e.from] = of_others[e.to] = true;
  }
  return of_others;
}

// Of each point of a rim of pieces the vertex in the plan. A vertex of these pieces alone is on no object that the fill
// passes below: it takes part in the patches of their own holes.
std::vector<int32_t> PlanVerticesOf(CellId cell, const std::vector<bool>& of_others, const Rim& rim, Plan& plan) {
  std::vector<int32_t>& of = plan.vertex_of_boundary[cell];
  of.resize(of_others.size(), -1);
  std::vector<int32_t> numbers(rim.points.size(), -1);
  const std::vector<int32_t>& points = rim.point_of.at(cell);
  for (size_t i = 0; i < points.size(); ++i) {
    if (points[i] < 0) continue;
    const bool is_new = of[i] < 0;
    if (is_new) {
      of[i] = static_cast<int32_t>(plan.vertices.size());
      plan.vertices.emplace_back();
    }
    const RimPoint& p = rim.points[points[i]];
    if (is_new || !of_others[i]) plan.vertices[of[i]] = {cell, p.index, p.position, p.centroid_height, p.size};
    numbers[points[i]] = of[i];
  }
  return numbers;
}

// The rim of some pieces of a tile alone.
Rim RimOfPieces(const PlanInput& input, CellId cell, const SurveyRecord& whole, const std::set<int32_t>& pieces,
                double lattice_step) {
  const std::shared_ptr<SurveyRecord> part = PartOf(whole, pieces, true, false);
  Rim rim = BuildRim({.grid = input.grid, .cells = {{cell, StoredRecord(part.get())}}}, RimPoints::kOfEdges);
  RaiseSmallSizes(lattice_step, rim);
  RaiseSizesAtShortEdges(rim);
  return rim;
}

void AddPieces(const PlanInput& input, CellId cell, const std::set<int32_t>& pieces, const PlanOptions& options,
               Plan& plan) {
  const StoredRecord& stored = input.cells.at(cell);
  const StoredRecord::Pointer record = stored.Outline();
  const Rim rim = RimOfPieces(input, cell, *record, pieces, plan.lattice_step);
  if (rim.loops.empty()) return;
  std::vector<Point3> position;
  for (const RimPoint& p : rim.points) position.push_back(p.position);
  CellBoundary boundary;
  boundary.cell = cell;
  boundary.surface = &stored;
  for (const std::vector<int32_t>& loop : rim.loops) boundary.closed_loops.push_back(Reversed(rim, loop));
  FoundHoles found = FindHoles({{cell}, {}, rim, position, options.is_cancelled}, boundary);
  const std::vector<int32_t> numbers = PlanVerticesOf(cell, VerticesOfOthers(*record, pieces), rim, plan);
  for (PlannedHole& hole : found.holes) {
    for (RimSegment& s : hole.segments) s = {numbers[s.from], numbers[s.to], s.seam};
    hole.standing = Standing::kHanging;
    plan.holes.push_back(std::move(hole));
  }
  std::ranges::move(found.left, std::back_inserter(plan.left));
  plan.outer_rims += found.outer_rims;
  plan.continuous += rim.continuous;
}

}  // namespace

FreePieces FindFreePieces(const PlanInput& input) {
  FreePieces pieces;
  for (const auto& [cell, ground] : input.rim_ground) {
    const auto stored = input.cells.find(cell);
    if (stored == input.cells.end() || stored->second == nullptr || ground.on_object.empty()) continue;
    std::set<int32_t> of_tile = PieceFinder(input, cell, *stored->second.Outline(), ground).Find();
    if (!of_tile.empty()) pieces[cell] = std::move(of_tile);
  }
  return pieces;
}

PlanInput WithoutPieces(PlanInput input, const FreePieces& pieces) {
  for (const auto& [cell, of_tile] : pieces) {
    StoredRecord& stored = input.cells.at(cell);
    stored = StoredRecord(std::make_shared<RestOfRecord>(stored, of_tile));
  }
  return input;
}

void AddFreePieces(const PlanInput& input, const FreePieces& pieces, const PlanOptions& options, Plan& plan) {
  if (pieces.empty()) return;
  for (const auto& [cell, of_tile] : pieces) {
    if (!options.cancelled()) AddPieces(input, cell, of_tile, options, plan);
  }
  std::ranges::stable_sort(plan.holes, {}, &PlannedHole::cell);
}

}  // namespace tilemend
