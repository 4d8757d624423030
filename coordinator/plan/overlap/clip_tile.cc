#include "coordinator/plan/overlap/clip_tile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "common/mesh/disjoint_sets.h"
#include "common/mesh/lattice.h"
#include "common/mesh/winding/wound_region.h"
#include "coordinator/plan/overlap/lowest_heights.h"

namespace tilemend {
namespace {

// m2: less surface, or less of a hole, seen from above is none.
constexpr double kSliver = 2.5e-3;

Point2 Flat(const Point3& p) { return p.head<2>(); }

class Clipper {
 public:
  Clipper(const SurveyRecord& record, const std::vector<bool>& on_piece_outline, const ClipSquare& square,
          const AreaOutside& outside)
      : record_(record), on_piece_outline_(on_piece_outline), square_(square), outside_(outside), window_(Window()) {
    for (const BoundaryVertex& v : record_.vertices) points_.push_back(window_.Round(Flat(Pressed(v.position))));
    for (const Point2& p : outside_.points) points_.push_back(window_.Round(p));
  }

  ClippedTile Run() {
    FindLoops();
    WoundRegion region = Region();
    if (CutIslands(region)) region = Region();
    for (size_t e = 0; e < record_.edges.size(); ++e) {
      if (!result_.cut[e]) AddInner({record_.edges[e].from, record_.edges[e].to}, false);
    }
    for (const Side s : kSides) {
      const auto beyond = [&](const Point3& p) { return square_.Beyond(p, s); };
      result_.sides[s].height = LowestHeights(record_, 1 - AxisOf(s), beyond);
    }
    AddRegion(region);
    AddSidesOfTile();
    return std::move(result_);
  }

 private:
  // What lies between the cut and the side is moved to the side.
  Point3 Pressed(Point3 p) const {
    for (const Side s : kSides) {
      double& x = p[AxisOf(s)];
      if (square_.Beyond(p, s) && (x - square_.side[s]) * OutwardOf(s) < 0) x = square_.side[s];
    }
    return p;
  }

  LatticeWindow Window() const {
    Point2 lo(square_.side[kWest], square_.side[kSouth]), hi(square_.side[kEast], square_.side[kNorth]);
    for (const BoundaryVertex& v : record_.vertices) {
      lo = lo.cwiseMin(Flat(v.position));
      hi = hi.cwiseMax(Flat(v.position));
    }
    for (const Point2& p : outside_.points) {
      lo = lo.cwiseMin(p);
      hi = hi.cwiseMax(p);
    }
    return {lo, hi};
  }

  LatticeBox Box() const {
    return {window_.Round({square_.side[kWest], square_.side[kSouth]}),
            window_.Round({square_.side[kEast], square_.side[kNorth]})};
  }

  // The connected parts of the boundary; those that leave the square are cut.
  void FindLoops() {
    DisjointSets sets(static_cast<int32_t>(record_.vertices.size()));
    for (const BoundaryEdge& e : record_.edges) sets.Join(e.from, e.to);
    group_ = sets.Groups();
    std::set<int32_t> leaving;
    for (size_t v = 0; v < record_.vertices.size(); ++v) {
      const Point3& p = record_.vertices[v].position;
      if (!square_.Contains(p) || outside_.Contains(Flat(p))) leaving.insert(group_[v]);
    }
    for (size_t e = 0; e < record_.edges.size(); ++e) {
      if (on_piece_outline_[e]) leaving.insert(group_[record_.edges[e].from]);
    }
    for (const BoundaryEdge& e : record_.edges) result_.cut.push_back(leaving.contains(group_[e.from]));
  }

  // Of the edges that were cut.
  WoundRegion Region() {
    cut_edges_.clear();
    std::vector<DirectedEdge> edges;
    for (size_t e = 0; e < result_.cut.size(); ++e) {
      if (!result_.cut[e]) continue;
      cut_edges_.push_back(static_cast<int32_t>(e));
      edges.push_back({record_.edges[e].from, record_.edges[e].to});
    }
    if (outside_.empty()) return FindWoundRegion(points_, edges, Box());
    const auto own = static_cast<int32_t>(record_.vertices.size());
    for (const DirectedEdge& e : outside_.edges) edges.push_back({e.from + own, e.to + own});
    return UniteWoundRegions(points_, edges, cut_edges_.size(), Box());
  }

  void AddSidesOfTile() {
    if (outside_.empty()) {
      for (SideCover& side : result_.sides) side.of_tile = side.step;
      return;
    }
    std::vector<DirectedEdge> edges;
    for (const int32_t e : cut_edges_) edges.push_back({record_.edges[e].from, record_.edges[e].to});
    const WoundRegion region = FindWoundRegion(points_, edges, Box());
    for (const DirectedEdge& s : region.segments) AddToSide(region, s, &SideCover::of_tile);
  }

