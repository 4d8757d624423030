#include "coordinator/plan/overlap/joint_tiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <memory>
#include <set>
#include <utility>

#include "common/mesh/rounding.h"
#include "coordinator/plan/overlap/piece_outlines.h"
#include "coordinator/plan/overlap/tile_in_area.h"
#include "coordinator/plan/rim/rim.h"

namespace tilemend {
namespace {

using Ring = std::vector<Point2>;

// Ends of surface of two tiles, this near by the length of the shorter of their edges, are put in one place: an edge
// between them would be too short beside the others.
constexpr double kSamePlace = 0.3;

Border BorderOf(CellId cell, Side side) {
  return OutwardOf(side) > 0 ? Border{cell, Across(cell, side)} : Border{Across(cell, side), cell};
}

// Which way along a side its cell lies on the left: +1 towards larger coordinates.
int TurnOf(Side side) { return side == kEast || side == kSouth ? 1 : -1; }

// A vertex on a grid line.
struct LineVertex {
  double t = 0, height = 0;
};

// Where the surface of a tile begins or ends along a line.
struct OwnedEnd {
  int tile;            // 0: of Border::first, 1: of Border::second
  bool surface_above;  // towards larger t
  ClipVertex* vertex;
  double t;
};

class Joiner {
 public:
  Joiner(const PlanInput& input, const GridLines& own, double lattice_step, const std::vector<Ring>& area_rings,
         JointTiles& joint)
      : input_(input), own_(own), lattice_step_(lattice_step), area_rings_(area_rings), joint_(joint) {}

  void Run() {
    joint_.input = input_;
    joint_.input.area = {};
    MakeLines();
    for (const auto& [cell, record] : input_.cells) Clip(cell, record);
    std::set<Border> borders;
    for (const auto& [cell, clipped] : clipped_) {
      for (const Side s : kSides) borders.insert(BorderOf(cell, s));
    }
    for (const Border& border : borders) MergeNearEnds(border);
    for (auto& [cell, clipped] : clipped_) MakeRecord(cell, clipped);
    for (const Border& border : borders) AddBorder(border);
    for (auto& [cell, record] : joint_.records) joint_.input.cells[cell] = &record;
  }

 private:
  void MakeLines() {
    joint_.lines.clipped = true;
    joint_.lines.joined = true;
    joint_.lines.tolerance = 0;
    joint_.lines.left_open = own_.left_open;
    joint_.lines.outline = own_.coordinate;
    for (const auto& [cell, record] : input_.cells) {
      ClipSquare& square = joint_.squares[cell];
      for (const Side s : kSides) {
        square.side[s] = RoundedToLattice(NominalLine(input_.grid, cell, s), lattice_step_);
        square.cut[s] =
            OutwardOf(s) > 0 ? std::min(square.side[s], own_.At(cell, s)) : std::max(square.side[s], own_.At(cell, s));
        joint_.lines.coordinate[cell][s] = square.side[s];
      }
    }
  }

  void Clip(CellId cell, const StoredRecord& stored) {
    const AreaOutside outside = OutsideOf(cell);
    if (stored == nullptr && outside.empty()) return;
    const auto tile = stored == nullptr ? nullptr : stored.Outline();
    const SurveyRecord& record = tile != nullptr ? *tile : kNoTile;
    const std::vector<bool> on_piece_outline = FindPieceOutlines(record, own_.piece_reach);
    ClippedTile& clipped = clipped_[cell] = ClipTile(record, on_piece_outline, joint_.squares.at(cell), outside);
    std::vector<bool> chain = clipped.cut;
    for (size_t e = 0; e < chain.size(); ++e) chain[e] = chain[e] && !on_piece_outline[e];
    AverageCorners(cell, record);
    if (outside.empty()) {
      joint_.own[cell] = tile;
      joint_.cut[cell] = clipped.cut;
      joint_.chain[cell] = std::move(chain);
    } else {
      TakeArea(cell, record, outside, chain);
    }
  }

