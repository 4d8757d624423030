#include "coordinator/plan/overlap/joint_tiles.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "common/mesh/rounding.h"
#include "coordinator/plan/overlap/line_runs.h"
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

// Where the surface of a tile begins or ends along a line.
struct OwnedEnd {
  int tile;            // 0: of Border::first, 1: of Border::second
  bool surface_above;  // towards larger t
  ClipVertex* vertex;
  double t;
};

void MakeLines(const PlanInput& input, const GridLines& own, double lattice_step, JointTiles& joint) {
  joint.lines.clipped = true;
  joint.lines.joined = true;
  joint.lines.tolerance = 0;
  joint.lines.left_open = own.left_open;
  joint.lines.outline = own.coordinate;
  for (const auto& [cell, record] : input.cells) {
    ClipSquare& square = joint.squares[cell];
    for (const Side s : kSides) {
      square.side[s] = RoundedToLattice(NominalLine(input.grid, cell, s), lattice_step);
      square.cut[s] =
          OutwardOf(s) > 0 ? std::min(square.side[s], own.At(cell, s)) : std::max(square.side[s], own.At(cell, s));
      joint.lines.coordinate[cell][s] = square.side[s];
    }
  }
}

// The south-west corner of a cell stands for its place.
CellId CornerOf(CellId cell, const std::array<Side, 2>& sides) {
  return {cell.col + (sides[0] == kEast), cell.row + (sides[1] == kNorth)};
}

int32_t AddVertex(CellId cell, const Point3& position, std::vector<int32_t> through, bool outside, JointTiles& joint) {
  SurveyRecord& record = joint.records.at(cell);
  std::vector<std::vector<int32_t>>& edges = joint.edges_through.at(cell);
  BoundaryVertex vertex;
  vertex.index = outside ? -1 : static_cast<int32_t>(record.vertex_count) + static_cast<int32_t>(edges.size());
  vertex.position = position;
  vertex.centroid_height = position.z();
  record.vertices.push_back(vertex);
  edges.push_back(std::move(through));
  return static_cast<int32_t>(record.vertices.size()) - 1;
}

void MakeRecord(CellId cell, const ClippedTile& clipped, JointTiles& joint) {
  const SurveyRecord& own = *joint.own.at(cell);
  SurveyRecord& record = joint.records[cell];
  record.vertex_count = own.vertex_count;
  record.triangle_count = own.triangle_count;
  record.float32 = own.float32;
  record.lo = own.lo, record.hi = own.hi;
  record.vertices = own.vertices;
  joint.edges_through[cell];
  for (const ClipVertex& v : clipped.vertices) AddVertex(cell, v.position, v.through, v.outside, joint);
  for (size_t i = 0; i < clipped.inner.size(); ++i) {
    record.edges.push_back({clipped.inner[i].from, clipped.inner[i].to, clipped.on_area_edge[i] ? kAreaPiece : 0});
  }
}

int32_t AddLineVertex(CellId cell, Side side, const LineVertex& v, JointTiles& joint) {
  Point3 position;
  position[AxisOf(side)] = joint.squares.at(cell).side[side];
  position[1 - AxisOf(side)] = v.t;
  position.z() = v.height;
  return AddVertex(cell, position, {}, !v.on_surface, joint);
}

CellId TileOf(const Border& border, int tile) { return tile == 0 ? border.first : border.second; }

Side SideOf(const Border& border, int tile) {
  return IsVertical(border) ? (tile == 0 ? kEast : kWest) : (tile == 0 ? kNorth : kSouth);
}

// What is outside the area has no edges: there it is the edge of the area that bounds the hole in the other cell.
void AddRun(const Border& border, const LineRun& run, JointTiles& joint) {
  std::vector<LineVertex> vertices = run.vertices;
  if (TurnOf(SideOf(border, run.tile)) < 0) std::reverse(vertices.begin(), vertices.end());
  const int by = run.outside ? 1 - run.tile : run.tile;
  const CellId cell = TileOf(border, by);
  SurveyRecord& record = joint.records[cell];
  joint.edges_through[cell];
  int32_t last = -1;
  for (const LineVertex& v : vertices) {
    const int32_t node = AddLineVertex(cell, SideOf(border, by), v, joint);
    if (last >= 0) record.edges.push_back({last, node, run.outside ? kAreaPiece : 0});
    last = node;
  }
}

