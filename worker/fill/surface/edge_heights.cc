#include "worker/fill/surface/edge_heights.h"

#include <algorithm>

#include "worker/fill/surface/height_reach.h"
#include "worker/fill/surface/kriging.h"
#include "worker/fill/surface/rim_samples.h"
#include "worker/fill/surface/thin_plate.h"

namespace tilemend {
namespace {

constexpr size_t kLeastSamples = 8, kMostEdgePoints = 250;
// In 1 / width^2. With less, slopes go on too far where there is rim on one side alone.
constexpr double kLeastTension = 3;
// Variance of each height by itself, over the kernel's scale. The likeliest one is no better, and jumps by tens between
// what is all but the same rim.
constexpr double kNoise = 1e-4;
constexpr double kTaut = 1e4;  // 1 / width^2: from here on a membrane

// Known points that a membrane hangs on: those with an unknown one in a triangle of the patch.
std::vector<int32_t> KnownBesideUnknown(const ThinPlateProblem& problem) {
  std::vector<bool> is_beside(problem.points.size(), false);
  for (const Triangle& t : problem.patch) {
    const bool has_unknown = std::ranges::any_of(t, [&](int32_t v) { return !problem.known[v]; });
    for (const int32_t v : t) is_beside[v] = is_beside[v] || (has_unknown && problem.known[v]);
  }
  std::vector<int32_t> beside;
  for (size_t v = 0; v < is_beside.size(); ++v) {
    if (is_beside[v]) beside.push_back(static_cast<int32_t>(v));
  }
  return beside;
}

// A membrane over what the known heights are away from the trend, and the trend again.
bool SolveAbout(const HeightTrend& trend, const std::vector<int32_t>& edge, ThinPlateProblem& problem) {
  ThinPlateProblem away = problem;
  for (const int32_t v : KnownBesideUnknown(away)) away.points[v].z() -= trend.At(away.points[v].head<2>());
  if (!SolveMembrane(away)) return false;
  for (const int32_t v : edge) problem.points[v].z() = away.points[v].z() + trend.At(away.points[v].head<2>());
  return true;
}

}  // namespace

bool SolveEdge(double width, const std::vector<int32_t>& edge, ThinPlateProblem& problem) {
  const auto foretell = [&] {
    if (!(width > 0)) return false;
    const RimSamples rim = SampleRim(problem, width, kMostEdgePoints);
    if (rim.samples.size() < kLeastSamples) return false;
    const HeightReach reach = ReachOfRim(problem);
    for (double tension = std::max(kLeastTension, problem.tension * width * width); tension < kTaut; tension *= 10) {
      if (!SolveAbout(Kriging(rim.samples, width, tension, Kriging::Drift::kConstant).Trend(kNoise), edge, problem))
        return false;
      if (std::ranges::all_of(edge, [&](int32_t v) { return reach.Holds(problem.points[v].z()); })) return true;
    }
    return false;
  };
  return foretell() || SolveMembrane(problem);
}

}  // namespace tilemend
