#include "common/assemble/finest_patch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tilemend {

double MedianOf(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

FinestPatch::FinestPatch(const TriMesh& finest, const FilePatch& patch)
    : finest_(finest),
      patch_(patch),
      lengths_(patch.new_points.size(), std::numeric_limits<double>::infinity()),
      is_level_(patch.new_points.size(), true),
      runs_(patch.new_points.size(), 0) {
  LookAtEdges();
  LookAtRuns();
}

const Point3& FinestPatch::At(int32_t v) const {
  return IsNew(v) ? patch_.new_points[NewPoint(v)] : finest_.points[static_cast<size_t>(v)];
}

void FinestPatch::LookAtEdges() {
  std::vector<double> of_rim, all;
  for (const Triangle& t : patch_.triangles) {
    for (int k = 0; k < 3; ++k) {
      const int32_t a = t[k], b = t[(k + 1) % 3];
      const double length = (At(a) - At(b)).head<2>().norm();
      all.push_back(length);
      if (!IsNew(a) && !IsNew(b)) of_rim.push_back(length);
      for (const int32_t v : {a, b}) {
        if (IsNew(v) && length > 0) lengths_[NewPoint(v)] = std::min(lengths_[NewPoint(v)], length);
      }
      if (IsNew(a) && IsNew(b) && At(a).z() != At(b).z()) is_level_[NewPoint(a)] = is_level_[NewPoint(b)] = false;
    }
  }
  for (double& length : lengths_) length = std::isfinite(length) ? length : 0;
  rim_edge_ = MedianOf(std::move(of_rim.empty() ? all : of_rim));
}

void FinestPatch::LookAtRuns() {
  const auto& runs = patch_.materials;
  for (size_t r = 0; r < runs.size(); ++r) {
    const size_t end = r + 1 < runs.size() ? static_cast<size_t>(runs[r + 1].first) : patch_.triangles.size();
    for (auto t = static_cast<size_t>(runs[r].first); t < end; ++t) {
      for (const int32_t v : patch_.triangles[t]) {
        if (IsNew(v)) runs_[NewPoint(v)] = static_cast<int32_t>(r);
      }
    }
  }
}

NearestPosition::NearestPosition(const std::vector<Point3>& positions) : positions_(positions) {
  for (const Point3& p : positions) extent_.extend(Point2(p.head<2>()));
  if (positions.empty()) return;
  const double side = std::max(extent_.sizes().maxCoeff(), 1e-3);
  const double step = side / std::max(1.0, std::sqrt(static_cast<double>(positions.size())));
  grid_.emplace(extent_, step, static_cast<int32_t>(positions.size()),
                [&](int32_t i) { return Eigen::AlignedBox2d(Point2(positions_[static_cast<size_t>(i)].head<2>())); });
}

int32_t NearestPosition::Of(const Point2& p) const {
  if (!grid_) return -1;
  int32_t best = -1;
  double least = std::numeric_limits<double>::infinity();
  const double farthest = 2 * (extent_.sizes().norm() + extent_.exteriorDistance(p)) + grid_->step();
  // What lies nearer than `reach` is in the square.
  for (double reach = grid_->step() / 2;; reach *= 2) {
    const Point2 half(reach, reach);
    for (const int32_t i : grid_->In({p - half, p + half})) {
      const double distance = (positions_[static_cast<size_t>(i)].head<2>() - p).squaredNorm();
      if (distance < least || (distance == least && i < best)) std::tie(least, best) = std::pair(distance, i);
    }
    if (std::sqrt(least) <= reach || reach > farthest) return best;
  }
}

bool VertexThinning::Take(const Point2& p, double edge) {
  const double wanted = std::max(factor_ * edge, least_);
  if (!(wanted > 0)) return true;
  const int exponent = std::ilogb(wanted);
  const double step = std::ldexp(1.0, exponent);
  const auto square = std::tuple(exponent, static_cast<int64_t>(std::floor(p.x() / step)),
                                 static_cast<int64_t>(std::floor(p.y() / step)));
  return taken_.insert(square).second;
}

}  // namespace tilemend