// Places on the grid lines that are vertices whatever tiles cover: corners and ends of the area's edge.
class FixedPlaces {
 public:
  // At a grid corner the height is that of all tiles in the mean.
  void AddCorners(CellId cell, const ClipSquare& square, const SurveyRecord& tile) {
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

  // A tile's boundary that passes through a corner has its own height there. It takes that of the corner, where the
  // lines of the other tiles end.
  void SettleCorners(CellId cell, const ClipSquare& square, ClippedTile& clipped) const {
    for (ClipVertex& v : clipped.vertices) {
      for (const Side x : {kWest, kEast}) {
        for (const Side y : {kSouth, kNorth}) {
          if (v.outside || v.position.x() != square.side[x] || v.position.y() != square.side[y]) continue;
          if (const auto height = HeightAt(CornerOf(cell, {x, y}))) v.position.z() = *height;
        }
      }
    }
  }

  // Where the edge of the area ends in the clipped boundary, or goes on beside it.
  void AddAreaEnds(const std::vector<BoundaryVertex>& vertices, const ClippedTile& clipped) {
    for (size_t i = 0; i < clipped.inner.size(); ++i) {
      if (!clipped.on_area_edge[i]) continue;
      for (const int32_t v : {clipped.inner[i].from, clipped.inner[i].to}) {
        const int32_t of_clip = v - static_cast<int32_t>(vertices.size());
        if (of_clip >= 0 ? !clipped.vertices[of_clip].outside : vertices[v].index >= 0) continue;
        const Point3& p = of_clip >= 0 ? clipped.vertices[of_clip].position : vertices[v].position;
        for (const int axis : {0, 1}) area_ends_[{axis, p[axis]}].insert(p[1 - axis]);
      }
    }
  }

  // The ends of the area's edge on a side, and the side's own.
  std::map<double, LineVertex> On(CellId cell, Side side, const ClipSquare& square, bool has_area) const {
    std::map<double, LineVertex> fixed;
    const Side low = AxisOf(side) == 0 ? kSouth : kWest;
    for (const Side end : {low, Opposite(low)}) {
      const double t = square.side[end];
      const auto height =
          HeightAt(CornerOf(cell, AxisOf(side) == 0 ? std::array<Side, 2>{side, end} : std::array<Side, 2>{end, side}));
      if (height) {
        fixed[t] = {t, *height};
      } else if (has_area) {
        fixed[t] = {t, 0, false};
      }
    }
    const auto ends = area_ends_.find({AxisOf(side), square.side[side]});
    if (ends == area_ends_.end()) return fixed;
    const auto last = ends->second.upper_bound(square.side[low + 1]);
    for (auto t = ends->second.lower_bound(square.side[low]); t != last; ++t) fixed[*t] = {*t, 0, false};
    return fixed;
  }

 private:
  // Of a corner. None: no tile reaches it.
  std::optional<double> HeightAt(CellId corner) const {
    const auto it = corner_height_.find(corner);
    return it == corner_height_.end() ? std::nullopt : std::optional(it->second.first / it->second.second);
  }

  std::map<std::pair<int, double>, std::set<double>> area_ends_;  // by axis and the place on it: places on the other
  std::map<CellId, std::pair<double, int>> corner_height_;        // by the cell north-east of it: sum and count
};

class Joiner {
 public:
  Joiner(const PlanInput& input, const GridLines& own, double lattice_step, const std::vector<Ring>* area_rings,
         JointTiles& joint)
      : input_(input), own_(own), lattice_step_(lattice_step), area_rings_(area_rings), joint_(joint) {}

  void Run() {
    joint_.input = input_;
    joint_.input.area = {};
    MakeLines(input_, own_, lattice_step_, joint_);
    for (const auto& [cell, record] : input_.cells) Clip(cell, record);
    std::set<Border> borders;
    for (const auto& [cell, clipped] : clipped_) {
      for (const Side s : kSides) borders.insert(BorderOf(cell, s));
    }
    for (const Border& border : borders) MergeNearEnds(border);
    for (auto& [cell, clipped] : clipped_) {
      fixed_.SettleCorners(cell, joint_.squares.at(cell), clipped);
      fixed_.AddAreaEnds(joint_.own.at(cell)->vertices, clipped);
      MakeRecord(cell, clipped, joint_);
    }
    for (const Border& border : borders) AddBorder(border);
    for (auto& [cell, record] : joint_.records) joint_.input.cells[cell] = &record;
  }