  AreaOutside OutsideOf(CellId cell) const {
    if (area_rings_.empty()) return {};
    std::array<double, 4> box;
    for (const Side s : kSides) {
      const double line = joint_.squares.at(cell).side[s], outline = own_.At(cell, s);
      box[s] = OutwardOf(s) > 0 ? std::max(line, outline) : std::min(line, outline);
    }
    return OutsideIn(area_rings_, box, lattice_step_);
  }

  // The tile's own boundary becomes that of its part inside the area.
  void TakeArea(CellId cell, const SurveyRecord& record, const AreaOutside& outside, const std::vector<bool>& chain) {
    ClippedTile& clipped = clipped_.at(cell);
    TileInArea tile = TakeInArea(record, clipped.cut, outside);
    std::vector<bool>&cut = joint_.cut[cell], &in_chain = joint_.chain[cell];
    cut.assign(tile.record.edges.size(), true);
    in_chain.assign(tile.record.edges.size(), true);
    for (size_t e = 0; e < tile.edge_of.size(); ++e) {
      if (tile.edge_of[e] < 0) continue;
      cut[tile.edge_of[e]] = clipped.cut[e];
      in_chain[tile.edge_of[e]] = chain[e];
    }
    for (ClipVertex& v : clipped.vertices) {
      for (int32_t& e : v.through) e = tile.edge_of[e];
      std::erase(v.through, -1);
    }
    joint_.own[cell] = std::make_shared<const SurveyRecord>(std::move(tile.record));
  }

  // The south-west corner of a cell stands for its place.
  static CellId CornerOf(CellId cell, const std::array<Side, 2>& sides) {
    return {cell.col + (sides[0] == kEast), cell.row + (sides[1] == kNorth)};
  }

  void AverageCorners(CellId cell, const SurveyRecord& tile) {
    const ClipSquare& square = joint_.squares.at(cell);
    for (const BoundaryVertex& v : tile.vertices) {
      for (const Side x : {kWest, kEast}) {
        for (const Side y : {kSouth, kNorth}) {
          if (!square.Beyond(v.position, x) || !square.Beyond(v.position, y)) continue;
          auto& [sum, count] = corner_height_[CornerOf(cell, {x, y})];
          sum += v.position.z();
          ++count;
        }
      }
    }
  }

  void MakeRecord(CellId cell, const ClippedTile& clipped) {
    const SurveyRecord& own = *joint_.own.at(cell);
    SurveyRecord& record = joint_.records[cell];
    record.vertex_count = own.vertex_count;
    record.triangle_count = own.triangle_count;
    record.float32 = own.float32;
    record.lo = own.lo, record.hi = own.hi;
    record.vertices = own.vertices;
    joint_.edges_through[cell];
    for (const ClipVertex& v : clipped.vertices) AddVertex(cell, v.position, v.through);
    for (size_t i = 0; i < clipped.inner.size(); ++i) {
      record.edges.push_back({clipped.inner[i].from, clipped.inner[i].to, clipped.on_area_edge[i] ? kAreaPiece : 0});
    }
  }

  int32_t AddVertex(CellId cell, const Point3& position, std::vector<int32_t> through) {
    SurveyRecord& record = joint_.records.at(cell);
    std::vector<std::vector<int32_t>>& edges = joint_.edges_through.at(cell);
    BoundaryVertex vertex;
    vertex.index = static_cast<int32_t>(record.vertex_count) + static_cast<int32_t>(edges.size());
    vertex.position = position;
    vertex.centroid_height = position.z();
    record.vertices.push_back(vertex);
    edges.push_back(std::move(through));
    return static_cast<int32_t>(record.vertices.size()) - 1;
  }

  int32_t AddLineVertex(CellId cell, Side side, const LineVertex& v) {
    Point3 position;
    position[AxisOf(side)] = joint_.squares.at(cell).side[side];
    position[1 - AxisOf(side)] = v.t;
    position.z() = v.height;
    return AddVertex(cell, position, {});
  }

