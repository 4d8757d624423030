#include "coordinator/plan/mesh/loop_kinds.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "common/mesh/segment_distance.h"

namespace tilemend {
namespace {

using Eigen::Vector3d;

constexpr double kCrackAngle_rad = 10.0 * std::numbers::pi / 180;  // Zhang 2022, 4.1 (1): 5 to 10 degrees
// Of FaceEachOther. Lengths over each other; the gap over the mean radius; the centres beside each other over the same;
// cosines between the ways that the loops open and between the surfaces along them.
constexpr double kLeastLikeness = 0.6;
constexpr double kWidestGap = 2;
constexpr double kMostBeside = 0.5;
constexpr double kOpposite = -0.5;
constexpr double kGoesOn = 0.3;
// Of the way from loop to loop: what leads along the axis. Loops in one plane, one within the other, do not face.
constexpr double kAcross = 0.3;

// Corners at which the width of a loop is measured, at most: of a longer one every second, third and so on.
constexpr size_t kMostWidths = 1000;

std::vector<Vector3d> SidesOf(const LoopLine& loop) {
  std::vector<Vector3d> sides;
  for (size_t i = 0; i < loop.corners.size(); ++i) {
    const Vector3d side = loop.corners[(i + 1) % loop.corners.size()] - loop.corners[i];
    if (side.norm() > 0) sides.push_back(side.normalized());
  }
  return sides;
}

// A turn about a normal, of lines without direction: in (-90, 90] degrees.
double TurnOfLines(const Vector3d& a, const Vector3d& b, const Vector3d& normal) {
  double turn = std::atan2(a.cross(b).dot(normal), a.dot(b));
  if (turn > std::numbers::pi / 2) turn -= std::numbers::pi;
  if (turn <= -std::numbers::pi / 2) turn += std::numbers::pi;
  return turn;
}

double LengthOf(const LoopLine& loop) {
  double sum = 0;
  for (size_t i = 0; i < loop.corners.size(); ++i)
    sum += (loop.corners[(i + 1) % loop.corners.size()] - loop.corners[i]).norm();
  return sum;
}

Point3 MiddleOf(const LoopLine& loop) {
  Point3 sum = Point3::Zero();
  for (const Point3& p : loop.corners) sum += p / static_cast<double>(loop.corners.size());
  return sum;
}

Vector3d VectorAreaOf(const LoopLine& loop) {
  Vector3d sum = Vector3d::Zero();
  for (size_t i = 0; i < loop.corners.size(); ++i) {
    sum += (loop.corners[i] - loop.corners[0]).cross(loop.corners[(i + 1) % loop.corners.size()] - loop.corners[0]);
  }
  return sum / 2;
}

// From the corners of `a` to the nearest of `b`: the mean distance, and the mean cosine between the normals there.
struct Gap {
  double distance = 0, cosine = 0;
};

Gap GapBetween(const LoopLine& a, const LoopLine& b) {
  Gap gap;
  const auto n = static_cast<double>(a.corners.size());
  for (size_t i = 0; i < a.corners.size(); ++i) {
    size_t nearest = 0;
    for (size_t k = 1; k < b.corners.size(); ++k) {
      const Point3& p = a.corners[i];
      if ((b.corners[k] - p).squaredNorm() < (b.corners[nearest] - p).squaredNorm()) nearest = k;
    }
    gap.distance += (b.corners[nearest] - a.corners[i]).norm() / n;
    gap.cosine += a.normals[i].dot(b.normals[nearest]) / n;
  }
  return gap;
}

}  // namespace

bool IsCrack(const LoopLine& loop) {
  const std::vector<Vector3d> sides = SidesOf(loop);
  const double least = std::cos(kCrackAngle_rad);
  for (size_t i = 0; i < sides.size(); ++i) {
    for (size_t k = 0; k < i; ++k) {
      if (std::abs(sides[i].dot(sides[k])) < least) return false;
    }
  }
  double turned = 0;
  for (size_t i = 1; i < sides.size(); ++i) {
    turned += TurnOfLines(sides[i - 1], sides[i], loop.normals[i]);
    if (std::abs(turned) > kCrackAngle_rad) return false;
  }
  return !sides.empty();
}

double MedianWidth(const LoopLine& loop) {
  const size_t n = loop.corners.size();
  std::vector<double> widths;
  for (size_t i = 0; i < n; i += 1 + n / kMostWidths) {
    const Point3 &p = loop.corners[i], &before = loop.corners[(i + n - 1) % n], &after = loop.corners[(i + 1) % n];
    double nearest = std::numeric_limits<double>::infinity();
    for (size_t k = i + 1; k < i + n - 1; ++k) {
      nearest = std::min(nearest, DistanceToSegment(p, loop.corners[k % n], loop.corners[(k + 1) % n]));
    }
    const double edges = ((p - before).norm() + (after - p).norm()) / 2;
    widths.push_back(edges > 0 ? nearest / edges : 0);
  }
  const size_t middle = widths.size() / 2;
  std::nth_element(widths.begin(), widths.begin() + static_cast<ptrdiff_t>(middle), widths.end());
  return widths[middle];
}

bool IsDislocation(const LoopLine& loop, const DislocationLimit& limit) {
  const double edge = LengthOf(loop) / static_cast<double>(loop.corners.size());
  const double in_edges = limit.length > 0 && edge > 0 ? limit.length / edge : limit.in_edges;
  return loop.corners.size() > 3 && MedianWidth(loop) < in_edges;
}

bool FaceEachOther(const LoopLine& a, const LoopLine& b) {
  const double length_a = LengthOf(a), length_b = LengthOf(b);
  if (std::min(length_a, length_b) < kLeastLikeness * std::max(length_a, length_b)) return false;
  const Vector3d way = VectorAreaOf(a).normalized(), other_way = VectorAreaOf(b).normalized();
  if (way.dot(other_way) > kOpposite) return false;
  const Vector3d axis = (way - other_way).normalized(), across = MiddleOf(b) - MiddleOf(a);
  const double radius = (length_a + length_b) / (4 * std::numbers::pi), along = across.dot(axis);
  if (along < 0 || along > kWidestGap * radius || (across - along * axis).norm() > kMostBeside * radius) return false;
  const Gap there = GapBetween(a, b), back = GapBetween(b, a);
  if (along < kAcross * std::max(there.distance, back.distance)) return false;
  return std::max(there.distance, back.distance) < kWidestGap * radius && std::min(there.cosine, back.cosine) > kGoesOn;
}

}  // namespace tilemend
