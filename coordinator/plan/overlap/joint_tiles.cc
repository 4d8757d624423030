#include "coordinator/plan/overlap/joint_tiles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tilemend {
namespace {

// Crossings of two tiles that are the same end of surface, this near by the length of the shorter of their edges, are
// put in one place: an edge between them would be too short beside the others.
constexpr double kSamePlace = 0.3;

// Metres inside a grid line: where chains of folded surface are closed.
constexpr double kFoldDepth = 0.01;

// The side that makes the border: b is east or north of a.
using Border = std::pair<CellId, CellId>;

Border BorderOf(CellId cell, Side side) {
  return OutwardOf(side) > 0 ? Border{cell, Across(cell, side)} : Border{Across(cell, side), cell};
}

// Which way along a side its cell lies on the left: +1 towards larger coordinates.
int TurnOf(Side side) { return side == kEast || side == kSouth ? 1 : -1; }

// A vertex on a grid line.
struct LineVertex {
  double t = 0, height = 0;
};

// A crossing, and the tile that has it.
struct OwnedCrossing {
  int tile;  // 0: of Border::first, 1: of Border::second
  size_t place;
  bool surface_above;  // towards larger t
  Crossing* crossing;
};

class Joiner {
 public:
  Joiner(const TileParts& parts, JointTiles& joint)
      : parts_(parts), input_(parts.input), own_(parts.own), joint_(joint) {}

  void Run() {
    joint_.input = input_;
    MakeLines();
    for (const auto& [cell, record] : input_.cells) {
      if (record == nullptr) continue;
      clipped_[cell] = ClipTile(*record, joint_.squares.at(cell));
      AverageCorners(cell);
    }
    for (auto& [cell, clipped] : clipped_) StartRecord(cell);
    std::map<Border, bool> borders;
    for (const auto& [cell, clipped] : clipped_) {
      for (const Side s : kSides) borders[BorderOf(cell, s)] = true;
    }
    for (const auto& [border, unused] : borders) MergeNearCrossings(border);
    for (auto& [cell, clipped] : clipped_) AddInner(cell);
    for (const auto& [border, unused] : borders) AddBorder(border);
    for (auto& [cell, record] : joint_.records) joint_.input.cells[cell] = &record;
  }

 private:
  void MakeLines() {
    joint_.lines.clipped = true;
    joint_.lines.joined = true;
    joint_.lines.tolerance = 0;
    joint_.lines.left_open = own_.left_open;
    for (const auto& [cell, record] : input_.cells) {
      ClipSquare& square = joint_.squares[cell];
      for (const Side s : kSides) {
        square.side[s] = parts_.line.at({cell, s});
        square.cut[s] =
            OutwardOf(s) > 0 ? std::min(square.side[s], own_.At(cell, s)) : std::max(square.side[s], own_.At(cell, s));
        joint_.lines.coordinate[{cell, s}] = square.side[s];
      }
    }
  }

  // The south-west corner of a cell stands for its place.
  static CellId CornerOf(CellId cell, const std::array<Side, 2>& sides) {
    return {cell.col + (sides[0] == kEast), cell.row + (sides[1] == kNorth)};
  }

  void AverageCorners(CellId cell) {
    for (const CornerPoint& c : clipped_[cell].corners) {
      auto& [sum, count] = corner_height_[CornerOf(cell, c.sides)];
      sum += c.height;
      ++count;
    }
  }

  void StartRecord(CellId cell) {
    const SurveyRecord& own = *input_.cells.at(cell);
    SurveyRecord& record = joint_.records[cell];
    record.vertex_count = own.vertex_count;
    record.triangle_count = own.triangle_count;
    record.float32 = own.float32;
    record.lo = own.lo, record.hi = own.hi;
    record.vertices = own.vertices;
    joint_.crossing_edge[cell];
    node_of_crossing_[cell].assign(clipped_[cell].crossings.size(), -1);
  }

