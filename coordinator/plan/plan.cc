#include "coordinator/plan/plan.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>
#include <utility>

#include "coordinator/plan/hole/hole_regions.h"
#include "coordinator/plan/hole/layers.h"
#include "coordinator/plan/pieces/outline_chains.h"
#include "coordinator/plan/rim/closing_cells.h"
#include "coordinator/plan/rim/grid_lines.h"
#include "coordinator/plan/rim/rim.h"
#include "coordinator/plan/rim/rim_index.h"
#include "coordinator/plan/seam/seam_layout.h"
#include "coordinator/plan/water/water.h"

namespace tilemend {
namespace {

constexpr double kFinestStep = 0x1p-10;  // metres
constexpr size_t kLongestRun = 60;       // edges: longer runs off the outline are holes that want seams

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

// One part of the scene whose tiles share vertices: the whole scene, or a single tile where tiles keep to outlines of
// their own.
class PartPlanner {
 public:
  PartPlanner(const PlanInput& input, const std::set<CellId>& scene_area, const CutLines& lines,
              const PlanOptions& options, Plan& plan)
      : input_(input), scene_area_(scene_area), lines_(lines), options_(options), plan_(plan) {}

  void Run() {
    rim_ = BuildRim(input_, !lines_.independent);
    LabelEdges(input_, lines_, rim_);
    RaiseSmallSizes(plan_.lattice_step, rim_);
    RaiseSizesAtShortEdges(rim_);
    const RimIndex index(rim_);
    std::set<CellId> area;
    for (const auto& [cell, record] : input_.cells) area.insert(cell);
    chained_.assign(rim_.loops.size(), false);
    detached_.assign(rim_.loops.size(), false);
    if (lines_.independent) ChainPieces(index);
    layout_ = LaySeamsOfLoops(area, index);
    if (lines_.independent && !layout_.failures.empty()) {
      ChainOneSided();
      layout_ = LaySeamsOfLoops(area, index);
    }
    const std::vector<CellId> labels = Labels();
    FindHolesOf(area);
    if (!lines_.independent) TrySeamsOffRim(area, index, labels);
    if (!lines_.independent && !lines_.clipped) TryOtherLabels(area, index);
    plan_.continuous += rim_.continuous;
    Commit();
    LeaveUnlinked();
  }

 private:
  // Everything that follows from the labels and the layout. Nothing of it is in the plan before Commit.
  void FindHolesOf(const std::set<CellId>& area) {
    position_.clear();
    for (const RimPoint& p : rim_.points) position_.push_back(p.position);
    for (const Point2& p : layout_.vertices) position_.emplace_back(p.x(), p.y(), 0);
    boundary_.clear();
    found_.clear();
    chain_left_.clear();
    IndexRimEdges();
    RelabelAlongSeams();
    SortSegments();
    for (const CellId cell : area) FindHolesIn(cell);
  }

  // Seams that take rim vertices beside them may cede the last of a hole; then they keep to the grid line, where that
  // fails less often.
  void TrySeamsOffRim(const std::set<CellId>& area, const RimIndex& index, const std::vector<CellId>& labels) {
    const size_t failures = CountFailures();
    if (failures == 0) return;
    for (const bool over_rim : {false, true}) {
      options_.seams_over_rim = over_rim;
      SetLabels(labels);
      layout_ = LaySeamsOfLoops(area, index);
      FindHolesOf(area);
      if (CountFailures() < failures) return;
    }
  }