 private:
  AreaOutside OutsideOf(CellId cell) const {
    if (area_rings_ == nullptr) return {};
    std::array<double, 4> box;
    for (const Side s : kSides) {
      const double line = joint_.squares.at(cell).side[s], outline = own_.At(cell, s);
      box[s] = OutwardOf(s) > 0 ? std::max(line, outline) : std::min(line, outline);
    }
    return OutsideIn(*area_rings_, box, lattice_step_);
  }

  void Clip(CellId cell, const StoredRecord& stored) {
    const AreaOutside outside = OutsideOf(cell);
    if (stored == nullptr && outside.empty()) return;
    const auto tile = stored == nullptr ? nullptr : stored.Outline();
    const SurveyRecord& record = tile != nullptr ? *tile : kNoTile;
    const std::vector<bool> on_piece_outline = FindPieceOutlines(record, own_.pieces);
    ClippedTile& clipped = clipped_[cell] = ClipTile(record, on_piece_outline, joint_.squares.at(cell), outside);
    std::vector<bool> chain = clipped.cut;
    for (size_t e = 0; e < chain.size(); ++e) chain[e] = chain[e] && !on_piece_outline[e];
    fixed_.AddCorners(cell, joint_.squares.at(cell), record);
    if (outside.empty()) {
      joint_.own[cell] = tile;
      joint_.cut[cell] = clipped.cut;
      joint_.chain[cell] = std::move(chain);
    } else {
      TakeArea(cell, record, outside, chain);
    }
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
    SideCover& cover = ClippedOf(border, end.tile)->sides[side];
    for (std::map<double, int>* steps : {&cover.step, &cover.of_tile}) {
      if (const auto moved = steps->extract(end.t)) (*steps)[place.t] += moved.mapped();
    }
  }

  LineCover CoverOf(const Border& border, int tile) {
    LineCover cover;
    cover.in_scene = input_.cells.contains(TileOf(border, tile));
    const ClippedTile* clipped = ClippedOf(border, tile);
    if (clipped == nullptr) return cover;
    const Side side = SideOf(border, tile);
    const SideCover& sides = clipped->sides[side];
    cover.step = sides.step, cover.of_tile = sides.of_tile, cover.height = sides.height;
    const double line = joint_.squares.at(TileOf(border, tile)).side[side];
    for (const ClipVertex& v : clipped->vertices) {
      if (v.position[AxisOf(side)] != line) continue;
      const double t = v.position[1 - AxisOf(side)];
      if (v.outside) {
        cover.outside.insert(t);
      } else {
        cover.crossing.emplace(t, v.position.z());
      }
    }
    for (const BoundaryVertex& v : joint_.own.at(TileOf(border, tile))->vertices) {
      if (v.index < 0 && v.position[AxisOf(side)] == line) cover.outside.insert(v.position[1 - AxisOf(side)]);
    }
    return cover;
  }

  // The stretches of a line where one tile has surface and the other has not are edges of the one that has.
  void AddBorder(const Border& border) {
    const int tile = ClippedOf(border, 0) != nullptr ? 0 : 1;
    const CellId cell = TileOf(border, tile);
    const auto fixed = fixed_.On(cell, SideOf(border, tile), joint_.squares.at(cell), area_rings_ != nullptr);
    for (const LineRun& run : FindLineRuns({CoverOf(border, 0), CoverOf(border, 1)}, fixed))
      AddRun(border, run, joint_);
  }

  inline static const SurveyRecord kNoTile;

  const PlanInput& input_;
  const GridLines& own_;
  const double lattice_step_;
  const std::vector<Ring>* area_rings_;  // none: all cells
  JointTiles& joint_;
  std::map<CellId, ClippedTile> clipped_;
  FixedPlaces fixed_;
};

}  // namespace

JointTiles JoinTiles(const PlanInput& input, const GridLines& own, double lattice_step,
                     const std::vector<Ring>* area_rings) {
  JointTiles joint;
  Joiner(input, own, lattice_step, area_rings, joint).Run();
  return joint;
}

}  // namespace tilemend
