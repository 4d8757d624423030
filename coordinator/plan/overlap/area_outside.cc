#include "coordinator/plan/overlap/area_outside.h"

#include <algorithm>
#include <map>
#include <utility>

#include "common/mesh/rounding.h"
#include "coordinator/plan/seam/area_ring.h"
#include "coordinator/plan/types/cell_side.h"

namespace tilemend {
namespace {

using Ring = std::vector<Point2>;

constexpr double kInBox = 1e-6;  // metres: what is so far inside its side lies in the box
constexpr double kOff = 2;       // kOnLine, or steps of the lattice: how far edges of the area go off a grid line

// An edge of a ring that runs along an axis' grid lines; `inside`: the sign of the way into the area.
struct AlongLine {
  int axis;
  double line, low, high, inside;
};

AlongLine AlongLineOf(const Point2& a, const Point2& b, int axis) {
  const auto [low, high] = std::minmax(a[1 - axis], b[1 - axis]);
  return {axis, a[axis], low, high, (b[1 - axis] > a[1 - axis]) == (axis == 0) ? 1.0 : -1.0};
}

// Whether a cell outside the area ends along the edge.
bool RunsAlongACell(const AlongLine& edge, const GridLines& lines) {
  const int across = 2 * edge.axis, along = 2 * (1 - edge.axis);
  return std::any_of(lines.coordinate.begin(), lines.coordinate.end(), [&](const auto& cell) {
    const std::array<double, 4>& sides = cell.second;
    return std::abs(sides[across + (edge.inside > 0 ? 1 : 0)] - edge.line) <= kOnLine &&
           sides[along] < edge.high - kOnLine && sides[along + 1] > edge.low + kOnLine;
  });
}

// Whether a line of the grid runs there, within a hair.
bool IsOnGridLine(double coordinate, int axis, const GridLines& lines) {
  return std::any_of(lines.coordinate.begin(), lines.coordinate.end(), [&](const auto& cell) {
    return std::abs(cell.second[2 * axis] - coordinate) <= kOnLine ||
           std::abs(cell.second[2 * axis + 1] - coordinate) <= kOnLine;
  });
}

// How far a corner is to go off a line that it touches, and the ring does not pass there.
double OffTouchedLine(const Point2& before, const Point2& corner, const Point2& after, int axis, double off,
                      const GridLines& lines) {
  const double to_before = before[axis] - corner[axis], to_after = after[axis] - corner[axis];
  const bool touches = std::min(std::abs(to_before), std::abs(to_after)) > kOnLine && to_before * to_after > 0;
  return touches && IsOnGridLine(corner[axis], axis, lines) ? std::copysign(off, to_before) : 0;
}

// The ring with edges on a line between two cells, and corners that touch a line, a hair beside it: on the line there
// are vertices of the clipped tiles, too.
Ring OffGridLines(const Ring& ring, const SeamSite& site) {
  const double off = kOff * std::max(kOnLine, site.lattice_step);
  Ring moved = ring;
  for (size_t i = 0; i < ring.size(); ++i) {
    const size_t k = (i + 1) % ring.size(), h = (i + ring.size() - 1) % ring.size();
    for (const int axis : {0, 1}) {
      moved[i][axis] += OffTouchedLine(ring[h], ring[i], ring[k], axis, off, site.lines);
      if (std::abs(ring[i][axis] - ring[k][axis]) > kOnLine) continue;
      const AlongLine edge = AlongLineOf(ring[i], ring[k], axis);
      if (RunsAlongACell(edge, site.lines)) moved[i][axis] = moved[k][axis] = edge.line + edge.inside * off;
    }
  }
  return moved;
}

// The area's rings off the grid lines. Where two met on a line they cross when they have left it, and are united.
std::vector<Ring> RingsOffGridLines(const SeamSite& site, const PlanePolygon& area) {
  std::vector<Ring> rings = OrientedRings(area, site);
  std::vector<Ring> off;
  for (const Ring& ring : rings) off.push_back(OffGridLines(ring, site));
  if (off == rings) return rings;
  return UnitedRings(std::move(off));
}

// What of a ring lies inside one side of a box; along the side it closes (Sutherland and Hodgman 1974).
Ring Inside(const Ring& ring, Side side, double line, double lattice_step) {
  const int axis = AxisOf(side);
  const auto out = [&](const Point2& p) { return (p[axis] - line) * OutwardOf(side); };
  Ring inside;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Point2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
    if (out(a) <= 0) inside.push_back(a);
    if (out(a) * out(b) >= 0) continue;
    Point2 p = a + (line - a[axis]) / (b[axis] - a[axis]) * (b - a);
    p[axis] = line;
    p[1 - axis] = std::clamp(RoundedToLattice(p[1 - axis], lattice_step), std::min(a[1 - axis], b[1 - axis]),
                             std::max(a[1 - axis], b[1 - axis]));
    inside.push_back(p);
  }
  return inside;
}

// Numbers points, equal ones once, and drops edges that run to and fro.
class OutsideBuilder {
 public:
  explicit OutsideBuilder(AreaOutside& outside) : outside_(outside) {}