  // On a ragged cut the zigzag of a border can be read in more than one way, and the reading that labels gave may bound
  // no regions near grid corners. There, edges go back to their owners, ever farther around; the attempt with the
  // fewest failures stays.
  void TryOtherLabels(const std::set<CellId>& area, const RimIndex& index) {
    constexpr int kAttempts = 4;
    std::vector<Point2> trouble = Trouble();
    if (trouble.empty()) return;
    LabelEdges(input_, lines_, rim_);
    std::vector<CellId> labels = Labels(), best_labels = labels;
    size_t least = CountFailures();
    for (int attempt = 1; attempt <= kAttempts && !trouble.empty(); ++attempt) {
      SetLabels(labels);
      ResetLabelsNear(input_, trouble, 2 * attempt * index.mean_size(), rim_);
      labels = Labels();
      layout_ = LaySeamsOfLoops(area, index);
      FindHolesOf(area);
      trouble = Trouble();
      if (CountFailures() >= least) continue;
      least = CountFailures();
      best_labels = labels;
    }
    if (CountFailures() == least) return;
    SetLabels(best_labels);
    layout_ = LaySeamsOfLoops(area, index);
    FindHolesOf(area);
  }

  std::vector<CellId> Labels() const {
    std::vector<CellId> labels;
    for (const RimEdge& e : rim_.edges) labels.push_back(e.label);
    return labels;
  }

  void SetLabels(const std::vector<CellId>& labels) {
    for (size_t e = 0; e < labels.size(); ++e) rim_.edges[e].label = labels[e];
  }

  size_t CountFailures() const {
    size_t count = 0;
    for (const auto& [cell, found] : found_) {
      for (const PlannedHole& hole : found.holes) count += !hole.failure.empty();
    }
    return count;
  }

  // Where seams could not be laid, or end on the boundary of a hole that failed.
  std::vector<Point2> Trouble() const {
    std::vector<Point2> points = layout_.trouble;
    const auto rim = static_cast<int32_t>(rim_.points.size());
    for (const auto& [cell, found] : found_) {
      for (const PlannedHole& hole : found.holes) {
        if (hole.failure.empty()) continue;
        for (const RimSegment& s : hole.segments) {
          if (!s.seam) continue;
          for (const int32_t v : {s.from, s.to}) {
            if (v < rim) points.emplace_back(position_[v].head<2>());
          }
        }
      }
    }
    return points;
  }

  void Commit() {
    base_ = static_cast<int32_t>(plan_.vertices.size());
    for (auto& [cell, points] : rim_.point_of) {
      for (int32_t& p : points) p += base_;
      plan_.vertex_of_boundary[cell] = std::move(points);
    }
    for (const RimPoint& p : rim_.points) {
      plan_.vertices.push_back({p.tile, p.index, p.position, p.centroid_height, p.size, 0, false});
    }
    for (size_t i = 0; i < layout_.vertices.size(); ++i) {
      const Point3 p(layout_.vertices[i].x(), layout_.vertices[i].y(), 0);
      plan_.vertices.push_back({{}, -1, p, 0, layout_.sizes[i], layout_.lines[i], false});
      if (const int32_t beside = layout_.beside[i]; beside >= 0) {
        plan_.vertices.back().position.z() = rim_.points[beside].position.z();
        plan_.vertices.back().height_given = true;
      }
    }
    plan_.left.insert(plan_.left.end(), chain_left_.begin(), chain_left_.end());
    for (auto& [cell, found] : found_) StoreHoles(found);
    for (Seam& seam : layout_.seams) {
      for (int32_t& v : seam.vertices) v += base_;
      plan_.seams.push_back(std::move(seam));
    }
  }

  // Loops along unwelded pieces of the tile bound no region with seams: they are taken apart to chains.
  void ChainPieces(const RimIndex& index) {
    piece_border_ = FindPieceBorders(rim_, index, lines_.piece_reach);
    for (size_t l = 0; l < rim_.loops.size(); ++l) {
      chained_[l] =
          std::any_of(rim_.loops[l].begin(), rim_.loops[l].end(), [&](int32_t e) { return piece_border_[e] >= 0; });
    }
  }

  // Where inside and outside along the outline cannot be told apart, short runs off the outline are closed on their
  // own, and count as outline from then on.
  void CloseOneSidedRuns() {
    for (size_t l = 0; l < rim_.loops.size(); ++l) {
      if (chained_[l] || detached_[l]) continue;
      for (const std::vector<int32_t>& run : OneSidedRuns(rim_.loops[l], rim_, lines_, kLongestRun)) {
        const CellId cell = rim_.edges[run[0]].owner;
        CloseRun(run, cell);
        const RimPoint& p = rim_.points[rim_.edges[run[0]].from];
        const CellId label = NearestAcross(cell, p.position);
        for (const int32_t e : run) rim_.edges[e].label = label;
      }
    }
  }

