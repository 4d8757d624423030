#include "common/codec/tiles3d/bounding_volume.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace tilemend {
namespace {

// The axes of a box as columns. An axis without length is replaced by a direction across the others; `is_flat` says
// which.
Eigen::Matrix3d AxesOf(const std::vector<double>& box, std::array<bool, 3>& is_flat) {
  Eigen::Matrix3d axes = Eigen::Map<const Eigen::Matrix3d>(box.data() + 3);
  const double longest = axes.colwise().norm().maxCoeff();
  constexpr double kFlat = 1e-12;  // of the longest axis
  for (int k = 0; k < 3; ++k) {
    is_flat[static_cast<size_t>(k)] = axes.col(k).norm() <= kFlat * longest;
    if (is_flat[static_cast<size_t>(k)]) axes.col(k).setZero();
  }
  for (int k = 0; k < 3; ++k) {
    if (!is_flat[static_cast<size_t>(k)]) continue;
    const Point3 a = axes.col((k + 1) % 3), b = axes.col((k + 2) % 3);
    if (a.isZero(0) && b.isZero(0)) {
      axes.col(k) = Point3::Unit(k);
    } else if (a.isZero(0) || b.isZero(0)) {
      axes.col(k) = (a + b).unitOrthogonal();
    } else {
      axes.col(k) = a.cross(b).normalized();
    }
  }
  return axes;
}

std::vector<double> GrownBox(const std::vector<double>& box, const std::vector<Point3>& points) {
  std::array<bool, 3> is_flat;
  const Eigen::Matrix3d axes = AxesOf(box, is_flat);
  const Point3 centre(box[0], box[1], box[2]);
  const Eigen::FullPivLU<Eigen::Matrix3d> inverse(axes);
  Point3 low(is_flat[0] ? 0 : -1, is_flat[1] ? 0 : -1, is_flat[2] ? 0 : -1);
  Point3 high = -low;
  const Point3 old_low = low, old_high = high;
  constexpr double kRounding = 1e-9;  // of an axis: what a point on a face of the box may seem to lie outside
  for (const Point3& point : points) {
    const Point3 at = inverse.solve(point - centre);
    for (int k = 0; k < 3; ++k) {
      if (at[k] < low[k] - kRounding) low[k] = at[k];
      if (at[k] > high[k] + kRounding) high[k] = at[k];
    }
  }
  if (low == old_low && high == old_high) return box;
  const Point3 new_centre = centre + axes * (0.5 * (low + high));
  std::vector<double> out(new_centre.begin(), new_centre.end());
  for (int k = 0; k < 3; ++k) {
    const Point3 axis = 0.5 * (high[k] - low[k]) * axes.col(k);
    out.insert(out.end(), axis.begin(), axis.end());
  }
  return out;
}

// Extends the interval of longitudes, which may cross the antimeridian, on the side that is nearer.
void GrowLongitudes(double longitude, double& west, double& east) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const auto eastward = [](double from, double to) { return to >= from ? to - from : to - from + kTurn; };
  if (eastward(west, longitude) <= eastward(west, east)) return;
  if (eastward(longitude, west) < eastward(east, longitude)) {
    west = longitude;
  } else {
    east = longitude;
  }
}

std::vector<double> GrownRegion(std::vector<double> region, const std::vector<Point3>& points) {
  for (const Point3& point : points) {
    const Point3 at = GeodeticOf(point);
    GrowLongitudes(at[0], region[0], region[2]);
    region[1] = std::min(region[1], at[1]);
    region[3] = std::max(region[3], at[1]);
    region[4] = std::min(region[4], at[2]);
    region[5] = std::max(region[5], at[2]);
  }
  return region;
}

std::vector<double> GrownSphere(std::vector<double> sphere, const std::vector<Point3>& points) {
  const Point3 centre(sphere[0], sphere[1], sphere[2]);
  for (const Point3& point : points) sphere[3] = std::max(sphere[3], (point - centre).norm());
  return sphere;
}

}  // namespace

Point3 GeodeticOf(const Point3& earth_centred) {
  constexpr double kA = 6378137, kF = 1 / 298.257223563, kB = kA * (1 - kF);
  constexpr double kE2 = kF * (2 - kF), kSecondE2 = kE2 / (1 - kE2);
  const double x = earth_centred[0], y = earth_centred[1], z = earth_centred[2];
  const double p = std::hypot(x, y), r = std::hypot(p, z);
  double parametric = std::atan2(kB * z * (1 + kSecondE2 * kB / r), kA * p), latitude = 0;
  for (int step = 0; step < 2; ++step) {
    const double s = std::sin(parametric), c = std::cos(parametric);
    latitude = std::atan2(z + kSecondE2 * kB * s * s * s, p - kE2 * kA * c * c * c);
    parametric = std::atan2(kB * std::sin(latitude), kA * std::cos(latitude));
  }
  const double sin_latitude = std::sin(latitude);
  const double height =
      p * std::cos(latitude) + z * sin_latitude - kA * std::sqrt(1 - kE2 * sin_latitude * sin_latitude);
  return {std::atan2(y, x), latitude, height};
}

BoundingVolume GrownVolume(const BoundingVolume& volume, const std::vector<Point3>& points) {
  switch (volume.kind) {
    case BoundingVolume::Kind::kBox:
      return {volume.kind, GrownBox(volume.numbers, points)};
    case BoundingVolume::Kind::kRegion:
      return {volume.kind, GrownRegion(volume.numbers, points)};
    case BoundingVolume::Kind::kSphere:
      return {volume.kind, GrownSphere(volume.numbers, points)};
  }
  return volume;
}

}  // namespace tilemend
