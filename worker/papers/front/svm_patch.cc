#include "worker/papers/front/svm_patch.h"

#include <Eigen/Core>
#include <optional>

#include "worker/papers/front/cotangent_system.h"
#include "worker/papers/front/least_squares_svm.h"

namespace tilemend {
namespace {

using Eigen::MatrixXd;

constexpr Eigen::Index kMostSamples = 2000;

// By what Laplacians of the points from `rim` on are multiplied, for the sums that the system has.
Eigen::VectorXd ScaleOf(const CotangentSystem& system, LaplacianScale scale, std::span<const Triangle> triangles,
                        int32_t rim, std::span<const Point3> points) {
  Eigen::VectorXd scales = Eigen::VectorXd::Zero(std::ssize(points) - rim);
  if (scale == LaplacianScale::kMean) {
    for (Eigen::Index v = 0; v < scales.size(); ++v) scales[v] = system.WeightOf(rim + static_cast<int32_t>(v));
    return scales;
  }
  for (const Triangle& t : triangles) {
    const Eigen::Vector3d areas = MixedAreas({points[t[0]], points[t[1]], points[t[2]]});
    for (int k = 0; k < 3; ++k) {
      if (t[k] >= rim) scales[t[k] - rim] += areas[k];
    }
  }
  return scales;
}

}  // namespace

bool ShapeByLaplacians(std::span<const LaplacianSample> samples, const FillerOptions& options, double edge,
                       std::span<const Triangle> triangles, int32_t rim, std::vector<Point3>& points) {
  const auto all = static_cast<int32_t>(points.size());
  if (rim == all) return true;
  const CotangentSystem system(points, triangles, rim);
  if (!system.ok()) return false;
  const Eigen::Index every = (std::ssize(samples) + kMostSamples - 1) / kMostSamples;
  const Eigen::Index count = every > 0 ? (std::ssize(samples) + every - 1) / every : 0;
  const Eigen::VectorXd scales = ScaleOf(system, options.scale, triangles, rim, points);
  MatrixXd of_rim(rim, 3), right = MatrixXd::Zero(all - rim, 3);
  for (int32_t v = 0; v < rim; ++v) of_rim.row(v) = points[v].transpose();
  for (int axis = 0; axis < 3 && count > 0; ++axis) {
    Eigen::VectorXd at(count), values(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      at[i] = samples[i * every].at[axis];
      values[i] = samples[i * every].laplacian[axis];
    }
    const std::optional<SvmFunction> f = LearnSvm(at, values, options.gamma, options.kernel_width * edge);
    if (!f) return false;
    for (int32_t v = rim; v < all; ++v) right(v - rim, axis) = scales[v - rim] * (*f)(points[v][axis]);
  }
  const MatrixXd places = system.Solve(of_rim, right);
  if (!places.allFinite()) return false;
  for (int32_t v = rim; v < all; ++v) points[v] = places.row(v - rim).transpose();
  return true;
}

}  // namespace tilemend