  void CloseRun(const std::vector<int32_t>& run, CellId cell) {
    if (run.size() == 1) {
      plan_.left.push_back({cell, "a single edge off the tile's outline: it bounds no area", -1, 1});
      return;
    }
    std::vector<RimSegment> segments = Reversed(run);
    segments.push_back({segments.back().to, segments.front().from, true});
    boundary_[cell].closed_loops.push_back(std::move(segments));
  }

  CellId NearestAcross(CellId cell, const Point3& p) const {
    const auto distance = [&](Side side) { return std::abs(p[AxisOf(side)] - lines_.At(cell, side)); };
    return Across(cell, *std::min_element(kSides.begin(), kSides.end(),
                                          [&](Side a, Side b) { return distance(a) < distance(b); }));
  }

  // Where that does not help, loops that need no seam do without: those whose
  // chains each begin and end on one side.
  void ChainOneSided() {
    for (size_t l = 0; l < rim_.loops.size(); ++l) {
      if (chained_[l] || detached_[l] || !ReachesOutline(rim_.loops[l])) continue;
      chained_[l] = CloseChains(rim_.loops[l], rim_, lines_, piece_border_).open_runs.empty();
    }
  }

  bool ReachesOutline(const std::vector<int32_t>& loop) const {
    return std::any_of(loop.begin(), loop.end(), [&](int32_t e) { return rim_.edges[e].label != rim_.edges[e].owner; });
  }

  SeamLayout LaySeamsOfLoops(const std::set<CellId>& area, const RimIndex& index) const {
    if (std::find(chained_.begin(), chained_.end(), true) == chained_.end() &&
        std::find(detached_.begin(), detached_.end(), true) == detached_.end()) {
      return LaySeams(area, lines_, rim_, index, options_, plan_.lattice_step);
    }
    Rim rest = rim_;
    rest.loops.clear();
    for (size_t l = 0; l < rim_.loops.size(); ++l) {
      if (!chained_[l] && !detached_[l]) rest.loops.push_back(rim_.loops[l]);
    }
    return LaySeams(area, lines_, rest, index, options_, plan_.lattice_step);
  }

  void AddChains(const std::vector<int32_t>& loop) {
    OutlineChains chains = CloseChains(loop, rim_, lines_, piece_border_);
    auto& closed = boundary_[rim_.edges[loop[0]].owner].closed_loops;
    for (auto& segments : chains.loops) closed.push_back(std::move(segments));
    chain_left_.insert(chain_left_.end(), chains.left.begin(), chains.left.end());
    open_runs_.insert(open_runs_.end(), chains.open_runs.begin(), chains.open_runs.end());
  }

  void AddOpenRuns() {
    if (open_runs_.empty()) return;
    OutlineChains chains = LinkRuns(open_runs_, rim_, lines_);
    auto& closed = boundary_[rim_.edges[open_runs_[0][0]].owner].closed_loops;
    for (auto& segments : chains.loops) closed.push_back(std::move(segments));
    plan_.left.insert(plan_.left.end(), chains.left.begin(), chains.left.end());
  }

  // The edges as boundary segments: the hole lies to the right of a rim edge.
  std::vector<RimSegment> Reversed(const std::vector<int32_t>& edges) const {
    std::vector<RimSegment> segments;
    for (const int32_t e : edges) segments.push_back({rim_.edges[e].to, rim_.edges[e].from, false});
    std::reverse(segments.begin(), segments.end());
    return segments;
  }

