#include "coordinator/plan/overlap/own_regions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

namespace tilemend {
namespace {

constexpr double kOnOutline = 2e-3;   // metres: a vertex this near the tile's outline is where a chain ends
constexpr double kClearance = 0.25;   // of its size: a new vertex is not nearer to the end of a chain
constexpr size_t kLongestWay = 1000;  // edges from where a chain was cut to its end

bool TurnsUp(Side side) { return side == kEast || side == kSouth; }

// The regions of one cell.
class CellRegions {
 public:
  CellRegions(CellId cell, const SurveyRecord* record, const GridLines& own, const JointTiles& joint, Plan& plan)
      : cell_(cell), record_(record), own_(own), square_(joint.squares.at(cell)), plan_(plan) {
    if (record_ == nullptr) return;
    const std::vector<int32_t>& of = plan_.vertex_of_boundary.at(cell);
    for (size_t v = 0; v < record_->vertices.size(); ++v) own_vertex_.emplace(of[v], static_cast<int32_t>(v));
    const std::vector<int32_t>& edges = joint.crossing_edge.at(cell);
    for (size_t k = 0; k < edges.size(); ++k) {
      if (edges[k] >= 0) crossing_.emplace(of[record_->vertices.size() + k], edges[k]);
    }
    for (size_t e = 0; e < record_->edges.size(); ++e) {
      leaving_.emplace(record_->edges[e].from, static_cast<int32_t>(e));
      arriving_.emplace(record_->edges[e].to, static_cast<int32_t>(e));
    }
  }

  // A closed hole has a region of its own only where its tile was cut for the plan.
  void Lay(PlannedHole& hole) {
    const bool whole = std::all_of(hole.segments.begin(), hole.segments.end(),
                                   [&](const RimSegment& s) { return IsInside(s.from) && IsInside(s.to); });
    if (whole && hole.kind == HoleKind::kClosed) return;
    region_.clear();
    std::multimap<int32_t, size_t> from;  // segments that are not all of the tile, by their first vertex
    std::vector<size_t> starts;
    for (size_t i = 0; i < hole.segments.size(); ++i) {
      const RimSegment& s = hole.segments[i];
      if (IsInside(s.from) && IsInside(s.to)) {
        region_.push_back(s);
        continue;
      }
      from.emplace(s.from, i);
      if (IsInside(s.from)) starts.push_back(i);
      if (EdgeThrough(s) >= 0) starts.push_back(i);
    }
    for (const size_t start : starts) LayRun(hole, start, from);
    // Those have served as beginnings and ends of runs.
    std::erase_if(from, [&](const auto& s) { return EdgeThrough(hole.segments[s.second]) >= 0; });
    while (!from.empty()) LayCycle(hole, from);
    hole.own_regions = {std::move(region_)};
  }

 private:
  using Segments = std::multimap<int32_t, size_t>;

  bool IsInside(int32_t v) const { return own_vertex_.contains(v) && !crossing_.contains(v); }

  // The edge that crosses the square from side to side, of which the segment is the part inside; -1: none.
  int32_t EdgeThrough(const RimSegment& s) const {
    const auto [begin, end] = crossing_.equal_range(s.from);
    for (auto a = begin; a != end; ++a) {
      const auto [first, last] = crossing_.equal_range(s.to);
      if (!s.seam && std::any_of(first, last, [&](const auto& b) { return b.second == a->second; })) return a->second;
    }
    return -1;
  }

  // From an inner vertex, or from where an edge has crossed the square, along a grid line to the next such place.
  void LayRun(const PlannedHole& hole, size_t start, Segments& from) {
    const RimSegment first = hole.segments[start];
    const int32_t through = EdgeThrough(first);
    if (through < 0) Take(first.from, start, from);
    std::vector<int32_t> ahead;  // of the tile's record, from the last inner vertex out
    if (through >= 0) {
      const BoundaryEdge& e = record_->edges[through];
      AddRim(PlanVertexOf(e.to), PlanVertexOf(e.from));
      ahead = {e.from};
      Extend(ahead, false);
    } else {
      ahead = WayOut(first);
    }
    std::vector<int32_t> run = {first.to};
    RimSegment last = first;
    while (!IsInside(run.back())) {
      const auto next = from.find(run.back());
      if (next == from.end()) break;
      last = hole.segments[next->second];
      if (EdgeThrough(last) >= 0) break;
      from.erase(next);
      run.push_back(last.to);
    }
    std::vector<int32_t> behind;  // from the next inner vertex out
    if (IsInside(run.back())) {
      run.pop_back();
      behind = WayIn(last);
    } else if (const int32_t e = EdgeThrough(last); e >= 0 && run.back() != first.to) {
      behind = {record_->edges[e].to};
      Extend(behind, true);
    }
    Join(ahead, run, behind);
  }

