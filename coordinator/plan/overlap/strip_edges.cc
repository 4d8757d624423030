#include "coordinator/plan/overlap/strip_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "common/mesh/exact_signs.h"
#include "common/mesh/rounding.h"
#include "common/mesh/segment_distance.h"

namespace tilemend {
namespace {

constexpr double kRimClearance = 0.125;  // of its size: a new vertex is not nearer to the rim
constexpr double kLeastLineSteps = 4;    // of the lattice: lines nearer to each other count as one
constexpr uint8_t kCornerLines = 3;

// A straight way.
struct Way {
  Point2 from, to;
};

bool Cross(const Way& way, const Point2& a, const Point2& b) {
  return TurnOf(way.from, way.to, a) * TurnOf(way.from, way.to, b) < 0 &&
         TurnOf(a, b, way.from) * TurnOf(a, b, way.to) <= 0;
}

// The segments of a cell's holes on its tile's outline, by Side.
using OutlineSegments = std::array<std::vector<RimSegment>, 4>;

// Vertices of neighbours as those of a hole, by place; none: it takes no such vertex.
using Copies = std::map<std::pair<double, double>, std::optional<int32_t>>;

// Those on an edge along an axis, on the way from a to b, not within `room` of its ends.
std::vector<int32_t> CopiesBetween(const Copies& copies, const Point2& a, const Point2& b, double room) {
  const Point2 way = b - a;
  if (way.cwiseAbs().minCoeff() > kOnLine) return {};
  std::map<double, int32_t> between;  // by how far along
  for (const auto& [place, copy] : copies) {
    const Point2 off = Point2(place.first, place.second) - a;
    const double along = off.dot(way) / way.norm();
    if (!copy || along < room || along > way.norm() - room) continue;
    if ((off - along * way.normalized()).norm() < kOnLine) between.emplace(along, *copy);
  }
  std::vector<int32_t> found;
  for (const auto& [along, copy] : between) found.push_back(copy);
  return found;
}

class StripLayer {
 public:
  StripLayer(const GridLines& outlines, Plan& plan, PlannedHole& hole) : plan_(plan), hole_(hole) {
    for (const Side side : kSides) {
      own_[side] = outlines.At(hole.cell, side);
      const auto across = outlines.coordinate.find(Across(hole.cell, side));
      if (across == outlines.coordinate.end()) continue;
      const double theirs = across->second[Opposite(side)];
      const double width = (own_[side] - theirs) * OutwardOf(side);
      if (width > kLeastLineSteps * plan.lattice_step) strip_end_[side] = theirs;
    }
  }

  // Puts new vertices on the outline beside its corners, where the neighbours' outlines cross it.
  void LayCorners() {
    for (std::vector<RimSegment>& region : hole_.own_regions) LayCorners(region);
  }

  void CollectOutline(OutlineSegments& segments) const {
    for (const std::vector<RimSegment>& region : hole_.own_regions) {
      for (const RimSegment& s : region) {
        for (const Side side : kSides) {
          if (s.seam && RunsAlong(s, side)) segments[side].push_back(s);
        }
      }
    }
  }

  void LayEdges(const std::map<CellId, OutlineSegments>& of_cells) {
    for (std::vector<RimSegment>& region : hole_.own_regions) {
      for (const Side side : kSides) {
        const auto neighbour = of_cells.find(Across(hole_.cell, side));
        if (strip_end_[side] && neighbour != of_cells.end()) {
          LaySide(region, side, neighbour->second[Opposite(side)]);
        }
      }
      for (const Side side : kSides) LayLastEdges(region, side);
    }
    SplitEdges();
  }

 private:
  void LayCorners(std::vector<RimSegment>& region) {
    std::vector<RimSegment> result;
    for (const RimSegment& s : region) {
      const std::optional<int32_t> middle = s.seam ? CrossingOn(s) : std::nullopt;
      if (!middle) {
        result.push_back(s);
        continue;
      }
      result.push_back({s.from, *middle, true});
      result.push_back({*middle, s.to, true});
    }
    region = std::move(result);
  }