  int32_t AddNode(CellId cell, Side side, const LineVertex& v, int32_t edge) {
    SurveyRecord& record = joint_.records.at(cell);
    std::vector<int32_t>& edges = joint_.crossing_edge.at(cell);
    BoundaryVertex node;
    node.index = static_cast<int32_t>(record.vertex_count) + static_cast<int32_t>(edges.size());
    node.position[AxisOf(side)] = joint_.squares.at(cell).side[side];
    node.position[1 - AxisOf(side)] = v.t;
    node.position.z() = node.centroid_height = v.height;
    record.vertices.push_back(node);
    edges.push_back(edge);
    return static_cast<int32_t>(record.vertices.size()) - 1;
  }

  static CellId TileOf(const Border& border, int tile) { return tile == 0 ? border.first : border.second; }
  static Side SideOf(const Border& border, int tile) {
    const bool vertical = border.first.row == border.second.row;
    return vertical ? (tile == 0 ? kEast : kWest) : (tile == 0 ? kNorth : kSouth);
  }

  std::vector<OwnedCrossing> CrossingsOf(const Border& border) {
    std::vector<OwnedCrossing> all;
    for (const int tile : {0, 1}) {
      const auto it = clipped_.find(TileOf(border, tile));
      if (it == clipped_.end()) continue;
      const Side side = SideOf(border, tile);
      for (size_t i = 0; i < it->second.crossings.size(); ++i) {
        Crossing& c = it->second.crossings[i];
        // Going out, the surface lies on the left of the edge.
        if (c.side == side) all.push_back({tile, i, c.leaves == (TurnOf(side) > 0), &c});
      }
    }
    std::sort(all.begin(), all.end(), [](const OwnedCrossing& a, const OwnedCrossing& b) {
      if (a.crossing->t != b.crossing->t) return a.crossing->t < b.crossing->t;
      return std::pair(a.tile, a.place) < std::pair(b.tile, b.place);
    });
    return all;
  }

  void MergeNearCrossings(const Border& border) {
    std::vector<OwnedCrossing> all = CrossingsOf(border);
    for (size_t i = 0; i + 1 < all.size(); ++i) {
      Crossing &a = *all[i].crossing, &b = *all[i + 1].crossing;
      if (all[i].tile == all[i + 1].tile || all[i].surface_above != all[i + 1].surface_above) continue;
      if (b.t - a.t > kSamePlace * std::min(a.length, b.length)) continue;
      a.t = b.t = (a.t + b.t) / 2;
      a.height = b.height = (a.height + b.height) / 2;
      ++i;
    }
  }

  void AddInner(CellId cell) {
    const ClippedTile& clipped = clipped_.at(cell);
    std::vector<int32_t>& nodes = node_of_crossing_.at(cell);
    for (size_t i = 0; i < nodes.size(); ++i) {
      const Crossing& c = clipped.crossings[i];
      nodes[i] = AddNode(cell, c.side, {c.t, c.height}, c.edge);
    }
    const auto end = [&](const ClipEnd& e) { return e.crossing >= 0 ? nodes[e.crossing] : e.vertex; };
    for (const InnerPart& part : clipped.inner) {
      joint_.records.at(cell).edges.push_back({end(part.from), end(part.to)});
    }
  }

  // What one tile has along a line.
  struct Coverage {
    std::map<double, int> step;         // how much more surface there is from here on
    std::map<double, double> height;    // of its own vertices, pressed to the line
    std::map<double, double> crossing;  // of its crossings
  };

  Coverage CoverageOf(const Border& border, int tile) const {
    Coverage coverage;
    const auto it = clipped_.find(TileOf(border, tile));
    if (it == clipped_.end()) return coverage;
    const Side side = SideOf(border, tile);
    for (const SidePart& part : it->second.at_side) {
      if (part.side != side) continue;
      const auto take = [&](LineVertex v, int32_t crossing, int step) {
        if (crossing >= 0) {
          const Crossing& c = it->second.crossings[crossing];
          v = {c.t, c.height};
          coverage.crossing.emplace(v.t, v.height);
        }
        coverage.step[v.t] += step;
        coverage.height.emplace(v.t, v.height);
      };
      take({part.from, part.from_height}, part.from_crossing, TurnOf(side));
      take({part.to, part.to_height}, part.to_crossing, -TurnOf(side));
    }
    return coverage;
  }

