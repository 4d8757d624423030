#include "coordinator/plan/overlap/tile_in_area.h"

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <utility>

#include "common/mesh/winding/wound_region.h"
#include "coordinator/plan/overlap/placed_region.h"
#include "coordinator/plan/rim/rim.h"
#include "coordinator/plan/types/cell_side.h"

namespace tilemend {
namespace {

Point2 FlatPoint(const Point3& p) { return p.head<2>(); }

// The vertices of the tile, then those outside the area.
SurveyRecord WithOutside(const SurveyRecord& tile, const AreaOutside& outside) {
  SurveyRecord record;
  record.vertex_count = tile.vertex_count;
  record.triangle_count = tile.triangle_count;
  record.float32 = tile.float32;
  record.lo = tile.lo, record.hi = tile.hi;
  record.vertices = tile.vertices;
  for (const Point2& p : outside.points) {
    BoundaryVertex vertex;
    vertex.index = -1;
    vertex.position = {p.x(), p.y(), 0};
    record.vertices.push_back(vertex);
  }
  return record;
}

class AreaTaker {
 public:
  AreaTaker(const SurveyRecord& record, const std::vector<bool>& cut, const AreaOutside& outside)
      : tile_(record),
        cut_(cut),
        outside_(outside),
        own_(static_cast<int32_t>(record.vertices.size())),
        window_(WindowAround({outside.box[kWest], outside.box[kSouth]}, {outside.box[kEast], outside.box[kNorth]},
                             record, outside)),
        box_{Rounded({outside.box[kWest], outside.box[kSouth]}), Rounded({outside.box[kEast], outside.box[kNorth]})} {
    for (const BoundaryVertex& v : tile_.vertices) is_inside_.push_back(!outside_.Contains(FlatPoint(v.position)));
  }

  TileInArea Run() {
    result_.record = WithOutside(tile_, outside_);
    FollowArea();
    KeepEdges();
    SurveyRecord& record = result_.record;
    for (const auto& e : chains_) record.edges.push_back({e.first, e.second, kAreaPiece});
    for (const DirectedEdge& e : outside_.edges) {
      if (IsOnBox(Rounded(outside_.points[e.from]), Rounded(outside_.points[e.to]))) {
        record.edges.push_back({e.from + own_, e.to + own_, kAreaPiece});
      }
    }
    return std::move(result_);
  }

 private:
  Point2 Rounded(const Point2& p) const { return window_.ToMetres(window_.Round(p)); }

  // Where the area's edge runs through holes: where it bounds what tile and outside cover together.
  void FollowArea() {
    std::vector<LatticePoint> points;
    for (const BoundaryVertex& v : result_.record.vertices) points.push_back(window_.Round(FlatPoint(v.position)));
    std::vector<DirectedEdge> edges;
    for (size_t e = 0; e < tile_.edges.size(); ++e) {
      if (!cut_[e]) continue;
      cut_edges_.push_back(static_cast<int32_t>(e));
      edges.push_back({tile_.edges[e].from, tile_.edges[e].to});
    }
    for (const DirectedEdge& e : outside_.edges) edges.push_back({e.from + own_, e.to + own_});
    const LatticeBox box{window_.Round(box_[0]), window_.Round(box_[1])};
    const PlacedRegion placed{window_, points, own_, cut_edges_.size(),
                              UniteWoundRegions(points, edges, cut_edges_.size(), box)};
    for (const DirectedEdge& s : placed.region.segments) AddChain(placed, s);
  }

  void AddChain(const PlacedRegion& region, const DirectedEdge& s) {
    if (!region.IsOnOutside(s.from) || !region.IsOnOutside(s.to)) return;
    if (IsOnBox(region.PlaceOf(s.from), region.PlaceOf(s.to))) return;
    const int32_t a = EndOf(region, s.from), b = EndOf(region, s.to);
    if (a >= 0 && b >= 0 && a != b && chains_.erase({b, a}) == 0) chains_.insert({a, b});
  }

  bool IsOnBox(const Point2& a, const Point2& b) const {
    return std::any_of(kSides.begin(), kSides.end(), [&](Side s) {
      const double side = box_[OutwardOf(s) > 0][AxisOf(s)];
      return a[AxisOf(s)] == side && b[AxisOf(s)] == side;
    });
  }

  // Of the tile's edges that cross the area's edge at a corner, the nearest end outside the area. -1: none crosses.
  int32_t EndOf(const PlacedRegion& region, int32_t v) {
    if (!region.IsCorner(v)) return v;
    const Point2 place = region.PlaceOf(v);
    int32_t nearest = -1;
    double least = std::numeric_limits<double>::infinity();
    for (const int32_t s : region.CornerOf(v).through) {
      if (!region.IsOfTile(s)) continue;
      const BoundaryEdge& e = tile_.edges[cut_edges_[s]];
      crossed_.insert(cut_edges_[s]);
      for (const int32_t end : {e.from, e.to}) {
        const double distance = (FlatPoint(tile_.vertices[end].position) - place).norm();
        if (is_inside_[end] || distance >= least) continue;
        least = distance;
        nearest = end;
      }
    }
    return nearest;
  }

  // A way along the area that an edge of the tile goes as well bounds nothing there; against it, neither does.
  void KeepEdges() {
    for (size_t e = 0; e < tile_.edges.size(); ++e) {
      const auto& [from, to, piece] = tile_.edges[e];
      bool keep = !cut_[e] || is_inside_[from] || is_inside_[to] || crossed_.contains(static_cast<int32_t>(e));
      if (keep && cut_[e]) {
        chains_.erase({from, to});
        if (!is_inside_[from] && !is_inside_[to] && chains_.erase({to, from}) > 0) keep = false;
      }
      result_.edge_of.push_back(keep ? static_cast<int32_t>(result_.record.edges.size()) : -1);
      if (keep) result_.record.edges.push_back(tile_.edges[e]);
    }
  }

  const SurveyRecord& tile_;
  const std::vector<bool>& cut_;
  const AreaOutside& outside_;
  const int32_t own_;  // vertices of the tile
  const LatticeWindow window_;
  const std::array<Point2, 2> box_;  // its lower and its upper corner, as the window rounds them
  std::vector<bool> is_inside_;
  std::vector<int32_t> cut_edges_;
  std::set<int32_t> crossed_;
  std::set<std::pair<int32_t, int32_t>> chains_;  // along the area
  TileInArea result_;
};

}  // namespace

TileInArea TakeInArea(const SurveyRecord& record, const std::vector<bool>& cut, const AreaOutside& outside) {
  return AreaTaker(record, cut, outside).Run();
}

}  // namespace tilemend