  static CellId TileOf(const Border& border, int tile) { return tile == 0 ? border.first : border.second; }
  static Side SideOf(const Border& border, int tile) {
    return IsVertical(border) ? (tile == 0 ? kEast : kWest) : (tile == 0 ? kNorth : kSouth);
  }

  ClippedTile* ClippedOf(const Border& border, int tile) {
    const auto it = clipped_.find(TileOf(border, tile));
    return it == clipped_.end() ? nullptr : &it->second;
  }

  std::vector<OwnedEnd> EndsOf(const Border& border) {
    std::vector<OwnedEnd> ends;
    for (const int tile : {0, 1}) {
      ClippedTile* clipped = ClippedOf(border, tile);
      if (clipped == nullptr) continue;
      const Side side = SideOf(border, tile);
      const double line = joint_.squares.at(TileOf(border, tile)).side[side];
      for (ClipVertex& v : clipped->vertices) {
        if (v.position[AxisOf(side)] != line) continue;
        const double t = v.position[1 - AxisOf(side)];
        const auto step = clipped->sides[side].step.find(t);
        if (step == clipped->sides[side].step.end() || step->second == 0) continue;
        ends.push_back({tile, step->second > 0, &v, t});
      }
    }
    std::sort(ends.begin(), ends.end(),
              [](const OwnedEnd& a, const OwnedEnd& b) { return std::pair(a.t, a.tile) < std::pair(b.t, b.tile); });
    return ends;
  }

  void MergeNearEnds(const Border& border) {
    const std::vector<OwnedEnd> ends = EndsOf(border);
    for (size_t i = 0; i + 1 < ends.size(); ++i) {
      const OwnedEnd &a = ends[i], &b = ends[i + 1];
      if (a.tile == b.tile || a.surface_above != b.surface_above) continue;
      if (b.t - a.t > kSamePlace * std::min(a.vertex->length, b.vertex->length)) continue;
      const LineVertex place{(a.t + b.t) / 2, (a.vertex->position.z() + b.vertex->position.z()) / 2};
      for (const OwnedEnd& end : {a, b}) MoveEnd(border, end, place);
      ++i;
    }
  }

  void MoveEnd(const Border& border, const OwnedEnd& end, const LineVertex& place) {
    const Side side = SideOf(border, end.tile);
    end.vertex->position[1 - AxisOf(side)] = place.t;
    end.vertex->position.z() = place.height;
    std::map<double, int>& step = ClippedOf(border, end.tile)->sides[side].step;
    const int more = step.at(end.t);
    step.erase(end.t);
    step[place.t] += more;
  }

  // What one tile has along a line.
  struct Coverage {
    std::map<double, int> step;         // how much more surface there is from here on
    std::map<double, double> height;    // of its own vertices beyond the line
    std::map<double, double> crossing;  // of the vertices of its clipped boundary on the line
  };

  Coverage CoverageOf(const Border& border, int tile) {
    const ClippedTile* clipped = ClippedOf(border, tile);
    if (clipped == nullptr) return {};
    const Side side = SideOf(border, tile);
    Coverage coverage{clipped->sides[side].step, clipped->sides[side].height, {}};
    const double line = joint_.squares.at(TileOf(border, tile)).side[side];
    for (const ClipVertex& v : clipped->vertices) {
      if (v.position[AxisOf(side)] == line) coverage.crossing.emplace(v.position[1 - AxisOf(side)], v.position.z());
    }
    for (const BoundaryVertex& v : joint_.own.at(TileOf(border, tile))->vertices) {
      if (v.index < 0 && v.position[AxisOf(side)] == line) coverage.crossing[v.position[1 - AxisOf(side)]] = 0;
    }
    return coverage;
  }

