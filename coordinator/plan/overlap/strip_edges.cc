#include "coordinator/plan/overlap/strip_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "common/mesh/rounding.h"
#include "common/mesh/segment_distance.h"

namespace tilemend {
namespace {

constexpr double kClearance = 0.125;  // of its size: a new vertex is not nearer to the rim
constexpr double kLeastRoom = 0.02;   // likewise: to others on the same line, where a rim crosses it
constexpr double kLeastSteps = 4;     // of the lattice: lines nearer to each other count as one
constexpr uint8_t kCornerLines = 3;

// A way along an axis.
struct Way {
  int axis;
  Point2 from, to;
};

bool Cross(const Way& way, const Point2& a, const Point2& b) {
  const int across = 1 - way.axis;
  const double da = a[across] - way.from[across], db = b[across] - way.from[across];
  if (da * db >= 0) return false;
  const double at = a[way.axis] + da / (da - db) * (b[way.axis] - a[way.axis]);
  const auto [low, high] = std::minmax(way.from[way.axis], way.to[way.axis]);
  return at >= low && at <= high;
}

// The rims of each cell's holes where they stand on no object.
class RimCrossings {
 public:
  explicit RimCrossings(const Plan& plan) {
    for (const PlannedHole& hole : plan.holes) {
      for (const std::vector<RimSegment>& region : hole.own_regions) {
        for (const RimSegment& s : region) {
          const PlanVertex &a = plan.vertices[s.from], &b = plan.vertices[s.to];
          if (!s.seam && !a.on_object && !b.on_object) rims_[hole.cell].emplace_back(a.position, b.position);
        }
      }
    }
  }

  // Where they cross the line on which `axis` has this value, or end there.
  const std::vector<Point3>& Find(CellId cell, int axis, double line) {
    const auto [it, fresh] = found_.try_emplace({cell, axis, line});
    if (fresh) it->second = Search(cell, axis, line);
    return it->second;
  }

 private:
  std::vector<Point3> Search(CellId cell, int axis, double line) const {
    std::vector<Point3> found;
    const auto it = rims_.find(cell);
    if (it == rims_.end()) return found;
    for (const auto& [a, b] : it->second) {
      const double da = a[axis] - line, db = b[axis] - line;
      const bool a_on = std::abs(da) < kOnLine, b_on = std::abs(db) < kOnLine;
      if (a_on != b_on) found.push_back(a_on ? a : b);
      if (!a_on && !b_on && da * db < 0) found.emplace_back(a + da / (da - db) * (b - a));
    }
    return found;
  }

  std::map<CellId, std::vector<std::pair<Point3, Point3>>> rims_;
  std::map<std::tuple<CellId, int, double>, std::vector<Point3>> found_;
};

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
      const auto it = outlines.coordinate.find({Across(hole.cell, side), Opposite(side)});
      if (it == outlines.coordinate.end()) continue;
      const double width = (own_[side] - it->second) * OutwardOf(side);
      if (width > kLeastSteps * plan.lattice_step) strip_end_[side] = it->second;
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

