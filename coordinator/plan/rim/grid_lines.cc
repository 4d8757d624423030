#include "coordinator/plan/rim/grid_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "common/mesh/position_index.h"

namespace tilemend {
namespace {

constexpr double kMostOffset = 0.05;     // of a cell: a tile that ends farther from its side ends at a shore, not a cut
constexpr double kStraight = 2e-3;       // metres: an outline whose vertices are this near one coordinate is straight
constexpr double kStraightShare = 0.05;  // of a side's length must run along the outline for it to count
constexpr double kExactShare = 0.9;      // of the boundary near the lines lies on them to the bit: no tolerance needed

double Nominal(const Grid& grid, CellId cell, Side side) {
  const int axis = AxisOf(side);
  const int32_t n = (axis == 0 ? cell.col : cell.row) + (side % 2);
  return grid.corner[axis] + n * grid.cell_size[axis];
}

// How far the straight outline of a tile lies outside its cell's side; nothing if the tile has no straight outline
// there.
std::optional<double> OutlineOffset(const SurveyRecord& record, const Grid& grid, CellId cell, Side side) {
  const int axis = AxisOf(side);
  const double extreme = side % 2 == 0 ? record.lo[axis] : record.hi[axis];
  const double offset = (extreme - Nominal(grid, cell, side)) * OutwardOf(side);
  if (std::abs(offset) > kMostOffset * grid.cell_size[axis]) return std::nullopt;
  double along = 0;
  for (const BoundaryEdge& e : record.edges) {
    const Point3& a = record.vertices[e.from].position;
    const Point3& b = record.vertices[e.to].position;
    if (std::abs(a[axis] - extreme) > kStraight || std::abs(b[axis] - extreme) > kStraight) continue;
    along += std::abs(a[1 - axis] - b[1 - axis]);
  }
  if (along < kStraightShare * grid.cell_size[1 - axis]) return std::nullopt;
  return offset;
}

struct SharedVertices {
  int64_t count = 0;
  int64_t on_line = 0;
};

SharedVertices CountShared(const SurveyRecord& a, const SurveyRecord& b, int axis, double line) {
  PositionIndex index;
  for (const BoundaryVertex& v : a.vertices) index.Insert(v.position);
  SharedVertices shared;
  for (const BoundaryVertex& v : b.vertices) {
    if (index.Find(v.position) < 0) continue;
    ++shared.count;
    if (std::abs(v.position[axis] - line) <= kOnLine) ++shared.on_line;
  }
  return shared;
}

double Median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

// A grid line that runs through the whole scene: its constant axis and its number along it.
using Line = std::pair<int, int32_t>;

Line LineOf(CellId cell, Side side) {
  const int axis = AxisOf(side);
  return {axis, (axis == 0 ? cell.col : cell.row) + side % 2};
}

// How much boundary runs exactly along coordinates near a line, by coordinate, metres.
using LineLengths = std::map<Line, std::map<double, double>>;

struct LineFinding {
  std::map<Line, double> coordinate;  // of the lines that tiles end at
  bool exact = false;                 // nearly all boundary near a line lies on its coordinate to the bit
};

// The lines' coordinates by the boundary edges of all tiles along each: that with the greatest length of edges. An
// edge counts when both of its ends are within kOnLine of the line and it is long enough to have a direction.
LineFinding FindLines(const PlanInput& input) {
  LineLengths lengths;
  std::map<Line, double> all;
  for (const auto& [cell, record] : input.cells) {
    if (record == nullptr) continue;
    for (const Side side : kSides) {
      const int axis = AxisOf(side);
      const double nominal = Nominal(input.grid, cell, side);
      for (const BoundaryEdge& e : record->edges) {
        const Point3& a = record->vertices[e.from].position;
        const Point3& b = record->vertices[e.to].position;
        const double along = std::abs(a[1 - axis] - b[1 - axis]);
        if (std::abs(a[axis] - nominal) > kOnLine || std::abs(b[axis] - nominal) > kOnLine || along < 2 * kOnLine) {
          continue;
        }
        all[LineOf(cell, side)] += along;
        if (a[axis] == b[axis]) lengths[LineOf(cell, side)][a[axis]] += along;
      }
    }
  }
  LineFinding found;
  double exact = 0, near = 0;
  for (const auto& [line, length] : all) near += length;
  for (const auto& [line, by_coordinate] : lengths) {
    const auto longest = std::max_element(by_coordinate.begin(), by_coordinate.end(),
                                          [](const auto& a, const auto& b) { return a.second < b.second; });
    found.coordinate[line] = longest->first;
    exact += longest->second;
  }
  found.exact = near > 0 && exact >= kExactShare * near;
  return found;
}

using Offsets = std::map<std::pair<CellId, int>, double>;

Offsets FindOffsets(const PlanInput& input) {
  Offsets offsets;
  for (const auto& [cell, record] : input.cells) {
    if (record == nullptr || record->vertices.empty()) continue;
    for (const Side side : kSides) {
      if (const auto offset = OutlineOffset(*record, input.grid, cell, side)) offsets[{cell, side}] = *offset;
    }
  }
  return offsets;
}

// Classifies the border of every pair of neighbours and counts what speaks for a clipped and for a ragged cut.
void AuditBorders(const PlanInput& input, const Offsets& offsets, CutLines& lines) {
  int64_t on_line = 0, off_line = 0, straight_on_line = 0;
  std::vector<double> inner;
  for (const auto& [cell, record] : input.cells) {
    for (const Side side : {kEast, kNorth}) {
      const CellId other = Across(cell, side);
      const auto it = input.cells.find(other);
      if (it == input.cells.end()) continue;
      BorderAudit audit{cell, other, BorderKind::kOpen, 0, 0};
      const Side back = static_cast<Side>(side - 1);
      const auto mine = offsets.find({cell, side}), theirs = offsets.find({other, back});
      if (mine != offsets.end()) inner.push_back(mine->second);
      if (theirs != offsets.end()) inner.push_back(theirs->second);
      if (record != nullptr && it->second != nullptr) {
        const auto shared = CountShared(*record, *it->second, AxisOf(side), Nominal(input.grid, cell, side));
        audit.shared_vertices = shared.count;
        on_line += shared.on_line;
        off_line += shared.count - shared.on_line;
        if (mine != offsets.end() && theirs != offsets.end()) {
          audit.offset = mine->second + theirs->second;
          audit.kind = audit.offset > kOnLine    ? BorderKind::kOverlap
                       : audit.offset < -kOnLine ? BorderKind::kGap
                                                 : BorderKind::kNear;
        }
        if (shared.count >= 2) audit.kind = BorderKind::kExact;
        if (audit.kind == BorderKind::kExact) audit.offset = 0;
      }
      lines.borders.push_back(audit);
    }
  }
  for (const auto& [key, offset] : offsets) straight_on_line += std::abs(offset) <= kOnLine;
  if (inner.empty()) {
    for (const auto& [key, offset] : offsets) inner.push_back(offset);
  }
  lines.independent = on_line + off_line == 0 && !inner.empty() && std::abs(Median(inner)) > kStraight;
  lines.clipped = on_line + off_line > 0 ? on_line >= off_line : straight_on_line > 0;
}

// Lines that nothing lies on.
CutLines WithoutGrid(const PlanInput& input) {
  CutLines lines;
  lines.tolerance = -1;
  for (const auto& [cell, record] : input.cells) {
    for (const Side side : kSides) {
      lines.coordinate[{cell, side}] = Nominal(input.grid, cell, side);
      lines.left_open.insert(std::minmax(cell, Across(cell, side)));
    }
  }
  return lines;
}

}  // namespace

CellId Across(CellId cell, Side side) {
  switch (side) {
    case kWest:
      return {cell.col - 1, cell.row};
    case kEast:
      return {cell.col + 1, cell.row};
    case kSouth:
      return {cell.col, cell.row - 1};
    default:
      return {cell.col, cell.row + 1};
  }
}

CutLines FindCutLines(const PlanInput& input, double lattice_step) {
  if (!input.has_grid) return WithoutGrid(input);
  CutLines lines;
  const Offsets offsets = FindOffsets(input);
  AuditBorders(input, offsets, lines);
  const LineFinding found = FindLines(input);
  if (found.exact && lines.clipped) lines.tolerance = 0;
  double usual_offset = 0;
  if (lines.independent) {
    std::vector<double> all;
    for (const auto& [key, offset] : offsets) all.push_back(offset);
    usual_offset = Median(all);
    lines.tolerance = 2 * std::abs(usual_offset) + kStraight;
    lines.piece_reach = 3 * std::abs(usual_offset);
  }
  for (const auto& [cell, record] : input.cells) {
    for (const Side side : kSides) {
      const double nominal = Nominal(input.grid, cell, side);
      const int axis = AxisOf(side);
      double coordinate = std::round(nominal / lattice_step) * lattice_step;
      if (lines.independent) {
        const auto own = offsets.find({cell, side});
        const bool known = own != offsets.end() && record != nullptr;
        coordinate = known ? (side % 2 == 0 ? record->lo[axis] : record->hi[axis])
                           : std::round((nominal + OutwardOf(side) * usual_offset) / lattice_step) * lattice_step;
      } else if (const auto line = found.coordinate.find(LineOf(cell, side)); line != found.coordinate.end()) {
        coordinate = line->second;
      }
      lines.coordinate[{cell, side}] = coordinate;
      const CellId across = Across(cell, side);
      if (!input.area_known && !input.cells.contains(across)) lines.left_open.insert(std::minmax(cell, across));
    }
  }
  return lines;
}

}  // namespace tilemend