  // Gives each cell its rim edges and seams.
  void SortSegments() {
    for (size_t l = 0; l < rim_.loops.size(); ++l) {
      const std::vector<int32_t>& loop = rim_.loops[l];
      if (chained_[l]) {
        AddChains(loop);
        continue;
      }
      const RimEdge& first = rim_.edges[loop[0]];
      const bool inside = detached_[l] || std::all_of(loop.begin(), loop.end(), [&](int32_t e) {
                            return rim_.edges[e].label == first.label && rim_.edges[e].owner == first.label;
                          });
      if (inside) {
        boundary_[first.owner].closed_loops.push_back(Reversed(loop));
        continue;
      }
      for (const int32_t e : loop) AddRimEdge(rim_.edges[e]);
    }
    AddOpenRuns();
    for (const Seam& seam : layout_.seams) AddSeam(seam);
  }

  void AddRimEdge(const RimEdge& e) {
    if (!input_.cells.contains(e.label)) return;
    BoundarySegment s{{e.to, e.from, false}, -1, e.owner};
    if (e.owner != e.label) s.side = SideTowards(e.label, e.owner, rim_.points[e.from].position);
    boundary_[e.label].open.push_back(s);
  }

  // The side of `cell` across which `other` lies; for a diagonal neighbour the nearer of the two sides between.
  int32_t SideTowards(CellId cell, CellId other, const Point3& p) const {
    int32_t best = kWest;
    double nearest = 1e300;
    for (const Side side : kSides) {
      const int32_t step = AxisOf(side) == 0 ? other.col - cell.col : other.row - cell.row;
      if (step * OutwardOf(side) <= 0) continue;
      const double d = std::abs(lines_.At(cell, side) - p[AxisOf(side)]);
      if (d < nearest) {
        nearest = d;
        best = side;
      }
    }
    return best;
  }

  void AddSeam(const Seam& seam) {
    const bool vertical = seam.a.row == seam.b.row;
    for (size_t i = 0; i + 1 < seam.vertices.size(); ++i) {
      const int32_t p = seam.vertices[i], q = seam.vertices[i + 1];
      if (IsRimEdge(p, q)) continue;
      // Going north along a vertical line, a (west) is on the left; going east along a horizontal one, b (north) is.
      const CellId left = vertical ? seam.a : seam.b, right = vertical ? seam.b : seam.a;
      if (input_.cells.contains(left)) boundary_[left].open.push_back({{p, q, true}, vertical ? kEast : kSouth, right});
      if (input_.cells.contains(right))
        boundary_[right].open.push_back({{q, p, true}, vertical ? kWest : kNorth, left});
    }
  }

  void IndexRimEdges() {
    rim_edges_.clear();
    for (size_t i = 0; i < rim_.edges.size(); ++i) {
      const RimEdge& e = rim_.edges[i];
      rim_edges_[{std::min(e.from, e.to), std::max(e.from, e.to)}] = static_cast<int32_t>(i);
    }
  }

  bool IsRimEdge(int32_t p, int32_t q) const { return rim_edges_.contains({std::min(p, q), std::max(p, q)}); }

  // Where a seam follows a rim edge, that edge bounds the cell on whose side of the seam the hole lies. Near a grid
  // corner several seams may follow one edge: each takes it from the cell on its one side to that on its other.
  void RelabelAlongSeams() {
    std::map<int32_t, std::vector<std::pair<CellId, CellId>>> passes;  // of each rim edge: from a cell, to a cell
    for (const Seam& seam : layout_.seams) {
      const bool vertical = seam.a.row == seam.b.row;
      const CellId left = vertical ? seam.a : seam.b, right = vertical ? seam.b : seam.a;
      for (size_t i = 0; i + 1 < seam.vertices.size(); ++i) {
        const int32_t p = seam.vertices[i], q = seam.vertices[i + 1];
        if (!IsRimEdge(p, q)) continue;
        const int32_t e = rim_edges_.at({std::min(p, q), std::max(p, q)});
        // The hole lies to the right of the edge.
        passes[e].push_back(rim_.edges[e].from == p ? std::pair(left, right) : std::pair(right, left));
      }
    }
    for (auto& [e, of_edge] : passes) {
      while (!of_edge.empty()) {
        const CellId label = rim_.edges[e].label;
        auto next = std::find_if(of_edge.begin(), of_edge.end(), [&](const auto& pass) { return pass.first == label; });
        if (next == of_edge.end()) next = of_edge.begin();
        if (input_.cells.contains(next->second) || LiesOnBorder(rim_.edges[e], next->first, next->second)) {
          rim_.edges[e].label = next->second;
        }
        of_edge.erase(next);
      }
    }
  }

