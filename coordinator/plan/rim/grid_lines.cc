#include "coordinator/plan/rim/grid_lines.h"

#include <algorithm>
#include <cmath>

#include "common/mesh/rounding.h"

namespace tilemend {
namespace {

constexpr double kExactShare = 0.9;  // of the boundary near the lines lies on them to the bit: no tolerance needed

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
    const auto outline = record.Outline();
    for (const Side side : kSides) {
      const int axis = AxisOf(side);
      const double nominal = NominalLine(input.grid, cell, side);
      for (const BoundaryEdge& e : outline->edges) {
        const Point3& a = outline->vertices[e.from].position;
        const Point3& b = outline->vertices[e.to].position;
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

// Lines that nothing lies on.
GridLines WithoutGrid(const PlanInput& input) {
  GridLines lines;
  lines.tolerance = -1;
  for (const auto& [cell, record] : input.cells) {
    for (const Side side : kSides) {
      lines.coordinate[cell][side] = NominalLine(input.grid, cell, side);
      lines.left_open.insert(std::minmax(cell, Across(cell, side)));
    }
  }
  return lines;
}

// Every side at its line.
void PlaceOnLines(const PlanInput& input, const std::map<Line, double>& found, double lattice_step, GridLines& lines) {
  for (const auto& [cell, record] : input.cells) {
    for (const Side side : kSides) {
      const auto line = found.find(LineOf(cell, side));
      lines.coordinate[cell][side] =
          line != found.end() ? line->second : RoundedToLattice(NominalLine(input.grid, cell, side), lattice_step);
    }
  }
}

// Every side at its tile's own outline, or where the outlines of the others let expect it.
void PlaceOnOutlines(const PlanInput& input, const BorderFindings& borders, double lattice_step, GridLines& lines) {
  const double usual = borders.usual_offset;
  lines.pieces.reach = 3 * std::abs(usual);
  for (const auto& [cell, record] : input.cells) {
    for (const Side side : kSides) {
      const auto buffer = borders.buffers.find({cell, side});
      const double offset = buffer != borders.buffers.end() ? buffer->second : usual;
      const double expected = NominalLine(input.grid, cell, side) + OutwardOf(side) * offset;
      const bool straight = buffer == borders.buffers.end() && borders.offsets.contains({cell, side});
      lines.coordinate[cell][side] =
          straight ? (side % 2 == 0 ? record->lo : record->hi)[AxisOf(side)] : RoundedToLattice(expected, lattice_step);
    }
  }
}

bool EndsInZigzag(const SurveyRecord& record, const Grid& grid, CellId cell, Side side) {
  const double line = NominalLine(grid, cell, side);
  int64_t beyond = 0, on_line = 0;
  for (const BoundaryVertex& v : record.vertices) {
    const double out = (v.position[AxisOf(side)] - line) * OutwardOf(side);
    beyond += out > kOnLine;
    on_line += std::abs(out) <= kOnLine;
  }
  return beyond > on_line;
}

// Calls `use` for every side of a cell at the rim of the area.
template <typename Use>
void ForSidesAtRim(const PlanInput& input, const Use& use) {
  for (const auto& [cell, record] : input.cells) {
    for (const Side side : kSides) {
      if (!input.cells.contains(Across(cell, side))) use(cell, record, side);
    }
  }
}

}  // namespace

GridLines FindGridLines(const PlanInput& input, const BorderFindings& borders, double lattice_step) {
  if (!input.has_grid) return WithoutGrid(input);
  GridLines lines;
  lines.clipped = borders.clipped;
  const LineFinding found = FindLines(input);
  if (found.exact && lines.clipped) lines.tolerance = 0;
  if (borders.independent) {
    PlaceOnOutlines(input, borders, lattice_step, lines);
  } else {
    PlaceOnLines(input, found.coordinate, lattice_step, lines);
  }
  ForSidesAtRim(input, [&](CellId cell, const StoredRecord& record, Side side) {
    if (!input.area_known) lines.left_open.insert(std::minmax(cell, Across(cell, side)));
    if (borders.independent || lines.clipped || record == nullptr) return;
    if (EndsInZigzag(*record.Outline(), input.grid, cell, side)) lines.zigzag.insert({cell, side});
  });
  return lines;
}

}  // namespace tilemend
