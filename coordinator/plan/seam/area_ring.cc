#include "coordinator/plan/seam/area_ring.h"

#include <algorithm>
#include <map>

#include "common/mesh/rounding.h"
#include "coordinator/plan/seam/seam_vertices.h"

namespace tilemend {
namespace {

constexpr double kRingTolerance = 1e-6;  // metres: a point this far beside an edge tells its sides apart
// Of the wanted edge length: new vertices nearer than this to the rim or the vertex before are left out.
constexpr double kClearance = 0.3;
constexpr double kClearanceOfCorners = 0.1;  // of the polygon

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

}  // namespace

std::vector<std::vector<Point2>> OrientedRings(const PlanePolygon& area) {
  std::vector<std::vector<Point2>> rings = area.rings;
  for (std::vector<Point2>& ring : rings) OrientRing(area, ring);
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
  std::vector<RingVertex> vertices;
  for (const Place& place : places) {
    const Point2 p = OnLattice(place.position);
    const double size = SeamSizeAt(site_, p), clearance = size * (place.corner ? kClearanceOfCorners : kClearance);
    const bool on_line = OnGridLine(p);
    if (!vertices.empty() && (vertices.back().position - p).norm() < clearance) {
      if (!on_line || OnGridLine(vertices.back().position)) continue;
      vertices.pop_back();
    }
    if (!on_line && site_.index.Distance(p, size) < clearance) continue;
    vertices.push_back({p, size});
  }
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
