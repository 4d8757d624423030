#include "worker/fill/plane/plane_heights.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "worker/fill/surface/choose_tension.h"
#include "worker/fill/surface/free_rim.h"
#include "worker/fill/surface/hole_width.h"
#include "worker/fill/surface/plate_over_slope.h"
#include "worker/fill/surface/thin_plate.h"
#include "worker/fill/surface/walled_ground.h"

namespace tilemend {
namespace {

// Adds the points of the band after all others; returns its triangles.
std::vector<Triangle> AddBand(const LocalHole& hole, const ProjectionFrame& frame,
                              const std::vector<bool>& has_equation, std::vector<Point3>& points) {
  BandTriangles band = BandAt(hole, has_equation, static_cast<int32_t>(points.size()));
  for (const int32_t v : band.others) points.push_back(frame.ToFrame(hole.cell->band.points[v]));
  return std::move(band.triangles);
}

// Laplacians that are known from the surface of the whole cluster, at seams.
void AddLaplacians(const LocalHole& hole, const std::vector<bool>& has_equation, ThinPlateProblem& plate) {
  for (int32_t v = 0; v < hole.size(); ++v) {
    if (has_equation[v] || hole.vertices[v] < 0) continue;
    const RimVertex& vertex = hole.cell->vertices[hole.vertices[v]];
    if (!vertex.laplacian_known) continue;
    plate.laplacian.resize(plate.points.size());
    plate.laplacian[v] = vertex.laplacian;
  }
}

// Solves nothing if the surface is to have walls.
std::optional<std::vector<double>> SolveWhole(const LocalHole& hole, const FillOptions& options,
                                              const GroundTrend& ground, ThinPlateProblem& plate,
                                              std::optional<HoldOut>& chosen, bool& has_walls) {
  FreeSteepRim(plate);
  if (options.tension || hole.tension) {
    plate.tension = options.tension ? *options.tension : *hole.tension;
    return SolveThinPlate(plate);
  }
  const double width = hole.size() < kMinRimForHoldOut ? 0 : HoleWidth(plate.points, hole.segments);
  chosen = ChooseTension(plate, width);
  has_walls = (hole.open || hole.in_ground) && HasWalls(hole, *chosen, ground);
  if (has_walls) return std::nullopt;
  plate.tension = chosen->tension;
  auto laplacian = SolveWithinReach(plate);
  chosen->tension = plate.tension;
  return laplacian;
}

bool SolveSurface(const LocalHole& hole, const ProjectionFrame& frame, const FillOptions& options, RimUse use,
                  ThinPlateProblem& plate, std::optional<HoldOut>& chosen) {
  if (frame.upright() && hole.walls.is_told()) return SolveWalledGround(SettledReadingsOf(hole), hole.walls, plate);
  const GroundTrend ground = TrendOf(plate);
  bool has_walls = false;
  const auto laplacian = SolveOverSlope(frame.upright() ? hole.slope : Point2(0, 0), plate, [&] {
    if (use == RimUse::kWhole) return SolveWhole(hole, options, ground, plate, chosen, has_walls);
    plate.tension = options.tension.value_or(0);
    return SolveThinPlate(plate);
  });
  if (!has_walls) return laplacian.has_value();
  chosen->walls = ground;
  return SolveWalledGround(ReadingsOf(hole), chosen->walls, plate);
}

bool SolveAsThinPlate(const LocalHole& hole, const ProjectionFrame& frame, const FillOptions& options, RimUse use,
                      PlanePatch& patch, std::optional<HoldOut>& chosen) {
  ThinPlateProblem plate;
  const auto rim = static_cast<size_t>(hole.size()), all = patch.points.size();
  plate.is_cancelled = options.refine.is_cancelled;
  plate.points = std::move(patch.points);
  plate.patch = std::move(patch.triangles);
  plate.band = AddBand(hole, frame, hole.has_equation, plate.points);
  for (size_t v = 0; v < plate.points.size(); ++v) {
    plate.known.push_back(v < rim || v >= all);
    plate.has_equation.push_back(v < rim ? static_cast<bool>(patch.has_equation[v]) : v < all);
  }
  if (frame.upright()) AddLaplacians(hole, patch.has_equation, plate);
  if (frame.upright() && !FreeRim(hole.on_object, hole.ground, plate)) return false;
  const bool is_solved = SolveSurface(hole, frame, options, use, plate, chosen);
  patch.points = std::move(plate.points);
  patch.points.resize(all);
  patch.triangles = std::move(plate.patch);
  return is_solved;
}

}  // namespace

bool FindHeights(const LocalHole& hole, const ProjectionFrame& frame, const FillOptions& options, RimUse use,
                 PlanePatch& patch, std::optional<HoldOut>& chosen) {
  if (hole.level) {
    for (size_t v = 0; v < patch.points.size(); ++v) {
      const bool of_rim = v < static_cast<size_t>(hole.size());
      if (of_rim && (hole.on_object.empty() || !hole.on_object[v])) continue;
      Point3& p = patch.points[v];
      p.z() = *hole.WaterLevelAt(p.head<2>());
    }
    return true;
  }
  return SolveAsThinPlate(hole, frame, options, use, patch, chosen);
}

}  // namespace tilemend
