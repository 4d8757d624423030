#include "coordinator/plan/seam/seams_along_rim.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "coordinator/plan/seam/grid_borders.h"

namespace tilemend {
namespace {

// A seam takes an edge from one cell to another.
struct Passing {
  CellId from, to;
};

std::map<int32_t, std::vector<Passing>> FindPassings(const SeamSite& site, std::span<const Seam> seams) {
  const auto rim_points = static_cast<int32_t>(site.rim.points.size());
  std::map<int32_t, std::vector<Passing>> passings;  // by rim edge
  for (const Seam& seam : seams) {
    const CellId left = LeftOf({seam.a, seam.b}), right = RightOf({seam.a, seam.b});
    for (size_t i = 0; i + 1 < seam.vertices.size(); ++i) {
      const int32_t p = seam.vertices[i], q = seam.vertices[i + 1];
      const int32_t e = p < rim_points && q < rim_points ? site.index.EdgeBetween(p, q) : -1;
      if (e < 0) continue;
      // The hole lies to the right of the edge.
      passings[e].push_back(site.rim.edges[e].from == p ? Passing{left, right} : Passing{right, left});
    }
  }
  return passings;
}

// Whether an edge lies on the line between a cell of the area and one outside it, or in the zigzag there: on a ragged
// cut a seam from a neighbour's zigzag to the line may follow edges beside it.
bool LiesOnBorder(const SeamSite& site, const RimEdge& e, CellId inside, CellId outside) {
  if (!site.area.contains(inside)) return false;
  return std::any_of(kSides.begin(), kSides.end(), [&](Side side) {
    if (Across(inside, side) != outside) return false;
    if (site.lines.zigzag.contains({inside, side})) return true;
    const auto on_line = [&](int32_t p) {
      const RimPoint& point = site.rim.points[p];
      const double reach = site.lines.clipped ? kOnLine : std::max(kOnLine, point.reach);
      return std::abs(point.position[AxisOf(side)] - site.lines.At(inside, side)) <= reach;
    };
    return on_line(e.from) && on_line(e.to);
  });
}

}  // namespace

void CloseAlongSeams(const SeamSite& site, std::span<const Seam> seams, ClosingCells& closing) {
  for (auto& [e, passings] : FindPassings(site, seams)) {
    CellId& cell = closing[e];
    while (!passings.empty()) {
      auto next = std::find_if(passings.begin(), passings.end(), [&](const Passing& p) { return p.from == cell; });
      if (next == passings.end()) next = passings.begin();
      if (site.area.contains(next->to) || LiesOnBorder(site, site.rim.edges[e], next->from, next->to)) {
        cell = next->to;
      }
      passings.erase(next);
    }
  }
}

}  // namespace tilemend