  void AddRing(const Ring& ring) {
    for (size_t i = 0; i < ring.size(); ++i) {
      const int32_t a = NumberOf(ring[i]), b = NumberOf(ring[(i + 1) % ring.size()]);
      if (a != b) outside_.edges.push_back({a, b});
    }
  }

 private:
  int32_t NumberOf(const Point2& p) {
    const auto [it, fresh] = number_.try_emplace({p.x(), p.y()}, static_cast<int32_t>(outside_.points.size()));
    if (fresh) outside_.points.push_back(p);
    return it->second;
  }

  AreaOutside& outside_;
  std::map<std::pair<double, double>, int32_t> number_;
};

bool IsWholeBox(const Ring& ring, const std::array<double, 4>& box) {
  return std::all_of(ring.begin(), ring.end(), [&](const Point2& p) {
    return (p.x() == box[kWest] || p.x() == box[kEast]) && (p.y() == box[kSouth] || p.y() == box[kNorth]);
  });
}

}  // namespace

std::vector<Ring> SpacedRings(const SeamSite& site, const PlanInput& input) {
  const RingSpacer spacer(site);
  std::vector<Ring> rings;
  for (const Ring& ring : RingsOffGridLines(site, input.area)) {
    Ring& spaced = rings.emplace_back();
    for (const RingVertex& v : spacer.Around(ring)) spaced.push_back(v.position);
  }
  return rings;
}

bool AreaOutside::Contains(const Point2& at) const {
  if (empty()) return false;
  Point2 p;
  for (const int axis : {0, 1}) p[axis] = std::clamp(at[axis], box[2 * axis] + kInBox, box[2 * axis + 1] - kInBox);
  int winding = 0;
  for (const DirectedEdge& e : edges) {
    const Point2 &a = points[e.from], &b = points[e.to];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    const bool up = b.y() > a.y();
    const double turn = (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
    if (up && turn > 0) ++winding;
    if (!up && turn < 0) --winding;
  }
  return winding > 0;
}

AreaOutside OutsideIn(const std::vector<Ring>& rings, const std::array<double, 4>& box, double lattice_step) {
  AreaOutside outside{box, {}, {}};
  std::vector<Ring> parts;
  for (Ring ring : rings) {
    for (const Side s : kSides) ring = Inside(ring, s, box[s], lattice_step);
    if (ring.size() >= 3) parts.push_back(std::move(ring));
  }
  if (parts.size() == 1 && IsWholeBox(parts[0], box)) return outside;
  OutsideBuilder builder(outside);
  builder.AddRing(
      {{box[kWest], box[kSouth]}, {box[kEast], box[kSouth]}, {box[kEast], box[kNorth]}, {box[kWest], box[kNorth]}});
  for (const Ring& ring : parts) builder.AddRing(ring);
  return outside;
}

}  // namespace tilemend
