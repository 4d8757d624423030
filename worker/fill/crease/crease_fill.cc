#include "worker/fill/crease/crease_fill.h"

#include <cstdint>
#include <vector>

#include "common/mesh/rounding.h"
#include "worker/fill/crease/crease_network.h"
#include "worker/fill/crease/part_cutter.h"
#include "worker/fill/crease/part_fill.h"
#include "worker/fill/crease/size_field.h"

namespace tilemend {
namespace {

// Whether the surface joins the ends of a curve by an edge already.
bool IsEdgeOfSurface(const CreaseCurve& curve, const CreaseNetwork& network, const LocalHole& hole) {
  if (curve.from < 0 || curve.to < 0) return false;
  const CreaseEnd &a = network.ends[curve.from], &b = network.ends[curve.to];
  return hole.TrianglesBeside(hole.loops[a.loop].vertices[a.place], hole.loops[b.loop].vertices[b.place]) > 0;
}

// The new points on the network: its corners, then those of each curve, whose numbers are returned.
std::vector<std::vector<int32_t>> AddPoints(const CreaseNetwork& network, const LocalHole& hole,
                                            const RefineOptions& options, std::vector<Point3>& new_points) {
  const double step = hole.cell->lattice_step;
  for (const CreaseCorner& corner : network.corners) new_points.push_back(RoundedToLattice(corner.position, step));
  const SizeField size(hole, options);
  std::vector<std::vector<int32_t>> curve_points;
  for (const CreaseCurve& curve : network.curves) {
    std::vector<int32_t>& numbers = curve_points.emplace_back();
    for (const Point3& p : PointsAlong(curve, size, IsEdgeOfSurface(curve, network, hole) ? 1 : 0)) {
      numbers.push_back(static_cast<int32_t>(new_points.size()));
      new_points.push_back(RoundedToLattice(p, step));
    }
  }
  return curve_points;
}

}  // namespace

LocalPatch FillAlongCreases(const LocalHole& hole, const FillOptions& options) {
  const Bends bends = hole.cell->upright ? Bends::kOverSeveralEdges : Bends::kAtOneEdge;
  const CreaseNetwork network = FindCreases(hole.loops, bends);
  if (network.curves.empty()) return {FillFailure::kNotApplicable};
  LocalPatch patch;
  const std::vector<std::vector<int32_t>> curve_points = AddPoints(network, hole, options.refine, patch.new_points);
  const std::vector<PartBoundary> parts = CutAlong(network, hole, patch.new_points, curve_points);
  if (parts.empty()) return {FillFailure::kNotApplicable};
  for (const PartBoundary& boundary : parts) {
    const HolePart part = MakePart(hole, patch.new_points, boundary);
    const LocalPatch of_part = FillPart(part.hole, options);
    if (!of_part.ok()) return {FillFailure::kNotApplicable};
    AddPart(part, of_part, hole, patch);
  }
  return patch;
}

}  // namespace tilemend
