#include "common/assemble/plan_view.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

namespace tilemend {
namespace {

Eigen::AlignedBox2d BoxOf(const SpaceTriangle& t) {
  Eigen::AlignedBox2d box;
  for (const Point3& p : t) box.extend(Point2(p.head<2>()));
  return box;
}

// Twice the area of the triangle a, b, c seen from above; negative if it runs clockwise.
double TwiceArea(const Point2& a, const Point2& b, const Point2& c) {
  const Point2 u = b - a, v = c - a;
  return u.x() * v.y() - u.y() * v.x();
}

bool CoversPlace(const SpaceTriangle& t, const Point2& p) {
  const double whole = TwiceArea(t[0].head<2>(), t[1].head<2>(), t[2].head<2>());
  if (whole == 0) return false;
  for (size_t k = 0; k < 3; ++k) {
    const double part = TwiceArea(t[k].head<2>(), t[(k + 1) % 3].head<2>(), p);
    if (whole > 0 ? part < 0 : part > 0) return false;
  }
  return true;
}

}  // namespace

PlanView::PlanView(std::vector<SpaceTriangle> triangles) : triangles_(std::move(triangles)) {
  if (triangles_.empty()) return;
  for (const SpaceTriangle& t : triangles_) extent_.extend(BoxOf(t));
  const double side = std::max(extent_.sizes().maxCoeff(), 1e-3);
  grid_.emplace(extent_, side / std::sqrt(static_cast<double>(triangles_.size())),
                static_cast<int32_t>(triangles_.size()),
                [&](int32_t i) { return BoxOf(triangles_[static_cast<size_t>(i)]); });
}

bool PlanView::Covers(const Point2& p) const {
  if (!grid_ || !extent_.contains(p)) return false;
  bool covers = false;
  grid_->ForBins(Eigen::AlignedBox2d(p), [&](int64_t, std::span<const int32_t> things) {
    for (const int32_t i : things) covers = covers || CoversPlace(triangles_[static_cast<size_t>(i)], p);
  });
  return covers;
}

bool PlanView::Meets(const Eigen::AlignedBox2d& box) const {
  if (!grid_ || !box.intersects(extent_)) return false;
  bool meets = false;
  grid_->ForBins(box, [&](int64_t, std::span<const int32_t> things) {
    for (const int32_t i : things) meets = meets || BoxOf(triangles_[static_cast<size_t>(i)]).intersects(box);
  });
  return meets;
}

std::vector<SpaceTriangle> CornersOf(const TriMesh& mesh) {
  std::vector<SpaceTriangle> corners;
  corners.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) corners.push_back({mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]});
  return corners;
}

}  // namespace tilemend
