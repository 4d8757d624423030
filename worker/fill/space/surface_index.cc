#include "worker/fill/space/surface_index.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

namespace tilemend {
namespace {

constexpr double kTrianglesPerBin = 16;

Eigen::AlignedBox3d BoxOf(const TriMesh& mesh, const Triangle& t) {
  Eigen::AlignedBox3d box(mesh.points[t[0]]);
  box.extend(mesh.points[t[1]]);
  box.extend(mesh.points[t[2]]);
  return box;
}

}  // namespace

SurfaceIndex::SurfaceIndex(TriMesh mesh) : mesh_(std::move(mesh)) {
  Eigen::AlignedBox3d all;
  for (const Point3& p : mesh_.points) all.extend(p);
  if (!all.isEmpty()) {
    lo_ = all.min();
    const Point3 size = all.sizes();
    const double bins = std::max(1.0, static_cast<double>(mesh_.triangles.size()) / kTrianglesPerBin);
    // A wall has no area seen from above: no more bins along it than there are to be.
    step_ = std::max({std::sqrt(size.x() * size.y() / bins), size.x() / bins, size.y() / bins});
    if (step_ <= 0) step_ = 1;
    columns_ = static_cast<int64_t>(size.x() / step_) + 1;
    rows_ = static_cast<int64_t>(size.y() / step_) + 1;
  }
  first_.assign(static_cast<size_t>(columns_ * rows_) + 1, 0);
  const auto for_all = [&](const auto& visit) {
    for (size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const Eigen::AlignedBox3d box = BoxOf(mesh_, mesh_.triangles[t]);
      ForBins(box.min(), box.max(), [&](int64_t bin) { visit(bin, static_cast<int32_t>(t)); });
    }
  };
  for_all([&](int64_t bin, int32_t) { ++first_[bin + 1]; });
  for (size_t bin = 1; bin < first_.size(); ++bin) first_[bin] += first_[bin - 1];
  triangles_.resize(first_.back());
  std::vector<int32_t> next(first_.begin(), first_.end() - 1);
  for_all([&](int64_t bin, int32_t t) { triangles_[next[bin]++] = t; });
}

void SurfaceIndex::AppendNear(const Point3& lo, const Point3& hi, std::vector<SpaceTriangle>& found) const {
  const Eigen::AlignedBox3d wanted(lo, hi);
  ForBins(lo, hi, [&](int64_t bin) {
    for (int32_t k = first_[bin]; k < first_[bin + 1]; ++k) {
      const Triangle& t = mesh_.triangles[triangles_[k]];
      const Eigen::AlignedBox3d box = BoxOf(mesh_, t);
      if (!box.intersects(wanted)) continue;
      // Of the bins that both meet, only in the first.
      const int64_t row = RowOf(std::max(lo.y(), box.min().y())), column = ColumnOf(std::max(lo.x(), box.min().x()));
      if (row * columns_ + column == bin) found.push_back({mesh_.points[t[0]], mesh_.points[t[1]], mesh_.points[t[2]]});
    }
  });
}

int64_t SurfaceIndex::ColumnOf(double x) const {
  return static_cast<int64_t>(std::clamp((x - lo_.x()) / step_, 0.0, static_cast<double>(columns_ - 1)));
}

int64_t SurfaceIndex::RowOf(double y) const {
  return static_cast<int64_t>(std::clamp((y - lo_.y()) / step_, 0.0, static_cast<double>(rows_ - 1)));
}

template <typename Visit>
void SurfaceIndex::ForBins(const Point3& lo, const Point3& hi, const Visit& visit) const {
  for (int64_t row = RowOf(lo.y()); row <= RowOf(hi.y()); ++row) {
    for (int64_t column = ColumnOf(lo.x()); column <= ColumnOf(hi.x()); ++column) visit(row * columns_ + column);
  }
}

}  // namespace tilemend
