#include "worker/fill/space/surface_index.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <span>

namespace tilemend {
namespace {

constexpr double kTrianglesPerBin = 16;
constexpr double kMostBins = 4;  // of a triangle, in the mean

Eigen::AlignedBox3d BoxOf(const MeshView& mesh, const Triangle& t) {
  Eigen::AlignedBox3d box(mesh.points[t[0]]);
  box.extend(mesh.points[t[1]]);
  box.extend(mesh.points[t[2]]);
  return box;
}

Eigen::AlignedBox2d SeenFromAbove(const Eigen::AlignedBox3d& box) { return {box.min().head<2>(), box.max().head<2>()}; }

// The step at which a triangle is in kMostBins bins in the mean. One whose box is w wide and h high, seen from above,
// is in (w / step + 1) (h / step + 1) of them on average over its places.
double LeastStep(const MeshView& mesh) {
  if (mesh.triangles.size() == 0) return 0;
  double area = 0, sides = 0;
  for (const Triangle& t : mesh.triangles) {
    const Point3 size = BoxOf(mesh, t).sizes();
    area += size.x() * size.y();
    sides += size.x() + size.y();
  }
  // Of the means: area / step^2 + sides / step + 1 = kMostBins.
  const auto count = static_cast<double>(mesh.triangles.size());
  const double half = sides / count / (2 * (kMostBins - 1));
  return half + std::sqrt(half * half + area / count / (kMostBins - 1));
}

BinGrid BinsOf(const MeshView& mesh) {
  Eigen::AlignedBox3d all;
  for (const Point3& p : mesh.points) all.extend(p);
  if (all.isEmpty()) all.extend(Point3(0, 0, 0));
  const Point3 size = all.sizes();
  const double bins = std::max(1.0, static_cast<double>(mesh.triangles.size()) / kTrianglesPerBin);
  // A wall has no area seen from above: no more bins along it than there are to be.
  const double step =
      std::max({std::sqrt(size.x() * size.y() / bins), size.x() / bins, size.y() / bins, LeastStep(mesh)});
  return BinGrid(SeenFromAbove(all), step > 0 ? step : 1, static_cast<int32_t>(mesh.triangles.size()),
                 [&](int32_t t) { return SeenFromAbove(BoxOf(mesh, mesh.triangles[t])); });
}

}  // namespace

SurfaceIndex::SurfaceIndex(const MeshView& mesh) : mesh_(mesh), bins_(BinsOf(mesh_)) {}

void SurfaceIndex::AppendNear(const Point3& lo, const Point3& hi, std::vector<SpaceTriangle>& found) const {
  const Eigen::AlignedBox3d wanted(lo, hi);
  bins_.ForBins(SeenFromAbove(wanted), [&](int64_t bin, std::span<const int32_t> triangles) {
    for (const int32_t i : triangles) {
      const Triangle& t = mesh_.triangles[i];
      const Eigen::AlignedBox3d box = BoxOf(mesh_, t);
      if (!box.intersects(wanted)) continue;
      // Of the bins that both meet, only in the first.
      const Point3 corner = lo.cwiseMax(box.min());
      if (bins_.BinOf(corner.head<2>()) == bin)
        found.push_back({mesh_.points[t[0]], mesh_.points[t[1]], mesh_.points[t[2]]});
    }
  });
}

}  // namespace tilemend
