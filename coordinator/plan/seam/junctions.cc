#include "coordinator/plan/seam/junctions.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include "absl/strings/str_format.h"
#include "common/mesh/segment_distance.h"

namespace tilemend {
namespace {

constexpr double kRimTolerance = 1e-3;  // metres: a grid corner this near the rim lies on it
constexpr double kOutlineReach = 4;     // mean edges of the rim: no edge of it is longer where it counts

// Whether the outline of a ragged surface, which the corner may lie off by an edge's length, passes by it.
bool LiesOnOutline(const SeamSite& site, const ClosingCells& closing, const Point2& corner) {
  const Point2 reach = Point2::Constant(kOutlineReach * site.index.mean_size());
  double nearest = std::numeric_limits<double>::infinity();
  bool outline = false;
  for (const int32_t i : site.index.EdgesIn(corner - reach, corner + reach)) {
    const RimPoint& a = site.rim.points[site.rim.edges[i].from];
    const RimPoint& b = site.rim.points[site.rim.edges[i].to];
    const double distance = DistanceToSegment(corner, Point2(a.position.head<2>()), Point2(b.position.head<2>()));
    if (distance > std::max(a.reach, b.reach) || distance >= nearest) continue;
    nearest = distance;
    outline = !site.area.contains(closing[i]);
  }
  return outline;
}

bool LiesInHole(const SeamSite& site, const ClosingCells& closing, Corner corner) {
  const Point2 p = CornerPosition(corner, site.area, site.lines);
  if (site.index.InSurface(p, kRimTolerance)) return false;
  const bool ragged = !site.lines.zigzag.empty() && TouchesOutside(corner, site.area);
  return !ragged || !LiesOnOutline(site, closing, p);
}

// The rim passes from cell a to its neighbour b at `point`, with the hole on the right.
void AddJunction(const SeamSite& site, CellId a, CellId b, int32_t point, Junctions& junctions) {
  const bool forward = a < b;
  const Border border = std::minmax(a, b);
  if (!IsOfArea(border, site.area)) return;
  // Going east over a vertical line the hole is to the south; going north over a horizontal line it is to the east.
  const bool start = IsVertical(border) ? !forward : forward;
  junctions.along[border].push_back({site.rim.points[point].position[AxisAlong(border)], point, start});
}

void Pass(const SeamSite& site, CellId a, CellId b, int32_t point, Junctions& junctions) {
  if (a == b) return;
  if (std::abs(b.col - a.col) + std::abs(b.row - a.row) == 1) {
    AddJunction(site, a, b, point, junctions);
  } else if (AreDiagonal(a, b)) {
    const CellId right = RightOfDiagonal(a, b);
    AddJunction(site, a, right, point, junctions);
    AddJunction(site, right, b, point, junctions);
  } else if (site.area.contains(a) || site.area.contains(b)) {
    const Point3& p = site.rim.points[point].position;
    junctions.failures.push_back(
        {site.area.contains(a) ? a : b,
         absl::StrFormat("at (%.3f, %.3f) an edge of the surface spans a whole cell", p.x(), p.y())});
  }
}

int64_t EndsLessStarts(std::span<const Junction> junctions) {
  const auto starts = std::count_if(junctions.begin(), junctions.end(), [](const Junction& j) { return j.start; });
  return std::ssize(junctions) - 2 * starts;
}

// Whether the border begins in a hole: by its first junctions, if those leave it open by all of them.
bool StartsInside(const SeamSite& site, const ClosingCells& closing, const Border& border,
                  std::span<const Junction> first, std::span<const Junction> all) {
  for (const auto junctions : {first, all}) {
    const int64_t more = EndsLessStarts(junctions);
    if (more != 0) return more > 0;
  }
  return LiesInHole(site, closing, LowCorner(border));
}

// Makes starts and ends take turns, as far as there are some of each.
void Alternate(std::span<Junction> together, bool& inside) {
  for (size_t i = 0; i < together.size(); ++i) {
    size_t next = i;
    while (next < together.size() && together[next].start == inside) ++next;
    if (next < together.size()) {
      const auto begin = together.begin();
      std::rotate(begin + static_cast<ptrdiff_t>(i), begin + static_cast<ptrdiff_t>(next),
                  begin + static_cast<ptrdiff_t>(next) + 1);
    }
    inside = together[i].start;
  }
}

void SortJunctions(const SeamSite& site, const ClosingCells& closing, const Border& border,
                   std::vector<Junction>& junctions) {
  std::sort(junctions.begin(), junctions.end(), [](const Junction& a, const Junction& b) {
    if (a.t != b.t) return a.t < b.t;
    if (a.start != b.start) return !a.start;  // one hole ends before the next begins
    return a.point < b.point;
  });
  bool inside = false;
  for (size_t begin = 0; begin < junctions.size();) {
    size_t end = begin + 1;
    while (end < junctions.size() && junctions[end].t - junctions[end - 1].t <= site.lines.tolerance) ++end;
    const std::span<Junction> together(junctions.data() + begin, end - begin);
    if (begin == 0) inside = StartsInside(site, closing, border, together, junctions);
    Alternate(together, inside);
    begin = end;
  }
}

}  // namespace

Junctions FindJunctions(const SeamSite& site, const ClosingCells& closing) {
  Junctions junctions;
  for (const std::vector<int32_t>& loop : site.rim.loops) {
    for (size_t k = 0; k < loop.size(); ++k) {
      const int32_t next = loop[(k + 1) % loop.size()];
      Pass(site, closing[loop[k]], closing[next], site.rim.edges[loop[k]].to, junctions);
    }
  }
  for (auto& [border, of_border] : junctions.along) SortJunctions(site, closing, border, of_border);
  return junctions;
}

std::set<Corner> FindCornersInHoles(const SeamSite& site, const ClosingCells& closing, const Junctions& junctions) {
  struct Votes {
    int hole = 0, surface = 0;
  };
  std::map<Corner, Votes> votes;
  for (const auto& [border, of_border] : junctions.along) {
    Votes& low = votes[LowCorner(border)];
    Votes& high = votes[HighCorner(border)];
    ++(of_border.front().start ? low.surface : low.hole);
    ++(of_border.back().start ? high.hole : high.surface);
  }
  std::set<Corner> in_hole;
  ForCorners(site.area, [&](Corner corner) {
    const auto vote = votes.find(corner);
    const int lead = vote == votes.end() ? 0 : vote->second.hole - vote->second.surface;
    if (lead > 0 || (lead == 0 && LiesInHole(site, closing, corner))) in_hole.insert(corner);
  });
  return in_hole;
}

}  // namespace tilemend