  // The stretches of a line where one tile has surface and the other has not are edges of the one that has.
  void AddBorder(const Border& border) {
    const Coverage of[2] = {CoverageOf(border, 0), CoverageOf(border, 1)};
    std::set<double> places;  // along the line
    for (const Coverage& c : of) {
      for (const auto& [t, step] : c.step) places.insert(t);
      for (const auto& [t, height] : c.height) places.insert(t);
      for (const auto& [t, height] : c.crossing) places.insert(t);
    }
    std::vector<LineVertex> run;
    int surface[2] = {0, 0}, owner = -1;
    for (const double t : places) {
      for (const int k : {0, 1}) {
        if (const auto it = of[k].step.find(t); it != of[k].step.end()) surface[k] += it->second;
      }
      const int next = surface[0] > 0 && surface[1] <= 0 ? 0 : surface[1] > 0 && surface[0] <= 0 ? 1 : -1;
      if (owner >= 0 && (next != owner || HasVertex(of[owner], t))) run.push_back(VertexAt(border, of, owner, t));
      if (next == owner) continue;
      if (owner >= 0) AddRun(border, owner, run);
      owner = next;
      run.clear();
      if (owner >= 0) run.push_back(VertexAt(border, of, owner, t));
    }
  }

  static bool HasVertex(const Coverage& coverage, double t) {
    return coverage.height.contains(t) || coverage.crossing.contains(t);
  }

  // A place on a line: its height is that of the clipped boundary there, at a grid corner that of all tiles in the
  // mean, else that of the owner's nearest vertex along the line.
  LineVertex VertexAt(const Border& border, const Coverage (&of)[2], int owner, double t) const {
    const CellId tile = TileOf(border, owner);
    const Side side = SideOf(border, owner), low = AxisOf(side) == 0 ? kSouth : kWest;
    const ClipSquare& square = joint_.squares.at(tile);
    const bool at_low = t == square.side[low], at_high = t == square.side[low + 1];
    if (at_low || at_high) {
      const auto end = static_cast<Side>(at_low ? low : low + 1);
      const auto it = corner_height_.find(
          CornerOf(tile, AxisOf(side) == 0 ? std::array<Side, 2>{side, end} : std::array<Side, 2>{end, side}));
      if (it != corner_height_.end()) return {t, it->second.first / it->second.second};
      if (!area_rings_.empty()) return {t, 0};  // outside the area
    }
    for (const int k : {owner, 1 - owner}) {
      if (const auto it = of[k].crossing.find(t); it != of[k].crossing.end()) return {t, it->second};
    }
    for (const int k : {owner, 1 - owner}) {
      if (const auto it = of[k].height.find(t); it != of[k].height.end()) return {t, it->second};
    }
    return {t, NearestHeight(of[owner].height, t)};
  }

  static double NearestHeight(const std::map<double, double>& heights, double t) {
    const auto above = heights.lower_bound(t);
    if (heights.empty()) return 0;
    if (above == heights.begin()) return above->second;
    const auto below = std::prev(above);
    return above == heights.end() || t - below->first < above->first - t ? below->second : above->second;
  }

  void AddRun(const Border& border, int owner, std::vector<LineVertex> run) {
    const CellId tile = TileOf(border, owner);
    const Side side = SideOf(border, owner);
    if (TurnOf(side) < 0) std::reverse(run.begin(), run.end());
    SurveyRecord& record = joint_.records.at(tile);
    int32_t last = -1;
    for (const LineVertex& v : run) {
      const int32_t node = AddLineVertex(tile, side, v);
      if (last >= 0) record.edges.push_back({last, node});
      last = node;
    }
  }

  inline static const SurveyRecord kNoTile;

  const PlanInput& input_;
  const GridLines& own_;
  const double lattice_step_;
  const std::vector<Ring>& area_rings_;
  JointTiles& joint_;
  std::map<CellId, ClippedTile> clipped_;
  std::map<CellId, std::pair<double, int>> corner_height_;  // by the cell north-east of it: sum and count
};

}  // namespace

JointTiles JoinTiles(const PlanInput& input, const GridLines& own, double lattice_step,
                     const std::vector<Ring>& area_rings) {
  JointTiles joint;
  Joiner(input, own, lattice_step, area_rings, joint).Run();
  return joint;
}

}  // namespace tilemend
