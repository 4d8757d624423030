#include "coordinator/plan/seam/area_ring.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "common/mesh/rounding.h"
#include "common/mesh/segment_distance.h"
#include "common/mesh/winding/simple_rings.h"
#include "coordinator/plan/seam/seam_vertices.h"

namespace tilemend {
namespace {

constexpr double kRingTolerance = 1e-6;  // metres: a point this far beside an edge tells its sides apart
// Of the wanted edge length: new vertices nearer than this to the rim or the vertex before are left out.
constexpr double kClearance = 0.3;
constexpr double kClearanceOfCorners = 0.1;  // of the polygon
constexpr int kWays = 16;                    // that a corner may be moved
constexpr double kBefore = 1e-6;             // of a segment: the line round a ring begins so far before its first point

// Where a new vertex may be.
struct Place {
  Point2 position;
  bool corner = false;  // of the polygon
};

// Turns a ring so that it has the inside of the polygon on its right.
void OrientRing(const PlanePolygon& area, std::vector<Point2>& ring) {
  const auto after = [&](size_t i) { return ring[(i + 1) % ring.size()]; };
  size_t longest = 0;
  for (size_t i = 0; i < ring.size(); ++i) {
    if ((after(i) - ring[i]).norm() > (after(longest) - ring[longest]).norm()) longest = i;
  }
  const Point2 d = (after(longest) - ring[longest]).normalized();
  if (!Contains(area, (ring[longest] + after(longest)) / 2 + kRingTolerance * Point2(d.y(), -d.x()))) {
    std::reverse(ring.begin(), ring.end());
  }
}

// Counter-clockwise from one direction to another, radians.
double Turn(const Point2& from, const Point2& to) {
  const double turn = std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
  return turn < 0 ? turn + 2 * std::numbers::pi : turn;
}

Point2 Way(double angle) { return {std::cos(angle), std::sin(angle)}; }

// Corner i of an oriented ring. One that is too near to the rim, with no surface inside the ring, is moved out of it on
// to surface: to the place farthest off the rim among some around it. If there is none, or too little, it stays.
Point2 OffRim(const std::vector<Point2>& ring, size_t i, const SeamSite& site) {
  const Point2& p = ring[i];
  const double size = SeamSizeAt(site, p), clearance = kClearanceOfCorners * size;
  if (site.index.Distance(p, size) >= clearance) return p;
  const Point2 before = ring[(i + ring.size() - 1) % ring.size()] - p, after = ring[(i + 1) % ring.size()] - p;
  const Point2 inward = Way(std::atan2(before.y(), before.x()) + Turn(before, after) / 2);
  if (site.index.InSurface(p + 2 * clearance * inward, kRingTolerance)) return p;
  Point2 best = p;
  double farthest = clearance;
  for (int k = 0; k < kWays; ++k) {
    const Point2 way = Way(2 * std::numbers::pi * k / kWays), q = p + 2 * clearance * way;
    const double distance = site.index.Distance(q, size);
    const bool is_outside = Turn(after, way) < Turn(after, before);
    if (distance <= farthest || !is_outside || !site.index.InSurface(q, kRingTolerance)) continue;
    farthest = distance;
    best = q;
  }
  return best;
}

}  // namespace

std::vector<std::vector<Point2>> OrientedRings(const PlanePolygon& area, const SeamSite& site) {
  std::vector<std::vector<Point2>> rings = area.rings;
  bool is_moved = false;
  for (std::vector<Point2>& ring : rings) {
    OrientRing(area, ring);
    std::vector<Point2> moved;
    for (size_t i = 0; i < ring.size(); ++i) moved.push_back(OffRim(ring, i, site));
    is_moved = is_moved || moved != ring;
    ring = std::move(moved);
  }
  return is_moved ? UnitedRings(std::move(rings)) : rings;
}

std::vector<std::vector<Point2>> UnitedRings(std::vector<std::vector<Point2>> rings) {
  for (std::vector<Point2>& ring : rings) std::ranges::reverse(ring);
  rings = SimpleRings(rings, Wound::kLeft);
  for (std::vector<Point2>& ring : rings) std::ranges::reverse(ring);
  return rings;
}

RingSpacer::RingSpacer(const SeamSite& site) : site_(site) {
  for (const auto& [cell, lines] : site.lines.coordinate) {
    for (const Side side : kSides) grid_lines_.insert({AxisOf(side), lines[side]});
  }
}

std::vector<RingVertex> RingSpacer::Along(const std::vector<Point2>& line) const {
  std::vector<Place> places;
  for (size_t i = 0; i + 1 < line.size(); ++i) {
    if (i > 0) places.push_back({line[i], true});
    const std::vector<Point2> knots = AtGridLines(line[i], line[i + 1]);
    for (size_t k = 0; k + 1 < knots.size(); ++k) {
      if (k > 0) places.push_back({knots[k]});
      for (const Point2& p : SpacedBetween(site_, knots[k], knots[k + 1])) places.push_back({p});
    }
  }
  if (places.empty()) return {};
  const bool is_closed = line.front() == line.back();
  const Point2 first = is_closed ? places.back().position : line.front();
  const Point2 last = is_closed ? places.front().position : line.back();
  std::vector<RingVertex> vertices;
  for (size_t i = 0; i < places.size(); ++i) {
    const Point2 p = OnLattice(places[i].position);
    const double size = SeamSizeAt(site_, p), clearance = size * (places[i].corner ? kClearanceOfCorners : kClearance);
    const bool on_line = OnGridLine(p);
    if (!vertices.empty() && (vertices.back().position - p).norm() < clearance) {
      if (!on_line || OnGridLine(vertices.back().position)) continue;
      vertices.pop_back();
    }
    const Point2 before = vertices.empty() ? first : vertices.back().position;
    const Point2 after = i + 1 < places.size() ? places[i + 1].position : last;
    const bool can_go = !places[i].corner || DistanceToSegment(p, before, after) < clearance;
    if (!on_line && can_go && site_.index.Distance(p, size) < clearance) continue;
    vertices.push_back({p, size});
  }
  return vertices;
}

std::vector<RingVertex> RingSpacer::Around(const std::vector<Point2>& ring) const {
  const Point2 before = ring[0] + kBefore * (ring.back() - ring[0]);
  std::vector<Point2> line = {before};
  line.insert(line.end(), ring.begin(), ring.end());
  line.push_back(before);
  std::vector<RingVertex> vertices = Along(line);
  if (vertices.size() >= 3) return vertices;
  vertices.clear();
  for (const Point2& corner : ring) vertices.push_back({OnLattice(corner), SeamSizeAt(site_, corner)});
  return vertices;
}

// The ends of a segment, and where it crosses grid lines between, in order.
std::vector<Point2> RingSpacer::AtGridLines(const Point2& a, const Point2& b) const {
  std::map<double, Point2> crossings;
  for (const auto& [axis, line] : grid_lines_) {
    const double t = (line - a[axis]) / (b[axis] - a[axis]);
    if (!(t > 0 && t < 1)) continue;
    Point2 p = a + t * (b - a);
    p[axis] = line;
    crossings.emplace(t, p);
  }
  std::vector<Point2> knots = {a};
  for (const auto& [t, p] : crossings) knots.push_back(p);
  knots.push_back(b);
  return knots;
}

bool RingSpacer::OnGridLine(const Point2& p) const {
  return grid_lines_.contains({0, p.x()}) || grid_lines_.contains({1, p.y()});
}

// On the lattice, but on a grid line where it lies.
Point2 RingSpacer::OnLattice(const Point2& p) const {
  Point2 rounded;
  for (const int axis : {0, 1}) {
    rounded[axis] = grid_lines_.contains({axis, p[axis]}) ? p[axis] : RoundedToLattice(p[axis], site_.lattice_step);
  }
  return rounded;
}

}  // namespace tilemend
