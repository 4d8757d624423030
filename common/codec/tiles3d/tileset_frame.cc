#include "common/codec/tiles3d/tileset_frame.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <optional>

#include "absl/strings/str_format.h"
#include "common/codec/tiles3d/bounding_volume.h"

namespace tilemend {
namespace {

// What lies between is taken to be at the surface of the Earth, in metres from its centre.
constexpr double kDeep = 6.33e6, kHigh = 6.4e6;
// Of directions that are taken as the same: 1.4 cm at 1 km.
constexpr double kSameDirection = 1e-10;
constexpr double kSameAngle = 1.4e-5;                                    // radians, whose cosine is 1 - kSameDirection
constexpr double kSemiMajor = 6378137, kFlattening = 1 / 298.257223563;  // WGS 84

bool IsOnEarth(const Point3& p) { return p.norm() > kDeep && p.norm() < kHigh; }

// The plane of an orthographic projection of the ellipsoid is that of the frame. It has x to the east; with other axes,
// a Mercator projection with a line of true scale through the origin is 1 cm off at 11 km. `angle`: of x against the
// east, counter-clockwise. With the datum, so that longitudes and latitudes need no shift.
std::string CrsAt(const Point3& geodetic, double angle) {
  const double degree = 180 / std::numbers::pi, lat = geodetic.y() * degree, lon = geodetic.x() * degree;
  if (std::abs(angle) < kSameAngle) {
    return absl::StrFormat("+proj=ortho +lat_0=%.12g +lon_0=%.12g +datum=WGS84 +units=m +no_defs", lat, lon);
  }
  return absl::StrFormat(
      "+proj=omerc +lat_0=%.12g +lonc=%.12g +alpha=45 +gamma=%.12g +k=1 +datum=WGS84 +units=m +no_defs", lat, lon,
      45 + angle * degree);
}

void SetPlace(const Point3& geodetic, double angle, TilesetFrame& frame) {
  frame.crs = CrsAt(geodetic, angle);
  frame.height = geodetic.z();
}

// From a frame to one whose x axis is turned counter-clockwise against its own.
Eigen::Matrix4d ToTurned(double turn) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  if (turn != 0) matrix.topLeftCorner<3, 3>() = Eigen::AngleAxisd(-turn, Point3::UnitZ()).matrix();
  return matrix;
}

// The middle of the root's volume in the frame of the root's parent.
Point3 MiddleOf(const TilesetTile& root) {
  const std::vector<double>& n = root.volume.numbers;
  if (root.volume.kind != BoundingVolume::Kind::kRegion) return Moved(root.to_root, Point3(n[0], n[1], n[2]));
  // A region that crosses the meridian of 180 degrees has its west behind its east.
  const double east = n[2] < n[0] ? n[2] + 2 * std::numbers::pi : n[2];
  return EarthCentred({(n[0] + east) / 2, (n[1] + n[3]) / 2, (n[4] + n[5]) / 2});
}

// If the root's transform puts a frame with z up onto the Earth.
std::optional<TilesetFrame> RootsFrame(const TilesetTile& root, double turn) {
  const Point3 origin = root.to_root.topRightCorner<3, 1>();
  const Eigen::Matrix3d axes = root.to_root.topLeftCorner<3, 3>();
  if (!IsOnEarth(origin)) return std::nullopt;
  const bool is_rigid = (axes.transpose() * axes).isApprox(Eigen::Matrix3d::Identity(), 1e-9) && axes.determinant() > 0;
  const Point3 geodetic = GeodeticOf(origin);
  const Eigen::Matrix3d there = AxesAt(geodetic);
  if (!is_rigid || axes.col(2).dot(there.col(2)) < 1 - kSameDirection) return std::nullopt;
  TilesetFrame frame;
  frame.is_roots = true;
  frame.from_outer = ToTurned(turn);
  SetPlace(geodetic, std::atan2(axes.col(0).dot(there.col(1)), axes.col(0).dot(there.col(0))) + turn, frame);
  return frame;
}

}  // namespace

Eigen::Matrix3d AxesAt(const Point3& geodetic) {
  const double lon = geodetic.x(), lat = geodetic.y();
  Eigen::Matrix3d axes;
  axes.col(0) = Point3(-std::sin(lon), std::cos(lon), 0);
  axes.col(1) = Point3(-std::sin(lat) * std::cos(lon), -std::sin(lat) * std::sin(lon), std::cos(lat));
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}

Point3 EarthCentred(const Point3& geodetic) {
  const double lon = geodetic.x(), lat = geodetic.y(), height = geodetic.z();
  const double squared = kFlattening * (2 - kFlattening);
  const double radius = kSemiMajor / std::sqrt(1 - squared * std::sin(lat) * std::sin(lat));
  return {(radius + height) * std::cos(lat) * std::cos(lon), (radius + height) * std::cos(lat) * std::sin(lon),
          (radius * (1 - squared) + height) * std::sin(lat)};
}

TilesetFrame FrameOf(const Tileset& tileset, double turn) {
  const TilesetTile& root = tileset.tiles.front();
  const Point3 middle = MiddleOf(root);
  TilesetFrame frame;
  frame.from_outer = ToTurned(turn);
  if (!IsOnEarth(middle)) return frame;
  if (const std::optional<TilesetFrame> roots = RootsFrame(root, turn)) return *roots;
  const Point3 geodetic = GeodeticOf(middle);
  Eigen::Matrix4d to_outer = Eigen::Matrix4d::Identity();
  to_outer.topLeftCorner<3, 3>() = AxesAt(geodetic);
  to_outer.topRightCorner<3, 1>() = middle;
  frame.from_outer = ToTurned(turn) * to_outer.inverse();
  SetPlace(geodetic, turn, frame);
  return frame;
}

Eigen::Matrix4d ToScene(const TilesetFrame& frame, const TilesetTile& tile) {
  return frame.from_outer * (frame.is_roots ? tile.in_root : tile.to_root);
}

}  // namespace tilemend
