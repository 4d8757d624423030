#include "coordinator/plan/overlap/clip_tile.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "common/mesh/disjoint_sets.h"
#include "common/mesh/lattice.h"
#include "common/mesh/winding/wound_region.h"
#include "coordinator/plan/overlap/lowest_heights.h"
#include "coordinator/plan/overlap/placed_region.h"

namespace tilemend {
namespace {

// m2: less surface, or less of a hole, seen from above is none.
constexpr double kSliver = 2.5e-3;

Point2 Flat(const Point3& p) { return p.head<2>(); }

// What lies between the cut and the side is moved to the side.
Point3 Pressed(Point3 p, const ClipSquare& square) {
  for (const Side s : kSides) {
    double& x = p[AxisOf(s)];
    if (square.Beyond(p, s) && (x - square.side[s]) * OutwardOf(s) < 0) x = square.side[s];
  }
  return p;
}

LatticeBox BoxOf(const ClipSquare& square, const LatticeWindow& window) {
  return {window.Round({square.side[kWest], square.side[kSouth]}),
          window.Round({square.side[kEast], square.side[kNorth]})};
}

// By the edges to the east.
bool Covers(const PlacedRegion& placed, LatticePoint p) {
  bool inside = false;
  for (const DirectedEdge& s : placed.region.segments) {
    const LatticePoint a = placed.At(s.from), b = placed.At(s.to);
    if ((a.y > p.y) == (b.y > p.y)) continue;
    inside ^= Orientation(a.y < b.y ? a : b, a.y < b.y ? b : a, p) > 0;
  }
  return inside;
}

bool IsOn(const Point2& p, Side s, const ClipSquare& square) { return p[AxisOf(s)] == square.side[s]; }

// -1: none.
int CommonSide(const PlacedRegion& region, const DirectedEdge& edge, const ClipSquare& square) {
  const Point2 a = region.PlaceOf(edge.from), b = region.PlaceOf(edge.to);
  for (const Side s : kSides) {
    if (IsOn(a, s, square) && IsOn(b, s, square)) return s;
  }
  return -1;
}

double ShortestOf(const SurveyRecord& record, const std::vector<int32_t>& edges) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const int32_t e : edges) {
    const Point3 &a = record.vertices[record.edges[e].from].position, &b = record.vertices[record.edges[e].to].position;
    shortest = std::min(shortest, Flat(b - a).norm());
  }
  return shortest;
}

double HeightNear(const SurveyRecord& record, const Point2& place) {
  if (record.vertices.empty()) return 0;
  const auto nearest = std::min_element(
      record.vertices.begin(), record.vertices.end(), [&](const BoundaryVertex& a, const BoundaryVertex& b) {
        return (Flat(a.position) - place).squaredNorm() < (Flat(b.position) - place).squaredNorm();
      });
  return nearest->position.z();
}

ClipVertex AtVertex(int32_t v, const Point2& place, const SurveyRecord& record, const std::vector<int32_t>& cut_edges) {
  ClipVertex vertex{{place.x(), place.y(), record.vertices[v].position.z()}, {}, 0};
  for (const int32_t e : cut_edges) {
    if (record.edges[e].from == v || record.edges[e].to == v) vertex.through.push_back(e);
  }
  vertex.length = ShortestOf(record, vertex.through);
  return vertex;
}

ClipVertex AtCorner(const RegionCorner& corner, const Point2& place, const SurveyRecord& record,
                    const std::vector<int32_t>& cut_edges, const AreaOutside& outside) {
  ClipVertex vertex{{place.x(), place.y(), std::numeric_limits<double>::infinity()}, {}, 0};
  for (const int32_t s : corner.through) {
    if (s >= std::ssize(cut_edges)) continue;  // outside the area
    const BoundaryEdge& e = record.edges[cut_edges[s]];
    const Point3 &a = record.vertices[e.from].position, &b = record.vertices[e.to].position;
    const double length = Flat(b - a).squaredNorm();
    const double share = length > 0 ? std::clamp((place - Flat(a)).dot(Flat(b - a)) / length, 0.0, 1.0) : 0;
    vertex.position.z() = std::min(vertex.position.z(), a.z() + share * (b.z() - a.z()));
    vertex.through.push_back(cut_edges[s]);
  }
  if (vertex.through.empty()) {
    vertex.outside = !corner.through.empty() || outside.Contains(place);
    vertex.position.z() =
        vertex.outside ? 0 : HeightNear(record, place);  // the boundary touches a corner of the square
  }
  vertex.length = ShortestOf(record, vertex.through);
  return vertex;
}

// A corner of the square is, if it lies outside the area.
bool IsOnAreaEdge(const PlacedRegion& region, int32_t v, const AreaOutside& outside) {
  if (region.IsCorner(v) && region.CornerOf(v).through.empty()) return outside.Contains(region.PlaceOf(v));
  return region.IsOnOutside(v);
}

void AddInner(DirectedEdge edge, bool on_area_edge, ClippedTile& tile) {
  tile.inner.push_back(edge);
  tile.on_area_edge.push_back(on_area_edge);
}