  // Whether the segment lies on a side. Against the way around the square it takes away what another adds: a hole that
  // only touches there what lies beyond.
  bool AddToSide(const WoundRegion& region, const DirectedEdge& s, std::map<double, int> SideCover::*steps) {
    const int side = CommonSide(region, s);
    if (side < 0) return false;
    const int axis = 1 - AxisOf(static_cast<Side>(side)), turn = TurnOf(static_cast<Side>(side));
    (result_.sides[side].*steps)[window_.ToMetres(Place(region, s.from))[axis]] += turn;
    (result_.sides[side].*steps)[window_.ToMetres(Place(region, s.to))[axis]] -= turn;
    return true;
  }

  // Islands of surface that lie, in part at least, where the region has none are cut as well.
  bool CutIslands(const WoundRegion& region) {
    std::map<int32_t, double> area;
    std::set<int32_t> uncovered;
    for (size_t e = 0; e < record_.edges.size(); ++e) {
      if (result_.cut[e]) continue;
      const BoundaryEdge& edge = record_.edges[e];
      const Point3 &a = record_.vertices[edge.from].position, &b = record_.vertices[edge.to].position;
      const int32_t group = group_[edge.from];
      area[group] += (a.x() - square_.side[kWest]) * (b.y() - square_.side[kSouth]) -
                     (a.y() - square_.side[kSouth]) * (b.x() - square_.side[kWest]);
      if (!uncovered.contains(group) && !Covers(region, points_[edge.from])) uncovered.insert(group);
    }
    bool any = false;
    for (size_t e = 0; e < record_.edges.size(); ++e) {
      const int32_t group = group_[record_.edges[e].from];
      if (result_.cut[e] || !uncovered.contains(group) || area[group] <= 0) continue;
      result_.cut[e] = any = true;
    }
    return any;
  }

  LatticePoint Place(const WoundRegion& region, int32_t v) const {
    const auto own = static_cast<int32_t>(points_.size());
    return v < own ? points_[v] : region.corners[v - own].place;
  }

  // By the edges to the east.
  bool Covers(const WoundRegion& region, LatticePoint p) const {
    bool inside = false;
    for (const DirectedEdge& s : region.segments) {
      const LatticePoint a = Place(region, s.from), b = Place(region, s.to);
      if ((a.y > p.y) == (b.y > p.y)) continue;
      inside ^= Orientation(a.y < b.y ? a : b, a.y < b.y ? b : a, p) > 0;
    }
    return inside;
  }

  void AddRegion(const WoundRegion& region) {
    std::vector<DirectedEdge> loop;
    for (const DirectedEdge& s : region.segments) {
      loop.push_back(s);
      if (s.to != loop.front().from) continue;
      AddLoop(region, loop);
      loop.clear();
    }
  }

  void AddLoop(const WoundRegion& region, const std::vector<DirectedEdge>& loop) {
    double area = 0;
    const Point2 origin = window_.ToMetres(Place(region, loop[0].from));
    for (const DirectedEdge& s : loop) {
      const Point2 a = window_.ToMetres(Place(region, s.from)) - origin,
                   b = window_.ToMetres(Place(region, s.to)) - origin;
      area += (a.x() * b.y() - a.y() * b.x()) / 2;
    }
    if (std::abs(area) < kSliver) return;
    for (const DirectedEdge& s : loop) {
      if (AddToSide(region, s, &SideCover::step)) continue;
      const int32_t from = VertexOf(region, s.from), to = VertexOf(region, s.to);
      AddInner({from, to}, IsOnOutside(region, s.from) && IsOnOutside(region, s.to));
    }
  }

  void AddInner(DirectedEdge edge, bool on_area_edge) {
    result_.inner.push_back(edge);
    result_.on_area_edge.push_back(on_area_edge);
  }

  bool IsNew(int32_t v) const { return v >= std::ssize(record_.vertices); }

  // Whether a vertex of the region is one of those outside the area, or lies between two of them.
  bool IsOnOutside(const WoundRegion& region, int32_t v) const {
    const auto own = static_cast<int32_t>(points_.size());
    if (v < own) return IsNew(v);
    const std::vector<int32_t>& through = region.corners[v - own].through;
    if (through.empty()) return outside_.Contains(window_.ToMetres(Place(region, v)));  // a corner of the square
    return std::any_of(through.begin(), through.end(), [&](int32_t s) { return s >= std::ssize(cut_edges_); });
  }

