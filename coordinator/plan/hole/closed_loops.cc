#include "coordinator/plan/hole/closed_loops.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "coordinator/plan/hole/planar_regions.h"

namespace tilemend {
namespace {

// A loop is the outline of a detached piece, and no hole in it, if it runs the wrong way round by this much: the cosine
// between its vector area and the normals along it. A hole gives about +1, a flat piece -1, the open end of a dome
// something near 0.
constexpr double kOuterRim = -0.3;
// A closed hole is filled over the plane if the surface along it faces up by this much.
constexpr double kFacesUp = 0.2;
// So many normals of a wall do not point up by chance.
constexpr size_t kTellingEdges = 8;
// A piece that lies in a hole faces the way of the hole by this much.
constexpr double kFacesAlike = 0.2;
// No surface is taken to rise from the rim of a hole more steeply than this.
constexpr double kSteepestRise = 3;
// Of the vertices of a piece about so many are asked whether they lie in a hole, which bounds the cost.
constexpr size_t kVoters = 9;

// Whether the surface along a loop faces up, and the loop does not cross itself seen from above.
bool BoundsHeights(const HoleSite& site, const ClosedLoop& loop) {
  if (std::any_of(loop.segments.begin(), loop.segments.end(),
                  [&](const RimSegment& s) { return site.rim.points[s.from].normal.z() <= 0; })) {
    return false;
  }
  std::vector<RimSegment> around = loop.segments;
  if (loop.vector_area.z() < 0) {
    for (RimSegment& s : around) std::swap(s.from, s.to);
  }
  return FindPlanarRegions(around, site.position, site.is_cancelled).triangulation.conflicts.empty();
}

Point3 MiddleOf(const HoleSite& site, const ClosedLoop& loop) {
  Point3 middle = Point3::Zero();
  for (const RimSegment& s : loop.segments) {
    middle += site.position[s.from] / static_cast<double>(loop.segments.size());
  }
  return middle;
}

// How far the surface rises inside a hole, along its normal, if it goes on from the rim as it leans there: positive
// over the corner of a box, negative in a pit.
double RiseIn(const HoleSite& site, const ClosedLoop& hole) {
  const Eigen::Vector3d normal = hole.vector_area.normalized();
  const Point3 middle = MiddleOf(site, hole);
  double slope = 0;
  for (const RimSegment& s : hole.segments) {
    Eigen::Vector3d outward = site.position[s.from] - middle;
    outward -= outward.dot(normal) * normal;
    const Eigen::Vector3d& n = site.rim.points[s.from].normal;
    const double up = n.dot(normal), out = outward.norm() > 0 ? n.dot(outward.normalized()) : 0;
    if (out != 0) slope += out / std::max(up, std::abs(out) / kSteepestRise);
  }
  slope /= static_cast<double>(hole.segments.size());
  return slope * std::sqrt(hole.vector_area.norm() / std::numbers::pi);
}

// Whether a point is so near that it can lie within a hole. Its surface rises by at most kSteepestRise times half its
// extent, and an edge is at most as long as that extent.
bool HasNear(const HoleSite& site, const ClosedLoop& hole, const Point3& p) {
  Eigen::AlignedBox3d box;
  for (const RimSegment& s : hole.segments) box.extend(site.position[s.from]);
  return box.squaredExteriorDistance(p) <=
         (kSteepestRise / 2 + 1) * (kSteepestRise / 2 + 1) * box.diagonal().squaredNorm();
}

}  // namespace

ClosedLoop ReadLoop(const HoleSite& site, std::vector<RimSegment> segments, PieceBoundaries& pieces) {
  ClosedLoop loop;
  loop.segments = std::move(segments);
  loop.vector_area = VectorArea(loop.segments, site.position);
  for (const RimSegment& s : loop.segments) loop.normal += site.rim.points[s.from].normal.normalized();
  if (loop.normal.norm() > 0) loop.normal.normalize();
  loop.faces_up = loop.normal.z() > kFacesUp;
  const double along = loop.vector_area.dot(loop.normal), up = loop.vector_area.z();
  loop.outer_rim = along < kOuterRim * loop.vector_area.norm();
  const bool contradicted = loop.outer_rim != (up < 0), is_short = loop.segments.size() < kTellingEdges;
  if ((!loop.faces_up || contradicted) && BoundsHeights(site, loop)) {
    // Of heights, however steep, the way around seen from above tells a hole from an outline. Along few edges of a
    // rough wall all normals may point up by chance.
    const bool tells = !is_short || std::abs(up) > std::abs(along);
    if (contradicted && (tells || pieces.ReachBeyond(loop.segments) == (up > 0))) loop.outer_rim = up < 0;
    loop.faces_up = true;
  }
  if (loop.outer_rim && is_short && pieces.ReachBeyond(loop.segments) == true) {
    loop.outer_rim = false;
    loop.faces_up = up > 0;
  }
  return loop;
}

namespace {

// Whether a point lies within a hole's boundary and near its surface, of which `rise` is known.
bool IsWithin(const HoleSite& site, const Point3& p, const ClosedLoop& hole, double rise) {
  const Eigen::Vector3d normal = hole.vector_area.normalized();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double angle = 0, edge = 0, below = kInfinity, above = -kInfinity;
  for (const RimSegment& s : hole.segments) {
    const Eigen::Vector3d a = site.position[s.from] - p, b = site.position[s.to] - p;
    const double off = a.dot(normal);
    const Eigen::Vector3d u = a - off * normal, v = b - b.dot(normal) * normal;
    angle += std::atan2(u.cross(v).dot(normal), u.dot(v));
    edge += (b - a).norm() / static_cast<double>(hole.segments.size());
    below = std::min(below, off);
    above = std::max(above, off);
  }
  return angle > std::numbers::pi && below + std::min(rise, 0.0) < edge && above + std::max(rise, 0.0) > -edge;
}

}  // namespace

bool LiesIn(const HoleSite& site, const ClosedLoop& piece, const ClosedLoop& hole) {
  if (piece.vector_area.norm() >= hole.vector_area.norm()) return false;
  if (piece.normal.dot(hole.vector_area.normalized()) <= kFacesAlike) return false;
  const Point3 middle = MiddleOf(site, piece);
  if (!HasNear(site, hole, middle)) return false;
  const double rise = RiseIn(site, hole);
  if (IsWithin(site, middle, hole, rise)) return true;
  // The middle of a piece that is curved as a C lies beside it.
  const size_t step = std::max<size_t>(1, piece.segments.size() / kVoters);
  size_t voters = 0, within = 0;
  for (size_t k = 0; k < piece.segments.size(); k += step) {
    ++voters;
    within += IsWithin(site, site.position[piece.segments[k].from], hole, rise);
  }
  return 2 * within > voters;
}

}  // namespace tilemend
