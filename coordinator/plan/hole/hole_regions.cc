#include "coordinator/plan/hole/hole_regions.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "common/mesh/exact_signs.h"
#include "coordinator/plan/hole/closed_loops.h"
#include "coordinator/plan/hole/hole_types.h"
#include "coordinator/plan/hole/measure_hole.h"
#include "coordinator/plan/hole/open_holes.h"
#include "coordinator/plan/hole/planar_regions.h"

namespace tilemend {
namespace {

struct ClosedHole {
  ClosedLoop loop;
  PlanarRegions regions;  // empty if it does not project
  std::vector<std::vector<RimSegment>> islands;

  bool Projects() const { return !regions.triangulation.triangles.empty(); }
};

// Whether the segments, which form loops, wind around a point as they do around a hole. They may cross.
bool WindAround(const std::vector<RimSegment>& segments, const Point2& p, const std::vector<Point3>& position) {
  int winding = 0;
  for (const RimSegment& s : segments) {
    const Point2 a = position[s.from].head<2>(), b = position[s.to].head<2>();
    if (a.y() <= p.y() && b.y() > p.y()) winding += TurnOf(a, b, p) > 0;
    if (a.y() > p.y() && b.y() <= p.y()) winding -= TurnOf(a, b, p) < 0;
  }
  return winding > 0;
}

// Makes a piece that faces up an island of the hole that it lies in, seen from above. In a pond on an island of a lake
// there are two: the smaller one is it.
bool PlaceInPlane(const HoleSite& site, const ClosedLoop& outline, OpenHoles& open, std::vector<ClosedHole>& closed) {
  const Point2 p = site.position[outline.segments[0].from].head<2>();
  double least = std::numeric_limits<double>::infinity();
  PlannedHole* in_open = nullptr;
  ClosedHole* in_closed = nullptr;
  for (const OpenHoles::Place& place : open.places) {
    const PlanarRegions& regions = open.regions[place.regions];
    const double area = regions.area[static_cast<size_t>(place.component)];
    if (area >= least || !Contains(regions, place.component, p, site.position)) continue;
    least = area;
    in_open = &open.holes[place.hole];
  }
  for (ClosedHole& hole : closed) {
    if (!hole.Projects() || hole.regions.area[0] >= least || !Contains(hole.regions, 0, p, site.position)) continue;
    least = hole.regions.area[0];
    in_closed = &hole;
  }
  if (in_closed != nullptr) {
    in_closed->islands.push_back(outline.segments);
  } else if (in_open != nullptr) {
    in_open->segments.insert(in_open->segments.end(), outline.segments.begin(), outline.segments.end());
    in_open->area += outline.vector_area.z();  // negative
  }
  return in_closed != nullptr || in_open != nullptr;
}

// The same of open holes whose boundary crosses itself.
bool PlaceInFolded(const HoleSite& site, const ClosedLoop& outline, OpenHoles& open) {
  const Point2 p = site.position[outline.segments[0].from].head<2>();
  for (PlannedHole& hole : open.holes) {
    if (hole.projects || !hole.failure.empty() || !WindAround(hole.segments, p, site.position)) continue;
    hole.segments.insert(hole.segments.end(), outline.segments.begin(), outline.segments.end());
    hole.area = std::abs(VectorArea(hole.segments, site.position).z());  // folds may make the piece the larger one
    return true;
  }
  return false;
}

// Makes a piece an island of the smallest closed hole that it lies in, in space.
bool PlaceInSpace(const HoleSite& site, const ClosedLoop& outline, std::vector<ClosedHole>& closed) {
  double least = std::numeric_limits<double>::infinity();
  ClosedHole* found = nullptr;
  for (ClosedHole& hole : closed) {
    const double area = hole.loop.vector_area.norm();
    if (area >= least || !LiesIn(site, outline, hole.loop)) continue;
    least = area;
    found = &hole;
  }
  if (found == nullptr) return false;
  found->islands.push_back(outline.segments);
  found->regions = {};  // with the piece it does not project
  return true;
}

PlannedHole PlanClosed(const HoleSite& site, CellId cell, const ClosedHole& closed) {
  PlannedHole hole = MeasureHole(cell, closed.loop.segments, site.position);
  hole.projects = closed.Projects();
  hole.area = closed.loop.vector_area.norm();
  hole.single = ClassifySingle(closed.loop.segments, closed.islands, site.position);
  if (hole.projects) hole.area = std::accumulate(closed.regions.area.begin(), closed.regions.area.end(), 0.0);
  for (const std::vector<RimSegment>& island : closed.islands) {
    hole.segments.insert(hole.segments.end(), island.begin(), island.end());
    const Eigen::Vector3d area = VectorArea(island, site.position);
    hole.area -= hole.projects ? -area.z() : area.norm();
  }
  hole.area = std::abs(hole.area);  // a piece may be larger than the loop around it: in space, or where that folds
  return hole;
}

}  // namespace

FoundHoles FindHoles(const HoleSite& site, const CellBoundary& boundary) {
  OpenHoles open = FindOpenHoles(site, boundary);
  std::vector<ClosedHole> closed;
  std::vector<ClosedLoop> outlines;
  PieceBoundaries pieces(site, boundary);
  for (const std::vector<RimSegment>& segments : boundary.closed_loops) {
    ClosedLoop loop = ReadLoop(site, segments, pieces);
    if (loop.outer_rim) {
      outlines.push_back(std::move(loop));
      continue;
    }
    PlanarRegions regions;
    if (loop.faces_up && loop.vector_area.z() > 0) {
      regions = FindPlanarRegions(loop.segments, site.position, site.is_cancelled);
    }
    closed.push_back({std::move(loop), std::move(regions), {}});
  }
  FoundHoles found;
  for (const ClosedLoop& outline : outlines) {
    const bool in_plane =
        outline.faces_up && (PlaceInPlane(site, outline, open, closed) || PlaceInFolded(site, outline, open));
    if (in_plane || PlaceInSpace(site, outline, closed)) continue;
    ++found.outer_rims;
    found.left.push_back({boundary.cell, "outline of a detached piece of surface", -1,
                          static_cast<int64_t>(outline.segments.size()), false});
  }
  found.holes = std::move(open.holes);
  for (const ClosedHole& hole : closed) found.holes.push_back(PlanClosed(site, boundary.cell, hole));
  return found;
}

}  // namespace tilemend
