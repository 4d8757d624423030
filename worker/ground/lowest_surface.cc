#include "worker/ground/lowest_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

namespace tilemend {
namespace {

constexpr double kPlacesPerSquare = 2;  // along each axis

class Rasterizer {
 public:
  explicit Rasterizer(GroundRaster& raster) : raster_(raster), step_(raster.square / kPlacesPerSquare) {}

  // Where a vertex lies.
  struct Spot {
    int32_t col, row;
    float height;
  };

  Spot AddVertex(const Point3& p) {
    const Spot spot{SquareAt(p.x(), raster_.square), SquareAt(p.y(), raster_.square), static_cast<float>(p.z())};
    Lower(spot.col, spot.row, p.z());
    return spot;
  }

  // The triangle's height at each place of the lattice that it covers, where that is lower than what is known. Most
  // triangles are small and lower nothing.
  void AddTriangle(const std::array<Spot, 3>& spots, const std::array<const Point3*, 3>& points) {
    const auto [a, b, c] = spots;
    const auto [first, last] = RangeOf(a.col, b.col, c.col);
    const auto [low, high] = RangeOf(a.row, b.row, c.row);
    if (first == last && low == high) return;  // as low as the corners there
    const std::array<Point3, 3> corners = {*points[0], *points[1], *points[2]};
    if (last - first > 1 || high - low > 1) return AddLargeTriangle(corners);
    const float lowest = std::min(a.height, std::min(b.height, c.height));
    const float* const at = &raster_.heights[raster_.IndexOf(first, low)];
    const ptrdiff_t right = last - first, up = static_cast<ptrdiff_t>(high - low) * raster_.cols;
    if ((at[0] <= lowest) & (at[right] <= lowest) & (at[up] <= lowest) & (at[up + right] <= lowest)) return;
    AddSmallTriangle(corners);
  }

 private:
  // Line by line.
  void AddLargeTriangle(const std::array<Point3, 3>& corners) {
    const auto [low, high] = RangeOf(corners[0].y(), corners[1].y(), corners[2].y());
    const Eigen::Vector3d normal = NormalOf(corners);
    if (normal.z() == 0) return;
    for (int64_t line = FirstPlace(low); PlaceAt(line) <= high; ++line) {
      const double y = PlaceAt(line);
      const auto [left, right] = SpanAt(corners, y);
      for (int64_t k = FirstPlace(left); PlaceAt(k) <= right; ++k) {
        Lower(SquareAt(PlaceAt(k), raster_.square), SquareAt(y, raster_.square),
              HeightAt(corners[0], normal, {PlaceAt(k), y}));
      }
    }
  }

  // Place by place of its bounds: asks whether it covers one only where it would lower the square.
  void AddSmallTriangle(const std::array<Point3, 3>& corners) {
    const auto [low, high] = RangeOf(corners[0].y(), corners[1].y(), corners[2].y());
    const auto [first, last] = RangeOf(corners[0].x(), corners[1].x(), corners[2].x());
    const int64_t first_line = FirstPlace(low), first_place = FirstPlace(first);
    if (PlaceAt(first_line) > high || PlaceAt(first_place) > last) return;
    const Eigen::Vector3d normal = NormalOf(corners);
    if (normal.z() == 0) return;
    for (int64_t line = first_line; PlaceAt(line) <= high; ++line) {
      const double y = PlaceAt(line);
      for (int64_t k = first_place; PlaceAt(k) <= last; ++k) {
        const double x = PlaceAt(k), height = HeightAt(corners[0], normal, {x, y});
        const int32_t col = SquareAt(x, raster_.square), row = SquareAt(y, raster_.square);
        if (!raster_.Contains(col, row) || raster_.heights[raster_.IndexOf(col, row)] <= static_cast<float>(height)) {
          continue;
        }
        const auto [left, right] = SpanAt(corners, y);
        if (FirstPlace(left) <= k && x <= right) Lower(col, row, height);
      }
    }
  }

  // Without jumps, which no processor foresees here.
  template <typename Number>
  static std::pair<Number, Number> RangeOf(Number a, Number b, Number c) {
    return {std::min(a, std::min(b, c)), std::max(a, std::max(b, c))};
  }

  static Eigen::Vector3d NormalOf(const std::array<Point3, 3>& corners) {
    return (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  }

  // Of the plane through a corner.
  static double HeightAt(const Point3& corner, const Eigen::Vector3d& normal, const Point2& at) {
    return corner.z() - (normal.x() * (at.x() - corner.x()) + normal.y() * (at.y() - corner.y())) / normal.z();
  }

  double PlaceAt(int64_t k) const { return (static_cast<double>(k) + 0.5) * step_; }

  int64_t FirstPlace(double coordinate) const {  // std::ceil is a call without SSE4.1
    const double place = coordinate / step_ - 0.5;
    const auto whole = static_cast<int64_t>(place);
    return whole + (whole < place ? 1 : 0);
  }

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
    lowest = lowest <= value ? lowest : value;
  }

  GroundRaster& raster_;
  const double step_;
};

}  // namespace

GroundRaster LowestSurface(const TriMesh& mesh, double square) {
  Eigen::AlignedBox2d box;
  std::vector<uint8_t> has_triangle(mesh.points.size(), 0);
  for (const Triangle& t : mesh.triangles) {
    for (const int32_t v : t) has_triangle[v] = 1;
  }
  for (size_t v = 0; v < mesh.points.size(); ++v) {
    if (has_triangle[v] != 0) box.extend(Point2(mesh.points[v].head<2>()));
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
  std::vector<Rasterizer::Spot> spots(mesh.points.size());
  for (size_t v = 0; v < mesh.points.size(); ++v) {
    if (has_triangle[v] != 0) spots[v] = rasterizer.AddVertex(mesh.points[v]);
  }
  for (const Triangle& t : mesh.triangles) {
    rasterizer.AddTriangle({spots[t[0]], spots[t[1]], spots[t[2]]},
                           {&mesh.points[t[0]], &mesh.points[t[1]], &mesh.points[t[2]]});
  }
  return raster;
}

}  // namespace tilemend
