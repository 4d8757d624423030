#include "worker/fill/crease/size_field.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tilemend {
namespace {

// Steps along a curve by which its length in triangle sizes is summed up.
constexpr int kSteps = 512;

}  // namespace

SizeField::SizeField(const LocalHole& hole, const RefineOptions& options) : uniform_(options.uniform) {
  double length = 0;
  for (const RimLoop& loop : hole.loops) {
    for (int32_t i = 0; i < loop.size(); ++i) {
      const Point3& p = loop.positions[i];
      length += (loop.positions[(i + 1) % loop.size()] - p).norm();
      rim_.emplace_back(p, hole.sizes[loop.vertices[i]]);
    }
  }
  limit_ = length / static_cast<double>(rim_.size()) * std::max(options.size_limit, 1.0);
  slope_ = 2 * (options.gradation - 1) / (options.gradation + 1);
}

double SizeField::At(const Point3& p) const { return uniform_ ? Between(p) : Least(p); }

double SizeField::Least(const Point3& p) const {
  double least = limit_;
  for (const auto& [q, size] : rim_) least = std::min(least, size + slope_ * (p - q).norm());
  return least;
}

double SizeField::Between(const Point3& p) const {
  double sum = 0, weights = 0;
  for (const auto& [q, size] : rim_) {
    const double distance = (p - q).norm();
    const double weight = 1 / std::max(distance * distance, size * size);
    sum += weight * size;
    weights += weight;
  }
  return sum / weights;
}

std::vector<Point3> PointsAlong(const CreaseCurve& curve, const SizeField& size, int least) {
  std::vector<double> sum = {0};  // of length / size up to each step
  Point3 before = curve.At(0);
  for (int k = 1; k <= kSteps; ++k) {
    const Point3 p = curve.At(static_cast<double>(k) / kSteps);
    sum.push_back(sum.back() + (p - before).norm() / size.At((p + before) / 2));
    before = p;
  }
  const int pieces = std::max(static_cast<int>(std::lround(sum.back())), least + 1);
  std::vector<Point3> points;
  int k = 0;
  for (int piece = 1; piece < pieces; ++piece) {
    const double wanted = sum.back() * piece / pieces;
    while (sum[k + 1] < wanted) ++k;
    points.push_back(curve.At((k + (wanted - sum[k]) / (sum[k + 1] - sum[k])) / kSteps));
  }
  return points;
}

}  // namespace tilemend
