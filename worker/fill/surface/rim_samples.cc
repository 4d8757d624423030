#include "worker/fill/surface/rim_samples.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <set>

namespace tilemend {
namespace {

constexpr double kThinning = 1.2;
constexpr double kFlat = 1e-9;  // of the width: rounding

bool IsLess(const Point3& a, const Point3& b) {
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

bool IsRim(const ThinPlateProblem& problem, int32_t v) { return problem.known[v] && problem.has_equation[v]; }

// The rim points of the problem, by position.
std::vector<int32_t> RimOf(const ThinPlateProblem& problem) {
  std::vector<int32_t> rim;
  for (size_t v = 0; v < problem.points.size(); ++v) {
    if (IsRim(problem, static_cast<int32_t>(v))) rim.push_back(static_cast<int32_t>(v));
  }
  std::sort(rim.begin(), rim.end(), [&](int32_t a, int32_t b) { return IsLess(problem.points[a], problem.points[b]); });
  return rim;
}

// One point for each square of a raster, as coarse as it takes to leave few enough; `step` is its spacing.
std::vector<int32_t> Thinned(const ThinPlateProblem& problem, const std::vector<int32_t>& rim, size_t most,
                             double& step) {
  std::vector<int32_t> kept = rim;
  while (kept.size() > most) {
    step *= kThinning;
    std::set<RasterSquare> taken;
    kept.clear();
    for (const int32_t v : rim) {
      if (taken.insert(SquareOf(problem.points[v], step, 0, 0)).second) kept.push_back(v);
      if (kept.size() > most) break;
    }
  }
  return kept;
}

// The rim points and, for each, the farthest point beside it: the two together tell the slope there.
std::vector<Point3> WithPointsBeside(const ThinPlateProblem& problem, const std::vector<int32_t>& rim) {
  constexpr int32_t kNotAsked = -2, kNone = -1;
  std::vector<int32_t> beside(problem.points.size(), kNotAsked);
  for (const int32_t v : rim) beside[v] = kNone;
  const auto distance = [&](int32_t a, int32_t b) { return (problem.points[a] - problem.points[b]).head<2>().norm(); };
  for (const Triangle& t : problem.band) {
    for (const int32_t v : t) {
      int32_t& best = beside[v];
      if (best == kNotAsked) continue;
      for (const int32_t u : t) {
        if (IsRim(problem, u)) continue;
        const double gain = best < 0 ? 1 : distance(v, u) - distance(v, best);
        if (gain > 0 || (gain == 0 && IsLess(problem.points[u], problem.points[best]))) best = u;
      }
    }
  }
  std::set<int32_t> used;
  for (const int32_t v : rim) {
    used.insert(v);
    if (beside[v] != kNone) used.insert(beside[v]);
  }
  std::vector<Point3> samples;
  for (const int32_t v : used) samples.push_back(problem.points[v]);
  std::sort(samples.begin(), samples.end(), IsLess);
  const auto same_place = [](const Point3& a, const Point3& b) { return a.head<2>() == b.head<2>(); };
  samples.erase(std::unique(samples.begin(), samples.end(), same_place), samples.end());
  return samples;
}

// Whether every tension gives the plane that the samples lie in.
bool LieInAPlane(const std::vector<Point3>& samples, double width) {
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  Eigen::Vector3d sums = Eigen::Vector3d::Zero();
  const auto drift = [&](const Point3& p) {
    return Eigen::Vector3d(1, (p.x() - samples[0].x()) / width, (p.y() - samples[0].y()) / width);
  };
  for (const Point3& p : samples) {
    products += drift(p) * drift(p).transpose();
    sums += drift(p) * (p.z() - samples[0].z());
  }
  const Eigen::Vector3d plane = products.ldlt().solve(sums);
  return std::ranges::all_of(samples, [&](const Point3& p) {
    return std::abs(p.z() - samples[0].z() - plane.dot(drift(p))) <= kFlat * width;
  });
}

}  // namespace

RasterSquare SquareOf(const Point3& p, double side, double x_offset, double y_offset) {
  return {static_cast<int64_t>(std::floor(p.x() / side + x_offset)),
          static_cast<int64_t>(std::floor(p.y() / side + y_offset))};
}

RimSamples SampleRim(const ThinPlateProblem& problem, double width, size_t most_rim_points) {
  const std::vector<int32_t> rim = RimOf(problem);
  RimSamples result;
  result.rim_points = static_cast<int32_t>(rim.size());
  result.spacing = width / static_cast<double>(most_rim_points);
  result.samples = WithPointsBeside(problem, Thinned(problem, rim, most_rim_points, result.spacing));
  result.in_a_plane = result.samples.empty() || LieInAPlane(result.samples, width);
  return result;
}

}  // namespace tilemend