  // Whether an edge lies on the line between a cell of the area and one outside it.
  bool LiesOnBorder(const RimEdge& e, CellId inside, CellId outside) const {
    if (!input_.cells.contains(inside)) return false;
    return std::any_of(kSides.begin(), kSides.end(), [&](Side side) {
      const auto on_line = [&](int32_t p) {
        return std::abs(rim_.points[p].position[AxisOf(side)] - lines_.At(inside, side)) <= kOnLine;
      };
      return Across(inside, side) == outside && on_line(e.from) && on_line(e.to);
    });
  }

  void FindHolesIn(CellId cell) {
    const auto it = boundary_.find(cell);
    if (it == boundary_.end()) return;
    CellBoundary& boundary = it->second;
    boundary.cell = cell;
    for (const LeftOpen& failure : layout_.failures) {
      if (failure.cell == cell && boundary.seam_failure.empty()) boundary.seam_failure = failure.reason;
    }
    const SurveyRecord* record = input_.cells.at(cell);
    boundary.has_surface = record != nullptr && record->triangle_count > 0;
    found_[cell] = FindHoles(boundary, scene_area_, lines_, rim_, position_);
  }

  void StoreHoles(RegionResult& found) {
    for (PlannedHole& hole : found.holes) {
      for (RimSegment& s : hole.segments) {
        s.from += base_;
        s.to += base_;
      }
      plan_.holes.push_back(std::move(hole));
    }
    // A single mesh ends somewhere: its outlines are nothing to report.
    if (input_.has_grid) plan_.left.insert(plan_.left.end(), found.left.begin(), found.left.end());
    plan_.outer_rims += found.outer_rims;
  }

  void LeaveUnlinked() {
    std::map<CellId, int64_t> count;
    for (const int32_t e : rim_.unlinked) ++count[rim_.edges[e].owner];
    for (const auto& [cell, edges] : count) {
      plan_.left.push_back(
          {cell, "boundary edges that close to no loop: the surface is not manifold there", -1, edges});
    }
  }