  std::optional<int32_t> CrossingOn(const RimSegment& s) {
    for (const auto& [corner, other] : {std::pair(s.from, s.to), std::pair(s.to, s.from)}) {
      const PlanVertex& vertex = plan_.vertices[corner];
      if (vertex.index >= 0 || vertex.follows < 0 || plan_.vertices[vertex.follows].lines != kCornerLines) continue;
      for (const Side side : kSides) {
        const int axis = AxisOf(side);
        if (!strip_end_[side] || At(corner, axis) != own_[side] || !RunsAlongAxis(s, axis)) continue;
        if ((*strip_end_[side] - At(other, axis)) * OutwardOf(side) < Least()) continue;
        const int32_t crossing = AddVertex(corner, axis, *strip_end_[side]);
        copies_.emplace(std::pair(At(crossing, 0), At(crossing, 1)), crossing);
        return crossing;
      }
    }
    return std::nullopt;
  }

  // The neighbour's outline on this side, as far as it runs through the hole.
  void LaySide(const std::vector<RimSegment>& region, Side side, const std::vector<RimSegment>& neighbours) {
    std::vector<RimSegment> own;
    for (const RimSegment& s : region) {
      if (s.seam && RunsAlong(s, side)) own.push_back(s);
    }
    const std::vector<RimSegment> rim = RimAlong(region, side);
    for (const RimSegment& s : neighbours) {
      const std::optional<int32_t> from = CopyOf(s.from, side, own, rim), to = CopyOf(s.to, side, own, rim);
      if (!from || !to) continue;
      const double clearance = std::min(ClearanceAt(*from), ClearanceAt(*to));
      if (IsClear({PlaceOf(*from), PlaceOf(*to)}, rim, clearance)) AddEdge(*from, *to);
    }
    for (const RimSegment& s : own) {
      const std::optional<int32_t> from = CopyBeside(s.from, side), to = CopyBeside(s.to, side);
      if (!from || !to || !edges_.contains(std::minmax(*from, *to))) continue;
      const auto [a, b] = DiagonalOf({s.from, s.to, *from, *to});
      if (IsClear({PlaceOf(a), PlaceOf(b)}, rim, 0)) AddEdge(a, b);
    }
  }

  // Beside the rim an outline may go on from the last way straight across to a vertex that the other has nothing level
  // with. The strip has a diagonal up to there and a last edge across, in both tiles.
  void LayLastEdges(const std::vector<RimSegment>& region, Side side) {
    if (!strip_end_[side]) return;
    const std::vector<RimSegment> rim = RimAlong(region, side);
    for (const RimSegment& s : region) {
      if (!s.seam || !RunsAlong(s, side)) continue;
      for (const auto& [level, last] : {std::pair(s.from, s.to), std::pair(s.to, s.from)}) {
        const std::optional<int32_t> across = CopyBeside(level, side);
        if (!across || CopyBeside(last, side)) continue;
        const std::optional<int32_t> other_last = NextAcross(*across, side, last);
        if (!other_last) continue;
        const bool own_first = SumAt(level) < SumAt(*across);  // so that both tiles choose the same
        const int32_t from = own_first ? level : *across, to = own_first ? *other_last : last;
        if (IsFree(from, to, rim)) AddEdge(from, to);
        if (IsFree(last, *other_last, rim)) AddEdge(last, *other_last);
      }
    }
  }

  // Where the neighbour's outline goes on from one of its vertices, as one goes from there to `end`.
  std::optional<int32_t> NextAcross(int32_t from, Side side, int32_t end) const {
    const int along = 1 - AxisOf(side);
    const double way = At(end, along) - At(from, along);
    for (const auto& [a, b] : edges_) {
      if (a != from && b != from) continue;
      const int32_t to = a == from ? b : a;
      const bool on_outline = std::abs(At(to, 1 - along) - *strip_end_[side]) < kOnLine;
      if (on_outline && (At(to, along) - At(from, along)) * way > 0) return to;
    }
    return std::nullopt;
  }

  // Whether an edge meets neither the rim nor an edge that is there, but at its ends.
  bool IsFree(int32_t a, int32_t b, const std::vector<RimSegment>& rim) const {
    const Way way{PlaceOf(a), PlaceOf(b)};
    return IsClear(way, rim, 0) && std::none_of(edges_.begin(), edges_.end(), [&](const auto& e) {
             return Cross(way, PlaceOf(e.first), PlaceOf(e.second)) ||
                    Cross({PlaceOf(e.first), PlaceOf(e.second)}, way.from, way.to);
           });
  }

