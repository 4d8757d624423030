#include "worker/ground/lowest_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace tilemend {
namespace {

constexpr double kPlacesPerSquare = 2;  // along each axis

class Rasterizer {
 public:
  explicit Rasterizer(GroundRaster& raster) : raster_(raster), step_(raster.square / kPlacesPerSquare) {}

  void AddVertex(const Point3& p) { Lower(SquareAt(p.x(), raster_.square), SquareAt(p.y(), raster_.square), p.z()); }

  // The triangle's height at each place of the lattice that it covers, line by line.
  void AddTriangle(const std::array<Point3, 3>& corners) {
    const auto [low, high] = std::minmax({corners[0].y(), corners[1].y(), corners[2].y()});
    const int64_t first = FirstPlace(low);
    if (PlaceAt(first) > high) return;  // many triangles are smaller than a square
    const Eigen::Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    if (normal.z() == 0) return;
    for (int64_t line = first; PlaceAt(line) <= high; ++line) {
      const double y = PlaceAt(line);
      const auto [left, right] = SpanAt(corners, y);
      for (int64_t k = FirstPlace(left); PlaceAt(k) <= right; ++k) {
        const double x = PlaceAt(k);
        const double rise = -(normal.x() * (x - corners[0].x()) + normal.y() * (y - corners[0].y())) / normal.z();
        Lower(SquareAt(x, raster_.square), SquareAt(y, raster_.square), corners[0].z() + rise);
      }
    }
  }

 private:
  double PlaceAt(int64_t k) const { return (static_cast<double>(k) + 0.5) * step_; }
  int64_t FirstPlace(double coordinate) const { return static_cast<int64_t>(std::ceil(coordinate / step_ - 0.5)); }

  // What the line at height y of the plane cuts out of the triangle.
  static std::pair<double, double> SpanAt(const std::array<Point3, 3>& corners, double y) {
    double left = std::numeric_limits<double>::infinity(), right = -left;
    for (int k = 0; k < 3; ++k) {
      const Point3 &a = corners[k], &b = corners[(k + 1) % 3];
      if ((a.y() < y && b.y() < y) || (a.y() > y && b.y() > y)) continue;
      const double share = a.y() == b.y() ? 0 : (y - a.y()) / (b.y() - a.y());
      const double x = a.x() + share * (b.x() - a.x());
      left = std::min(left, a.y() == b.y() ? std::min(a.x(), b.x()) : x);
      right = std::max(right, a.y() == b.y() ? std::max(a.x(), b.x()) : x);
    }
    return {left, right};
  }

  void Lower(int32_t col, int32_t row, double height) {
    if (!raster_.Contains(col, row)) return;  // rounded off the triangle
    float& lowest = raster_.heights[raster_.IndexOf(col, row)];
    const auto value = static_cast<float>(height);
    if (!(lowest <= value)) lowest = value;
  }

  GroundRaster& raster_;
  const double step_;
};

}  // namespace

GroundRaster LowestSurface(const TriMesh& mesh, double square) {
  Eigen::AlignedBox2d box;
  std::vector<bool> has_triangle(mesh.points.size(), false);
  for (const Triangle& t : mesh.triangles) {
    for (const int32_t v : t) has_triangle[v] = true;
  }
  for (size_t v = 0; v < mesh.points.size(); ++v) {
    if (has_triangle[v]) box.extend(Point2(mesh.points[v].head<2>()));
  }
  GroundRaster raster;
  raster.square = square;
  if (box.isEmpty() || !(box.sizes() / square).allFinite()) return raster;
  const Point2 squares = box.sizes() / square + Point2(2, 2);
  if (squares.x() * squares.y() > static_cast<double>(kMostRasterSquares)) return raster;
  if (box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff() / square > 0x1p30) return raster;
  const int32_t col = SquareAt(box.min().x(), square), row = SquareAt(box.min().y(), square);
  raster = EmptyRaster(square, col, row, SquareAt(box.max().x(), square) - col + 1,
                       SquareAt(box.max().y(), square) - row + 1);
  Rasterizer rasterizer(raster);
  for (size_t v = 0; v < mesh.points.size(); ++v) {
    if (has_triangle[v]) rasterizer.AddVertex(mesh.points[v]);
  }
  for (const Triangle& t : mesh.triangles) {
    rasterizer.AddTriangle({mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]});
  }
  return raster;
}

}  // namespace tilemend