  static void Take(int32_t vertex, size_t segment, Segments& from) {
    const auto [begin, end] = from.equal_range(vertex);
    const auto it = std::find_if(begin, end, [&](const auto& s) { return s.second == segment; });
    if (it != end) from.erase(it);
  }

  // A loop with no vertex of the tile: new vertices all around.
  void LayCycle(const PlannedHole& hole, Segments& from) {
    std::vector<int32_t> run;
    for (auto it = from.begin(); it != from.end(); it = from.find(run.back())) {
      run.push_back(hole.segments[it->second].to);
      from.erase(it);
    }
    std::vector<int32_t> loop;
    for (const int32_t v : run) loop.push_back(Follower(v));
    for (size_t i = 0; i < loop.size(); ++i) region_.push_back({loop[i], loop[(i + 1) % loop.size()], true});
  }

  int32_t PlanVertexOf(int32_t own) const { return plan_.vertex_of_boundary.at(cell_)[own]; }
  const Point3& At(int32_t own) const { return record_->vertices[own].position; }

  // The vertices from an inner one to where its chain ends, against the chain's direction; the hole lies to the left.
  std::vector<int32_t> WayOut(const RimSegment& s) const {
    std::vector<int32_t> way = {own_vertex_.at(s.from)};
    const auto [begin, end] = crossing_.equal_range(s.to);
    for (auto c = begin; c != end; ++c) {
      const BoundaryEdge& e = record_->edges[c->second];
      if (e.to != way[0]) continue;
      way.push_back(e.from);
      Extend(way, false);
      break;
    }
    return way;
  }

  std::vector<int32_t> WayIn(const RimSegment& s) const {
    std::vector<int32_t> way = {own_vertex_.at(s.to)};
    const auto [begin, end] = crossing_.equal_range(s.from);
    for (auto c = begin; c != end; ++c) {
      const BoundaryEdge& e = record_->edges[c->second];
      if (e.from != way[0]) continue;
      way.push_back(e.to);
      Extend(way, true);
      break;
    }
    return way;
  }

  // Goes on along the chain to the tile's outline. A chain that turns back before it is cut where it comes nearest.
  void Extend(std::vector<int32_t>& way, bool forward) const {
    const auto& links = forward ? leaving_ : arriving_;
    while (way.size() < kLongestWay && !OnOutline(At(way.back()))) {
      const auto link = links.find(way.back());
      if (link == links.end()) break;
      const BoundaryEdge& e = record_->edges[link->second];
      const int32_t next = forward ? e.to : e.from;
      if (square_.Contains(At(next))) {
        const auto farthest = std::max_element(way.begin(), way.end(),
                                               [&](int32_t a, int32_t b) { return Outside(At(a)) < Outside(At(b)); });
        way.erase(farthest + 1, way.end());
        return;
      }
      way.push_back(next);
    }
  }

  double Outside(const Point3& p) const {
    double most = -1e300;
    for (const Side s : kSides) most = std::max(most, (p[AxisOf(s)] - square_.cut[s]) * OutwardOf(s));
    return most;
  }

  bool OnOutline(const Point3& p) const {
    return std::any_of(kSides.begin(), kSides.end(),
                       [&](Side s) { return (p[AxisOf(s)] - own_.At(cell_, s)) * OutwardOf(s) >= -kOnOutline; });
  }

  // A chain, new vertices along the outline, and the next chain.
  void Join(const std::vector<int32_t>& ahead, const std::vector<int32_t>& run, const std::vector<int32_t>& behind) {
    std::vector<int32_t> way;
    for (const int32_t v : ahead) way.push_back(PlanVertexOf(v));
    for (size_t i = 0; i + 1 < way.size(); ++i) AddRim(way[i], way[i + 1]);
    std::vector<int32_t> back;
    for (auto v = behind.rbegin(); v != behind.rend(); ++v) back.push_back(PlanVertexOf(*v));
    for (size_t i = 0; i + 1 < back.size(); ++i) AddRim(back[i], back[i + 1]);
    if (way.empty() || back.empty() || way.back() == back.front()) return;
    std::vector<int32_t> seam = {way.back()};
    for (const int32_t v : Between(run, way.back(), back.front())) seam.push_back(Follower(v));
    seam.push_back(back.front());
    for (size_t i = 0; i + 1 < seam.size(); ++i) region_.push_back({seam[i], seam[i + 1], true});
    Follow(seam.front(), run.front());
    Follow(seam.back(), run.back());
  }