  static void SetKnown(PlanVertex& vertex) {
    vertex.index = -1;
    vertex.follows = -1;
    vertex.lines = 0;
    vertex.height_known = true;
  }

  // From the south-western corner of the strip between two ways across it to the north-eastern one: in both tiles.
  std::pair<int32_t, int32_t> DiagonalOf(const std::array<int32_t, 4>& corners) const {
    const auto [low, high] =
        std::minmax_element(corners.begin(), corners.end(), [&](int32_t a, int32_t b) { return SumAt(a) < SumAt(b); });
    return {*low, *high};
  }

  void AddEdge(int32_t a, int32_t b) {
    if (edges_.insert(std::minmax(a, b)).second) hole_.inner_edges.push_back({a, b, true});
  }

  // At a corner of the grid the outline of one neighbour may have no vertex where that of another crosses it.
  void SplitEdges() {
    std::vector<RimSegment> result;
    std::set<std::pair<int32_t, int32_t>> known;
    const auto add = [&](int32_t a, int32_t b) {
      if (known.insert(std::minmax(a, b)).second) result.push_back({a, b, true});
    };
    for (const RimSegment& edge : hole_.inner_edges) {
      int32_t last = edge.from;
      for (const int32_t v : CopiesBetween(copies_, PlaceOf(edge.from), PlaceOf(edge.to), Least())) {
        add(last, v);
        last = v;
      }
      add(last, edge.to);
    }
    hole_.inner_edges = std::move(result);
  }

  // A neighbour's vertex as one of this hole; none where it is outside, too near to the rim, or on an object.
  std::optional<int32_t> CopyOf(int32_t v, Side side, const std::vector<RimSegment>& own,
                                const std::vector<RimSegment>& rim) {
    PlanVertex vertex = plan_.vertices[v];
    vertex.position[AxisOf(side)] = *strip_end_[side];
    const Point2 place = vertex.position.head<2>();
    if (const auto it = CopyAt(place); it != copies_.end()) return it->second;
    std::optional<int32_t>& copy = copies_[{place.x(), place.y()}];
    if (vertex.on_object || !IsInside(place, 1 - AxisOf(side)) || !IsInHole(place, side, own, rim)) return copy;
    if (!IsClear({place, place}, rim, ClearanceAt(v))) return copy;
    if (vertex.index >= 0) SetKnown(vertex);
    vertex.tile = hole_.cell;
    plan_.vertices.push_back(vertex);
    return copy = static_cast<int32_t>(plan_.vertices.size()) - 1;
  }

  // That straight across the strip from one of the outline.
  std::optional<int32_t> CopyBeside(int32_t v, Side side) const {
    Point2 place = PlaceOf(v);
    place[AxisOf(side)] = *strip_end_[side];
    const auto it = CopyAt(place);
    return it == copies_.end() ? std::nullopt : it->second;
  }

  // Within a hair: outlines that go on one another do so only nearly.
  Copies::const_iterator CopyAt(const Point2& place) const {
    auto it = copies_.lower_bound({place.x() - kOnLine, place.y()});
    while (it != copies_.end() && it->first.first <= place.x() + kOnLine) {
      if (std::abs(it->first.second - place.y()) < kOnLine) return it;
      ++it;
    }
    return copies_.end();
  }

  // By the boundary between there and the outline, straight across the strip.
  bool IsInHole(const Point2& place, Side side, const std::vector<RimSegment>& own,
                const std::vector<RimSegment>& rim) const {
    const int axis = AxisOf(side);
    bool inside = false;
    for (const std::vector<RimSegment>* const segments : {&own, &rim}) {
      for (const RimSegment& s : *segments) {
        const Point2 a = PlaceOf(s.from), b = PlaceOf(s.to);
        if ((a[1 - axis] < place[1 - axis]) == (b[1 - axis] < place[1 - axis])) continue;
        const double share = (place[1 - axis] - a[1 - axis]) / (b[1 - axis] - a[1 - axis]);
        if ((a[axis] + share * (b[axis] - a[axis]) - place[axis]) * OutwardOf(side) > 0) inside = !inside;
      }
    }
    return inside;
  }