  bool IsOn(const Point2& p, Side s) const { return p[AxisOf(s)] == square_.side[s]; }

  int CommonSide(const WoundRegion& region, const DirectedEdge& edge) const {
    const Point2 a = window_.ToMetres(Place(region, edge.from)), b = window_.ToMetres(Place(region, edge.to));
    for (const Side s : kSides) {
      if (IsOn(a, s) && IsOn(b, s)) return s;
    }
    return -1;
  }

  // A vertex on a side is none of the tile's even where one lies there, but may be one of the area's.
  int32_t VertexOf(const WoundRegion& region, int32_t v) {
    const auto own = static_cast<int32_t>(points_.size());
    const Point2 place = window_.ToMetres(Place(region, v));
    const bool on_side = std::any_of(kSides.begin(), kSides.end(), [&](Side s) { return IsOn(place, s); });
    if (v < own && (!on_side || IsNew(v))) return v;
    const auto [it, fresh] = number_.try_emplace(v, own + static_cast<int32_t>(result_.vertices.size()));
    if (fresh) result_.vertices.push_back(v < own ? AtVertex(v, place) : AtCorner(region.corners[v - own], place));
    return it->second;
  }

  ClipVertex AtVertex(int32_t v, const Point2& place) const {
    ClipVertex vertex{{place.x(), place.y(), record_.vertices[v].position.z()}, {}, 0};
    for (const int32_t e : cut_edges_) {
      if (record_.edges[e].from == v || record_.edges[e].to == v) vertex.through.push_back(e);
    }
    vertex.length = ShortestOf(vertex.through);
    return vertex;
  }

  ClipVertex AtCorner(const RegionCorner& corner, const Point2& place) const {
    ClipVertex vertex{{place.x(), place.y(), std::numeric_limits<double>::infinity()}, {}, 0};
    for (const int32_t s : corner.through) {
      if (s >= std::ssize(cut_edges_)) continue;  // outside the area
      const BoundaryEdge& e = record_.edges[cut_edges_[s]];
      const Point3 &a = record_.vertices[e.from].position, &b = record_.vertices[e.to].position;
      const double length = Flat(b - a).squaredNorm();
      const double share = length > 0 ? std::clamp((place - Flat(a)).dot(Flat(b - a)) / length, 0.0, 1.0) : 0;
      vertex.position.z() = std::min(vertex.position.z(), a.z() + share * (b.z() - a.z()));
      vertex.through.push_back(cut_edges_[s]);
    }
    if (vertex.through.empty()) {
      vertex.outside = !corner.through.empty() || outside_.Contains(place);
      vertex.position.z() = vertex.outside ? 0 : NearestHeight(place);  // the boundary touches a corner of the square
    }
    vertex.length = ShortestOf(vertex.through);
    return vertex;
  }

  double NearestHeight(const Point2& place) const {
    if (record_.vertices.empty()) return 0;
    const auto nearest = std::min_element(
        record_.vertices.begin(), record_.vertices.end(), [&](const BoundaryVertex& a, const BoundaryVertex& b) {
          return (Flat(a.position) - place).squaredNorm() < (Flat(b.position) - place).squaredNorm();
        });
    return nearest->position.z();
  }

  double ShortestOf(const std::vector<int32_t>& edges) const {
    double shortest = std::numeric_limits<double>::infinity();
    for (const int32_t e : edges) {
      const Point3 &a = record_.vertices[record_.edges[e].from].position,
                   &b = record_.vertices[record_.edges[e].to].position;
      shortest = std::min(shortest, Flat(b - a).norm());
    }
    return shortest;
  }

  const SurveyRecord& record_;
  const std::vector<bool>& on_piece_outline_;
  const ClipSquare& square_;
  const AreaOutside& outside_;
  const LatticeWindow window_;
  std::vector<LatticePoint> points_;   // of the record's vertices, then of those outside the area
  std::vector<int32_t> group_;         // of each vertex: its connected part of the boundary
  std::vector<int32_t> cut_edges_;     // of the record, as the region had them
  std::map<int32_t, int32_t> number_;  // vertex or corner of the region -> vertex of the result
  ClippedTile result_;
};

}  // namespace

bool ClipSquare::Contains(const Point3& p) const {
  return std::none_of(kSides.begin(), kSides.end(), [&](Side s) { return Beyond(p, s); });
}

ClippedTile ClipTile(const SurveyRecord& record, const std::vector<bool>& on_piece_outline, const ClipSquare& square,
                     const AreaOutside& outside) {
  return Clipper(record, on_piece_outline, square, outside).Run();
}

}  // namespace tilemend