  void AddRim(int32_t a, int32_t b) {
    region_.push_back({a, b, false});
    const double length = (plan_.vertices[b].position - plan_.vertices[a].position).norm();
    for (const int32_t v : {a, b}) {
      if (!square_.Contains(plan_.vertices[v].position)) {
        plan_.vertices[v].size = std::max(plan_.vertices[v].size, length);
      }
    }
  }

  void Follow(int32_t end, int32_t source) {
    if (plan_.vertices[end].index >= 0 && plan_.vertices[end].follows < 0) plan_.vertices[end].follows = source;
  }

  // The sides of the square that a vertex lies on.
  std::vector<Side> SidesOf(int32_t v) const {
    std::vector<Side> sides;
    for (const Side s : kSides) {
      if (plan_.vertices[v].position[AxisOf(s)] == square_.side[s]) sides.push_back(s);
    }
    return sides;
  }

  // The vertices of a run that lie between the ends of two chains.
  std::vector<int32_t> Between(const std::vector<int32_t>& run, int32_t first, int32_t last) const {
    std::vector<size_t> corners;
    for (size_t i = 0; i < run.size(); ++i) {
      if (SidesOf(run[i]).size() == 2) corners.push_back(i);
    }
    std::vector<int32_t> between;
    for (size_t i = 0; i < run.size(); ++i) {
      const std::vector<Side> sides = SidesOf(run[i]);
      if (sides.empty() || crossing_.contains(run[i])) continue;
      const bool from_first = corners.empty() || i < corners.front(), to_last = corners.empty() || i > corners.back();
      if (sides.size() == 1 && from_first && !IsPast(run[i], first, sides[0])) continue;
      if (sides.size() == 1 && to_last && !IsPast(last, run[i], sides[0])) continue;
      between.push_back(run[i]);
    }
    return between;
  }

  // Whether b lies behind a along a side, with the hole on the left, and clear of it.
  bool IsPast(int32_t b, int32_t a, Side side) const {
    const int along = 1 - AxisOf(side);
    const double way =
        (plan_.vertices[b].position[along] - plan_.vertices[a].position[along]) * (TurnsUp(side) ? 1 : -1);
    return way > kClearance * std::min(plan_.vertices[a].size, plan_.vertices[b].size);
  }

  // A new vertex on the tile's outline beside one on the grid line.
  int32_t Follower(int32_t source) {
    const auto [it, fresh] = follower_.try_emplace(source, static_cast<int32_t>(plan_.vertices.size()));
    if (!fresh) return it->second;
    PlanVertex v = plan_.vertices[source];
    v.tile = cell_;
    v.index = -1;
    v.follows = source;
    v.lines = 0;
    for (const Side s : SidesOf(source)) {
      v.position[AxisOf(s)] = own_.At(cell_, s);
      v.lines |= AxisOf(s) == 0 ? 1 : 2;
    }
    plan_.vertices.push_back(v);
    return it->second;
  }

  const CellId cell_;
  const SurveyRecord* record_;
  const GridLines& own_;
  const ClipSquare& square_;
  Plan& plan_;
  std::unordered_map<int32_t, int32_t> own_vertex_;  // plan vertex -> of the record
  std::multimap<int32_t, int32_t> crossing_;         // plan vertex -> edge of the record that crosses the line there
  std::unordered_multimap<int32_t, int32_t> leaving_, arriving_;  // vertex of the record -> edges
  std::unordered_map<int32_t, int32_t> follower_;                 // plan vertex on the grid line -> on the outline
  std::vector<RimSegment> region_;
};

}  // namespace

void LayOwnRegions(const TileParts& parts, const JointTiles& joint, Plan& plan) {
  const PlanInput& input = parts.input;
  std::map<CellId, std::vector<size_t>> holes;
  for (size_t h = 0; h < plan.holes.size(); ++h) {
    if (plan.holes[h].failure.empty()) holes[plan.holes[h].cell].push_back(h);
  }
  for (const auto& [cell, of_cell] : holes) {
    CellRegions regions(cell, input.cells.at(cell), parts.own, joint, plan);
    for (const size_t h : of_cell) regions.Lay(plan.holes[h]);
  }
  for (auto& [cell, vertices] : plan.vertex_of_boundary) {
    if (const SurveyRecord* record = input.cells.at(cell)) vertices.resize(record->vertices.size());
  }
}

}  // namespace tilemend