  int32_t AddVertex(int32_t like, int axis, double at) {
    PlanVertex vertex = plan_.vertices[like];
    vertex.position[axis] = at;
    plan_.vertices.push_back(vertex);
    return static_cast<int32_t>(plan_.vertices.size()) - 1;
  }

  // The segments off the outline that come near the strip.
  std::vector<RimSegment> RimAlong(const std::vector<RimSegment>& region, Side side) const {
    const int axis = AxisOf(side);
    double reach = 0;
    for (const RimSegment& s : region) {
      if (At(s.from, axis) == own_[side]) reach = std::max(reach, ClearanceAt(s.from));
    }
    const auto [low, high] = std::minmax(own_[side], *strip_end_[side]);
    std::vector<RimSegment> rim;
    for (const RimSegment& s : region) {
      const auto [least, most] = std::minmax({At(s.from, axis), At(s.to, axis)});
      const bool near = most > low - reach && least < high + reach;
      if (near && !RunsAlongAxis(s, 0) && !RunsAlongAxis(s, 1)) rim.push_back(s);
    }
    return rim;
  }

  bool RunsAlong(const RimSegment& s, Side side) const {
    const auto is_on = [&](int32_t v) { return std::abs(At(v, AxisOf(side)) - own_[side]) < kOnLine; };
    return is_on(s.from) && is_on(s.to);
  }

  bool RunsAlongAxis(const RimSegment& s, int axis) const {
    return std::any_of(kSides.begin(), kSides.end(),
                       [&](Side side) { return AxisOf(side) != axis && RunsAlong(s, side); });
  }

  // On `axis`, off the strips along the sides across it, or at the very end of one.
  bool IsInside(const Point2& p, int axis) const {
    return std::all_of(kSides.begin(), kSides.end(), [&](Side side) {
      if (AxisOf(side) != axis) return true;
      const double end = strip_end_[side].value_or(own_[side]), room = (end - p[axis]) * OutwardOf(side);
      return room >= Least() || (strip_end_[side] && std::abs(room) < kOnLine);
    });
  }

  bool IsClear(const Way& way, const std::vector<RimSegment>& rim, double clearance) const {
    return std::all_of(rim.begin(), rim.end(), [&](const RimSegment& s) {
      const Point2 a = PlaceOf(s.from), b = PlaceOf(s.to);
      return !Cross(way, a, b) && DistanceToSegment(way.from, a, b) >= clearance &&
             DistanceToSegment(way.to, a, b) >= clearance && DistanceToSegment(a, way.from, way.to) >= clearance &&
             DistanceToSegment(b, way.from, way.to) >= clearance;
    });
  }

  double At(int32_t v, int axis) const { return plan_.vertices[v].position[axis]; }
  double SumAt(int32_t v) const { return At(v, 0) + At(v, 1); }
  Point2 PlaceOf(int32_t v) const { return plan_.vertices[v].position.head<2>(); }
  double ClearanceAt(int32_t v) const { return kRimClearance * plan_.vertices[v].size; }
  double Least() const { return kLeastLineSteps * plan_.lattice_step; }

  Plan& plan_;
  PlannedHole& hole_;
  std::array<double, 4> own_{};                       // the tile's outline, by Side
  std::array<std::optional<double>, 4> strip_end_{};  // its neighbour's there, as far as they overlap
  Copies copies_;                                     // of neighbours' vertices, by place
  std::set<std::pair<int32_t, int32_t>> edges_;
};

}  // namespace

void LayStripEdges(const GridLines& outlines, Plan& plan) {
  std::vector<StripLayer> layers;
  std::map<CellId, OutlineSegments> of_cells;
  for (PlannedHole& hole : plan.holes) {
    if (hole.water >= 0 || hole.own_regions.empty()) continue;
    layers.emplace_back(outlines, plan, hole);
    layers.back().LayCorners();
    layers.back().CollectOutline(of_cells[hole.cell]);
  }
  for (StripLayer& layer : layers) layer.LayEdges(of_cells);
}

}  // namespace tilemend