  const PlanInput& input_;
  const std::set<CellId>& scene_area_;
  const CutLines& lines_;
  PlanOptions options_;
  Plan& plan_;
  Rim rim_;
  SeamLayout layout_;
  int32_t base_ = 0;
  std::vector<Point3> position_;
  std::map<CellId, CellBoundary> boundary_;
  std::map<CellId, RegionResult> found_;
  std::vector<LeftOpen> chain_left_;
  std::vector<bool> detached_;  // per loop, of independent tiles: the outline of a small piece
  std::vector<bool> chained_;   // per loop
  std::vector<std::vector<int32_t>> open_runs_;
  std::vector<double> piece_border_;  // of independent tiles: see FindPieceBorders
  std::map<std::pair<int32_t, int32_t>, int32_t> rim_edges_;
};

uint64_t Key(int32_t from, int32_t to) {
  return static_cast<uint64_t>(static_cast<uint32_t>(from)) << 32 | static_cast<uint32_t>(to);
}

// Pairs of holes on the two sides of one seam segment.
std::vector<std::pair<int32_t, int32_t>> HolesThatTouch(const Plan& plan) {
  std::unordered_map<uint64_t, int32_t> hole_of;
  for (size_t h = 0; h < plan.holes.size(); ++h) {
    if (!plan.holes[h].failure.empty()) continue;
    for (const RimSegment& s : plan.holes[h].segments) {
      if (s.seam) hole_of[Key(s.from, s.to)] = static_cast<int32_t>(h);
    }
  }
  std::set<std::pair<int32_t, int32_t>> pairs;
  for (const auto& [key, hole] : hole_of) {
    const auto other = hole_of.find(key << 32 | key >> 32);
    if (other != hole_of.end() && other->second != hole) {
      pairs.insert({std::min(hole, other->second), std::max(hole, other->second)});
    }
  }
  return {pairs.begin(), pairs.end()};
}

// Pairs of holes whose seams lie along one border, each on its own tile's outline, and overlap along it.
std::vector<std::pair<int32_t, int32_t>> HolesThatFace(const Plan& plan) {
  struct Stretch {
    double lo, hi;
    int32_t hole;
  };
  std::map<std::pair<CellId, CellId>, std::vector<Stretch>> along;
  std::unordered_map<uint64_t, int32_t> hole_of;
  for (size_t h = 0; h < plan.holes.size(); ++h) {
    if (!plan.holes[h].failure.empty()) continue;
    for (const RimSegment& s : plan.holes[h].segments) {
      if (s.seam) hole_of[Key(std::min(s.from, s.to), std::max(s.from, s.to))] = static_cast<int32_t>(h);
    }
  }
  for (const Seam& seam : plan.seams) {
    const int axis = seam.a.row == seam.b.row ? 1 : 0;
    const auto hole =
        hole_of.find(Key(std::min(seam.vertices[0], seam.vertices[1]), std::max(seam.vertices[0], seam.vertices[1])));
    if (hole == hole_of.end()) continue;
    along[{seam.a, seam.b}].push_back({plan.vertices[seam.vertices.front()].position[axis],
                                       plan.vertices[seam.vertices.back()].position[axis], hole->second});
  }
  std::set<std::pair<int32_t, int32_t>> pairs;
  for (const auto& [border, stretches] : along) {
    for (size_t i = 0; i < stretches.size(); ++i) {
      for (size_t j = i + 1; j < stretches.size(); ++j) {
        if (stretches[i].hole != stretches[j].hole && stretches[i].lo < stretches[j].hi &&
            stretches[j].lo < stretches[i].hi) {
          pairs.insert(std::minmax(stretches[i].hole, stretches[j].hole));
        }
      }
    }
  }
  return {pairs.begin(), pairs.end()};
}

void StoreLayers(bool independent, Plan& plan) {
  std::vector<bool> open, outermost;
  for (const PlannedHole& hole : plan.holes) {
    open.push_back(hole.kind != HoleKind::kClosed && hole.failure.empty());
    outermost.push_back(hole.boundary_vertices > 0);
  }
  const auto touching = independent ? HolesThatFace(plan) : HolesThatTouch(plan);
  const Layering layering = LayerHoles(open, outermost, touching);
  plan.clusters = layering.clusters;
  plan.layers = layering.layers;
  for (size_t h = 0; h < plan.holes.size(); ++h) {
    plan.holes[h].cluster = layering.cluster[h];
    plan.holes[h].layer = layering.layer[h];
  }
}

void LeaveFailedHoles(Plan& plan) {
  for (size_t h = 0; h < plan.holes.size(); ++h) {
    const PlannedHole& hole = plan.holes[h];
    if (hole.failure.empty()) continue;
    plan.left.push_back({hole.cell, hole.failure, static_cast<int32_t>(h), hole.boundary_vertices});
  }
}

}  // namespace

Plan MakePlan(const PlanInput& input, const PlanOptions& options) {
  Plan plan;
  plan.lattice_step = LatticeStep(input);
  const CutLines lines = FindCutLines(input, plan.lattice_step);
  plan.borders = lines.borders;
  std::set<CellId> area;
  for (const auto& [cell, record] : input.cells) area.insert(cell);
  if (lines.independent) {
    for (const auto& [cell, record] : input.cells) {
      PlanInput one = input;
      one.cells = {{cell, record}};
      PartPlanner(one, area, lines, options, plan).Run();
    }
  } else {
    PartPlanner(input, area, lines, options, plan).Run();
  }
  plan.tiles_apart = lines.independent;
  StoreLayers(lines.independent, plan);
  LeaveFailedHoles(plan);
  FindWater(input, options.water, plan);
  return plan;
}

}  // namespace tilemend
