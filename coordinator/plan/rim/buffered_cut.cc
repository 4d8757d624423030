#include "coordinator/plan/rim/buffered_cut.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "common/mesh/position_index.h"
#include "coordinator/plan/types/meet_tolerance.h"

namespace tilemend {
namespace {

constexpr double kLeastShare = 0.05;  // of a border

using DirectedEdges = std::set<std::pair<int32_t, int32_t>>;

// The edges of a tile by the places of their ends.
DirectedEdges EdgesOf(const SurveyRecord& record, PositionIndex& places) {
  DirectedEdges edges;
  for (const BoundaryEdge& e : record.edges) {
    edges.insert({places.Insert(record.vertices[e.from].position), places.Insert(record.vertices[e.to].position)});
  }
  return edges;
}

// Where a tile has surface beyond a line, along it, and how near to the line its zigzag comes.
struct Beyond {
  std::map<double, int> step;  // how many edges more lie there from here on
  std::optional<double> nearest;
};

Beyond FindBeyond(const SurveyRecord& record, const DirectedEdges& of_other, PositionIndex& places, const Grid& grid,
                  CellId cell, Side side) {
  const int axis = AxisOf(side), along = 1 - axis;
  const double line = NominalLine(grid, cell, side),
               begin = grid.corner[along] + (axis == 0 ? cell.row : cell.col) * grid.cell_size[along];
  Beyond beyond;
  for (const BoundaryEdge& e : record.edges) {
    const Point3 &a = record.vertices[e.from].position, &b = record.vertices[e.to].position;
    const double out = std::min((a[axis] - line) * OutwardOf(side), (b[axis] - line) * OutwardOf(side));
    const auto [lo, hi] = std::minmax(a[along], b[along]);
    if (out <= 0 || lo < begin || hi > begin + grid.cell_size[along]) continue;
    if (of_other.contains({places.Insert(a), places.Insert(b)})) continue;
    beyond.nearest = std::min(beyond.nearest.value_or(out), out);
    if (out <= kMeetTolerance) continue;
    ++beyond.step[lo];
    --beyond.step[hi];
  }
  return beyond;
}

// How much of a line both have.
double LengthOfBoth(const Beyond& a, const Beyond& b) {
  std::set<double> places;
  for (const Beyond* beyond : {&a, &b}) {
    for (const auto& [t, more] : beyond->step) places.insert(t);
  }
  double length = 0, last = 0;
  int of_a = 0, of_b = 0;
  for (const double t : places) {
    if (of_a > 0 && of_b > 0) length += t - last;
    last = t;
    if (const auto it = a.step.find(t); it != a.step.end()) of_a += it->second;
    if (const auto it = b.step.find(t); it != b.step.end()) of_b += it->second;
  }
  return length;
}

// Whether most edges that both tiles have run the same way: then both have the triangle beside them.
bool ShareRims(const DirectedEdges& a, const DirectedEdges& b) {
  const auto same = std::count_if(a.begin(), a.end(), [&](const auto& e) { return b.contains(e); });
  const auto turned = std::count_if(a.begin(), a.end(), [&](const auto& e) { return b.contains({e.second, e.first}); });
  return same > turned;
}

}  // namespace

std::optional<Buffers> FindBuffers(const SurveyRecord& record, const SurveyRecord& other, const Grid& grid, CellId cell,
                                   Side side) {
  PositionIndex places;
  const DirectedEdges edges = EdgesOf(record, places), of_other = EdgesOf(other, places);
  const Beyond a = FindBeyond(record, of_other, places, grid, cell, side);
  const Beyond b = FindBeyond(other, edges, places, grid, Across(cell, side), Opposite(side));
  const bool overlap = LengthOfBoth(a, b) >= kLeastShare * grid.cell_size[1 - AxisOf(side)];
  if (!overlap && !ShareRims(edges, of_other)) return std::nullopt;
  return Buffers{a.nearest, b.nearest};
}

}  // namespace tilemend