class Clipper {
 public:
  Clipper(const SurveyRecord& record, const std::vector<bool>& on_piece_outline, const ClipSquare& square,
          const AreaOutside& outside)
      : record_(record),
        on_piece_outline_(on_piece_outline),
        square_(square),
        outside_(outside),
        window_(WindowAround({square.side[kWest], square.side[kSouth]}, {square.side[kEast], square.side[kNorth]},
                             record, outside)) {
    for (const BoundaryVertex& v : record_.vertices)
      points_.push_back(window_.Round(Flat(Pressed(v.position, square))));
    for (const Point2& p : outside_.points) points_.push_back(window_.Round(p));
  }

  ClippedTile Run() {
    FindLoops();
    std::optional<PlacedRegion> region(Region());
    if (CutIslands(*region)) region.emplace(Region());
    for (size_t e = 0; e < record_.edges.size(); ++e) {
      if (!result_.cut[e]) AddInner({record_.edges[e].from, record_.edges[e].to}, false, result_);
    }
    for (const Side s : kSides) {
      const auto beyond = [&](const Point3& p) { return square_.Beyond(p, s); };
      result_.sides[s].height = LowestHeights(record_, 1 - AxisOf(s), beyond);
    }
    AddRegion(*region);
    AddSidesOfTile();
    return std::move(result_);
  }

 private:
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
  PlacedRegion Region() {
    cut_edges_.clear();
    std::vector<DirectedEdge> edges;
    for (size_t e = 0; e < result_.cut.size(); ++e) {
      if (!result_.cut[e]) continue;
      cut_edges_.push_back(static_cast<int32_t>(e));
      edges.push_back({record_.edges[e].from, record_.edges[e].to});
    }
    const auto own = static_cast<int32_t>(record_.vertices.size());
    if (outside_.empty())
      return {window_, points_, own, cut_edges_.size(), FindWoundRegion(points_, edges, BoxOf(square_, window_))};
    for (const DirectedEdge& e : outside_.edges) edges.push_back({e.from + own, e.to + own});
    return {window_, points_, own, cut_edges_.size(),
            UniteWoundRegions(points_, edges, cut_edges_.size(), BoxOf(square_, window_))};
  }

  void AddSidesOfTile() {
    if (outside_.empty()) {
      for (SideCover& side : result_.sides) side.of_tile = side.step;
      return;
    }
    std::vector<DirectedEdge> edges;
    for (const int32_t e : cut_edges_) edges.push_back({record_.edges[e].from, record_.edges[e].to});
    const PlacedRegion region{window_, points_, static_cast<int32_t>(record_.vertices.size()), edges.size(),
                              FindWoundRegion(points_, edges, BoxOf(square_, window_))};
    for (const DirectedEdge& s : region.region.segments) AddToSide(region, s, &SideCover::of_tile);
  }

  // Whether the segment lies on a side. Against the way around the square it takes away what another adds: a hole that
  // only touches there what lies beyond.
  bool AddToSide(const PlacedRegion& region, const DirectedEdge& s, std::map<double, int> SideCover::*steps) {
    const int side = CommonSide(region, s, square_);
    if (side < 0) return false;
    const int axis = 1 - AxisOf(static_cast<Side>(side)), turn = TurnOf(static_cast<Side>(side));
    (result_.sides[side].*steps)[region.PlaceOf(s.from)[axis]] += turn;
    (result_.sides[side].*steps)[region.PlaceOf(s.to)[axis]] -= turn;
    return true;
  }

  // Islands of surface that lie, in part at least, where the region has none are cut as well.
  bool CutIslands(const PlacedRegion& region) {
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

  void AddRegion(const PlacedRegion& region) {
    std::vector<DirectedEdge> loop;
    for (const DirectedEdge& s : region.region.segments) {
      loop.push_back(s);
      if (s.to != loop.front().from) continue;
      AddLoop(region, loop);
      loop.clear();
    }
  }

  void AddLoop(const PlacedRegion& region, const std::vector<DirectedEdge>& loop) {
    double area = 0;
    const Point2 origin = region.PlaceOf(loop[0].from);
    for (const DirectedEdge& s : loop) {
      const Point2 a = region.PlaceOf(s.from) - origin, b = region.PlaceOf(s.to) - origin;
      area += (a.x() * b.y() - a.y() * b.x()) / 2;
    }
    if (std::abs(area) < kSliver) return;
    for (const DirectedEdge& s : loop) {
      if (AddToSide(region, s, &SideCover::step)) continue;
      const int32_t from = VertexOf(region, s.from), to = VertexOf(region, s.to);
      AddInner({from, to}, IsOnAreaEdge(region, s.from, outside_) && IsOnAreaEdge(region, s.to, outside_), result_);
    }
  }

  // A vertex on a side is none of the tile's even where one lies there, but may be one of the area's.
  int32_t VertexOf(const PlacedRegion& region, int32_t v) {
    const Point2 place = region.PlaceOf(v);
    const bool on_side = std::any_of(kSides.begin(), kSides.end(), [&](Side s) { return IsOn(place, s, square_); });
    if (!region.IsCorner(v) && (!on_side || region.IsOnOutside(v))) return v;
    const auto [it, fresh] =
        number_.try_emplace(v, static_cast<int32_t>(points_.size()) + static_cast<int32_t>(result_.vertices.size()));
    if (fresh)
      result_.vertices.push_back(region.IsCorner(v) ? AtCorner(region.CornerOf(v), place, record_, cut_edges_, outside_)
                                                    : AtVertex(v, place, record_, cut_edges_));
    return it->second;
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