  // The stretches of a line where one tile has surface and the other has not are edges of the one that has.
  void AddBorder(const Border& border) {
    const Coverage of[2] = {CoverageOf(border, 0), CoverageOf(border, 1)};
    std::map<double, bool> places;  // along the line, and whether a tile's coverage begins or ends there
    for (const Coverage& c : of) {
      for (const auto& [t, step] : c.step) places[t];
    }
    for (const int k : {0, 1}) AddFolds(border, of, k);
    std::vector<LineVertex> run;
    int surface[2] = {0, 0}, owner = -1;
    for (const auto& [t, unused] : places) {
      for (const int k : {0, 1}) {
        if (const auto it = of[k].step.find(t); it != of[k].step.end()) surface[k] += it->second;
      }
      const int next = surface[0] > 0 && surface[1] <= 0 ? 0 : surface[1] > 0 && surface[0] <= 0 ? 1 : -1;
      if (owner >= 0 && (next != owner || of[owner].height.contains(t))) run.push_back(VertexAt(border, of, owner, t));
      if (next == owner) continue;
      if (owner >= 0) AddRun(border, owner, run);
      owner = next;
      run.clear();
      if (owner >= 0) run.push_back(VertexAt(border, of, owner, t));
    }
  }

  // Where a tile's surface lies over itself at a line, the chains that end within are closed by ways just inside it.
  void AddFolds(const Border& border, const Coverage (&of)[2], int tile) {
    int surface = 0, extra = 0;
    double from = 0;
    for (const auto& [t, step] : of[tile].step) {
      surface += step;
      const int next = surface > 0 ? surface - 1 : surface;
      if (next == extra) continue;
      for (int k = 0; k < std::abs(extra); ++k) AddFold(border, of, tile, from, t, extra > 0);
      extra = next;
      from = t;
    }
  }

  void AddFold(const Border& border, const Coverage (&of)[2], int tile, double from, double to, bool covered) {
    const Side side = SideOf(border, tile);
    const LineVertex a = VertexAt(border, of, tile, from), b = VertexAt(border, of, tile, to);
    const CellId cell = TileOf(border, tile);
    SurveyRecord& record = joint_.records.at(cell);
    int32_t first = AddNode(cell, side, a, -1), last = AddNode(cell, side, b, -1);
    const int32_t middle = AddNode(cell, side, {(a.t + b.t) / 2, (a.height + b.height) / 2}, -1);
    record.vertices[middle].position[AxisOf(side)] -= OutwardOf(side) * kFoldDepth;
    if ((TurnOf(side) > 0) != covered) std::swap(first, last);
    record.edges.push_back({first, middle});
    record.edges.push_back({middle, last});
  }

  // A place on a line: its height is that of the crossing there, at a grid corner that of all tiles in the mean.
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
    }
    for (const int k : {owner, 1 - owner}) {
      if (const auto it = of[k].crossing.find(t); it != of[k].crossing.end()) return {t, it->second};
    }
    for (const int k : {owner, 1 - owner}) {
      if (const auto it = of[k].height.find(t); it != of[k].height.end()) return {t, it->second};
    }
    return {t, 0};
  }

  void AddRun(const Border& border, int owner, std::vector<LineVertex> run) {
    const CellId tile = TileOf(border, owner);
    const Side side = SideOf(border, owner);
    if (TurnOf(side) < 0) std::reverse(run.begin(), run.end());
    SurveyRecord& record = joint_.records.at(tile);
    int32_t last = -1;
    for (const LineVertex& v : run) {
      const int32_t node = AddNode(tile, side, v, -1);
      if (last >= 0) record.edges.push_back({last, node});
      last = node;
    }
  }

  const TileParts& parts_;
  const PlanInput& input_;
  const GridLines& own_;
  JointTiles& joint_;
  std::map<CellId, ClippedTile> clipped_;
  std::map<CellId, std::vector<int32_t>> node_of_crossing_;
  std::map<CellId, std::pair<double, int>> corner_height_;  // by the cell north-east of it: sum and count
};

}  // namespace

JointTiles JoinTiles(const TileParts& parts) {
  JointTiles joint;
  Joiner(parts, joint).Run();
  return joint;
}

}  // namespace tilemend
