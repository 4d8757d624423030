#include "coordinator/plan/seam/projected_places.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "common/mesh/rounding.h"

namespace tilemend {
namespace {

// Of the distance of boundary points: places nearer to one another, or to the rim, are none.
constexpr double kPlaceClearance = 0.5, kRimClearance = 0.4;

bool IsClear(const std::map<double, SeamPlace>& places, double t, double clearance) {
  const auto next = places.lower_bound(t);
  if (next != places.end() && next->first - t < clearance) return false;
  return next == places.begin() || t - std::prev(next)->first >= clearance;
}

// The part of a border's line that no tile reaches over the lines across it.
std::pair<double, double> BetweenStrips(const SeamSite& site, const Border& border) {
  const int along = AxisAlong(border);
  const Corner low = LowCorner(border), high = HighCorner(border);
  return {CornerPosition(low, site.area, site.lines)[along] + OverlapAt(low, along, site.lines),
          CornerPosition(high, site.area, site.lines)[along] - OverlapAt(high, along, site.lines)};
}

}  // namespace

std::vector<BoundaryPlace> RimPlacesBeside(const SeamSite& site, const Border& border) {
  const Corner low = border.first, high{border.second.col + 1, border.second.row + 1};
  const Point2 lo = CornerPosition(low, site.area, site.lines), hi = CornerPosition(high, site.area, site.lines);
  std::set<int32_t> points;
  for (const int32_t e : site.index.EdgesIn(lo, hi)) {
    points.insert(site.rim.edges[e].from);
    points.insert(site.rim.edges[e].to);
  }
  std::vector<BoundaryPlace> places;
  for (const int32_t v : points) {
    const Point2 p = site.rim.points[v].position.head<2>();
    if ((p.array() < lo.array()).any() || (p.array() > hi.array()).any()) continue;
    places.push_back({p, v, site.rim.points[v].size});
  }
  return places;
}

std::vector<SeamPlace> ProjectedPlaces(const SeamSite& site, const Border& border, const Point2& from, const Point2& to,
                                       std::span<const BoundaryPlace> boundary) {
  const int along = AxisAlong(border), across = 1 - along;
  const double line = LineOf(border, site.area, site.lines);
  std::vector<const BoundaryPlace*> nearest_first;
  for (const BoundaryPlace& b : boundary) {
    if (b.position[along] > from[along] && b.position[along] < to[along]) nearest_first.push_back(&b);
  }
  const auto off = [&](const BoundaryPlace* b) { return std::abs(b->position[across] - line); };
  std::stable_sort(nearest_first.begin(), nearest_first.end(),
                   [&](const BoundaryPlace* a, const BoundaryPlace* b) { return off(a) < off(b); });
  const auto [begin, end] = BetweenStrips(site, border);
  std::map<double, SeamPlace> places;
  for (const BoundaryPlace* b : nearest_first) {
    const double t = RoundedToLattice(b->position[along], site.lattice_step), clearance = kPlaceClearance * b->size;
    if (t - std::max(begin, from[along]) < clearance || std::min(end, to[along]) - t < clearance) continue;
    if (!IsClear(places, t, clearance)) continue;
    Point2 p;
    p[along] = t;
    p[across] = line;
    if (site.index.Distance(p, b->size) < kRimClearance * b->size) continue;
    if (site.index.IsFree(b->position, b->rim_point, p, -1)) places[t] = {p};
  }
  std::vector<SeamPlace> in_order;
  for (const auto& [t, place] : places) in_order.push_back(place);
  return in_order;
}

}  // namespace tilemend