  void LayEdges(const std::map<CellId, OutlineSegments>& of_cells, RimCrossings& rims) {
    for (std::vector<RimSegment>& region : hole_.own_regions) {
      for (const Side side : kSides) {
        const auto neighbour = of_cells.find(Across(hole_.cell, side));
        if (strip_end_[side] && neighbour != of_cells.end()) {
          LaySide(region, side, neighbour->second[Opposite(side)]);
        }
      }
      for (const Side side : kSides) {
        if (strip_end_[side]) PassNeighboursRim(region, side, rims);
      }
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
    const int axis = AxisOf(side);
    std::vector<RimSegment> own;
    for (const RimSegment& s : region) {
      if (s.seam && RunsAlong(s, side)) own.push_back(s);
    }
    const std::vector<RimSegment> rim = RimAlong(region, side);
    for (const RimSegment& s : neighbours) {
      const std::optional<int32_t> from = CopyOf(s.from, side, own, rim), to = CopyOf(s.to, side, own, rim);
      if (!from || !to) continue;
      const Way edge{1 - axis, PlaceOf(*from), PlaceOf(*to)};
      if (IsClear(edge, rim, std::min(ClearanceAt(*from), ClearanceAt(*to)))) AddEdge(*from, *to);
    }
    for (const RimSegment& s : own) {
      const std::optional<int32_t> from = CopyBeside(s.from, side), to = CopyBeside(s.to, side);
      if (from && to && edges_.contains(std::minmax(*from, *to))) AddDiagonal({s.from, s.to, *from, *to});
    }
  }

  // Puts new vertices on the outline where the neighbour's rim crosses it.
  void PassNeighboursRim(std::vector<RimSegment>& region, Side side, RimCrossings& rims) {
    const int axis = AxisOf(side);
    std::vector<RimSegment> result;
    for (const RimSegment& s : region) {
      int32_t last = s.from;
      if (IsNew(s.from) && IsNew(s.to) && At(s.from, axis) == own_[side] && At(s.to, axis) == own_[side]) {
        for (const int32_t v : NeighboursRimBetween(s.from, s.to, side, rims)) {
          result.push_back({last, v, true});
          last = v;
        }
      }
      result.push_back({last, s.to, s.seam});
    }
    region = std::move(result);
  }

  // New vertices on the outline between two on it, where the neighbour's rim crosses it or, in the strip, ends.
  std::vector<int32_t> NeighboursRimBetween(int32_t from, int32_t to, Side side, RimCrossings& rims) {
    const int axis = AxisOf(side), along = 1 - axis;
    const CellId neighbour = Across(hole_.cell, side);
    const double size = std::min(plan_.vertices[from].size, plan_.vertices[to].size);
    std::map<double, double> heights = {{At(from, along), 0}, {At(to, along), 0}};  // by place
    const auto add = [&](const std::vector<Point3>& crossings, double room) {
      for (const Point3& p : crossings) {
        const auto after = heights.lower_bound(p[along]);
        if (after == heights.begin() || after == heights.end()) continue;
        const bool is_clear = after->first - p[along] >= room && p[along] - std::prev(after)->first >= room;
        if (is_clear) heights.emplace(p[along], p.z());
      }
    };
    add(rims.Find(neighbour, axis, own_[side]), kLeastRoom * size);
    add(rims.Find(neighbour, axis, *strip_end_[side]), kClearance * size);
    std::vector<int32_t> found;
    for (auto it = std::next(heights.begin()); std::next(it) != heights.end(); ++it) {
      found.push_back(AddKnown(from, along, it->first, it->second, size));
    }
    if (At(from, along) > At(to, along)) std::reverse(found.begin(), found.end());
    return found;
  }

  int32_t AddKnown(int32_t like, int axis, double at, double height, double size) {
    const int32_t v = AddVertex(like, axis, RoundedToLattice(at, plan_.lattice_step));
    plan_.vertices[v].position.z() = RoundedToLattice(height, plan_.lattice_step);
    plan_.vertices[v].size = size;
    SetKnown(plan_.vertices[v]);
    return v;
  }

  static void SetKnown(PlanVertex& vertex) {
    vertex.index = -1;
    vertex.follows = -1;
    vertex.lines = 0;
    vertex.height_known = true;
  }

  bool IsNew(int32_t v) const { return plan_.vertices[v].index < 0; }

  // From the south-western corner of the strip between two ways across it to the north-eastern one: in both tiles.
  void AddDiagonal(const std::array<int32_t, 4>& corners) {
    const auto [low, high] = std::minmax_element(corners.begin(), corners.end(), [&](int32_t a, int32_t b) {
      return At(a, 0) + At(a, 1) < At(b, 0) + At(b, 1);
    });
    AddEdge(*low, *high);
  }

  void AddEdge(int32_t a, int32_t b) {
    if (edges_.insert(std::minmax(a, b)).second) hole_.inner_edges.push_back({a, b, true});
  }

  // At a corner of the grid the outline of one neighbour may have no vertex where that of another crosses it.
  void SplitEdges() {
    std::vector<RimSegment> result;
    for (const RimSegment& edge : hole_.inner_edges) {
      int32_t last = edge.from;
      for (const int32_t v : CopiesBetween(copies_, PlaceOf(edge.from), PlaceOf(edge.to), Least())) {
        result.push_back({last, v, true});
        last = v;
      }
      result.push_back({last, edge.to, true});
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
    if (vertex.on_object || !IsInside(place, 1 - AxisOf(side)) || !IsAcross(place, side, own)) return copy;
    Way across{AxisOf(side), place, place};
    across.to[across.axis] = own_[side];
    if (!IsClear(across, rim, ClearanceAt(v))) return copy;
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

  // Whether the hole reaches the outline straight across the strip.
  bool IsAcross(const Point2& place, Side side, const std::vector<RimSegment>& own) const {
    const int along = 1 - AxisOf(side);
    return std::any_of(own.begin(), own.end(), [&](const RimSegment& s) {
      const auto [low, high] = std::minmax({At(s.from, along), At(s.to, along)});
      return place[along] >= low && place[along] <= high;
    });
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
      return room >= Least() || (strip_end_[side] && room == 0);
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
  Point2 PlaceOf(int32_t v) const { return plan_.vertices[v].position.head<2>(); }
  double ClearanceAt(int32_t v) const { return kClearance * plan_.vertices[v].size; }
  double Least() const { return kLeastSteps * plan_.lattice_step; }

  Plan& plan_;
  PlannedHole& hole_;
  std::array<double, 4> own_{};                       // the tile's outline, by Side
  std::array<std::optional<double>, 4> strip_end_{};  // its neighbour's there, as far as they overlap
  Copies copies_;                                     // of neighbours' vertices, by place
  std::set<std::pair<int32_t, int32_t>> edges_;
};

}  // namespace

void LayStripEdges(const GridLines& outlines, Plan& plan) {
  RimCrossings rims(plan);
  std::vector<StripLayer> layers;
  std::map<CellId, OutlineSegments> of_cells;
  for (PlannedHole& hole : plan.holes) {
    if (hole.water >= 0 || hole.own_regions.empty()) continue;
    layers.emplace_back(outlines, plan, hole);
    layers.back().LayCorners();
    layers.back().CollectOutline(of_cells[hole.cell]);
  }
  for (StripLayer& layer : layers) layer.LayEdges(of_cells, rims);
}

}  // namespace tilemend
