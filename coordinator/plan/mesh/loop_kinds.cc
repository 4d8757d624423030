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
constexpr double kWidestGap = 4;
constexpr double kMostBeside = 0.5;
constexpr double kOpposite = -0.5;
constexpr double kGoesOn = 0.3;
// Of the way from loop to loop: what leads along the axis. Loops in one plane, one within the other, do not face.
constexpr double kAcross = 0.3;
// Of the normals along both loops: the mean share along the axis. Beyond, the surface runs across the axis, as a dome
// does around a piece of it, and not along it, as a tube does.
constexpr double kMostAlongAxis = 0.7;

// Rims that nearly coincide: the gap over their mean edge.
constexpr double kNarrowestGap = 0.2;
// The two sides of a wall: its thickness over the mean radius; the cosine between the way through it and the normals.
constexpr double kThickestWall = 0.5;
constexpr double kThrough = -0.5;

// Corners at which a loop is measured, at most: of a longer one every second, third and so on.
constexpr size_t kMostPlaces = 1000;

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

// A place of a loop.
struct Foot {
  Point3 position;
  Vector3d normal;  // between those of the corners
};

// That nearest to p on the side from corner k. At a corner, which is nearest on two sides, it is the same on both.
Foot FootOn(const LoopLine& loop, size_t k, const Point3& p) {
  const size_t next = (k + 1) % loop.corners.size();
  const Point3& from = loop.corners[k];
  const Vector3d way = loop.corners[next] - from;
  const double squared = way.squaredNorm();
  const double t = squared > 0 ? std::clamp((p - from).dot(way) / squared, 0.0, 1.0) : 0;
  return {from + t * way, ((1 - t) * loop.normals[k] + t * loop.normals[next]).normalized()};
}

// From corners of `a` to the nearest place of `b`: the mean distance, and mean cosines: between the normals there, and
// between the way to it and the normal of `a`, and the way into the surface of `a`.
struct Gap {
  double distance = 0, cosine = 0, along_normal = 0, into_surface = 0;
};

Gap GapBetween(const LoopLine& a, const LoopLine& b) {
  const size_t n = a.corners.size(), m = b.corners.size(), step = 1 + n / kMostPlaces;
  const size_t looked_at = (n + step - 1) / step;
  const auto places = static_cast<double>(looked_at);
  Gap gap;
  for (size_t i = 0; i < n; i += step) {
    const Point3& p = a.corners[i];
    double least = std::numeric_limits<double>::infinity();
    size_t nearest = 0;
    for (size_t k = 0; k < m; ++k) {
      const double distance = DistanceToSegment(p, b.corners[k], b.corners[(k + 1) % m]);
      if (distance < least) least = distance, nearest = k;
    }
    const Foot there = FootOn(b, nearest, p);
    const Vector3d way = (there.position - p).normalized(), ahead = a.corners[(i + 1) % n] - a.corners[(i + n - 1) % n];
    gap.distance += least / places;
    gap.cosine += a.normals[i].dot(there.normal) / places;
    gap.along_normal += way.dot(a.normals[i]) / places;
    gap.into_surface += way.dot(ahead.cross(a.normals[i]).normalized()) / places;
  }
  return gap;
}

double MeanShareAlong(const Vector3d& axis, const LoopLine& loop) {
  double sum = 0;
  for (const Vector3d& normal : loop.normals) sum += std::abs(normal.dot(axis));
  return sum / static_cast<double>(loop.normals.size());
}

// Whether the loops are the ends of a tube that lacks a segment.
bool AreEndsOfATube(const LoopLine& a, const LoopLine& b, const Gap& there, const Gap& back, double radius) {
  const Vector3d axis = (VectorAreaOf(a).normalized() - VectorAreaOf(b).normalized()).normalized();
  const Vector3d across = MiddleOf(b) - MiddleOf(a);
  const double along = across.dot(axis), distance = std::max(there.distance, back.distance);
  if (along < 0 || along > kWidestGap * radius || (across - along * axis).norm() > kMostBeside * radius) return false;
  if ((MeanShareAlong(axis, a) + MeanShareAlong(axis, b)) / 2 > kMostAlongAxis) return false;
  return along >= kAcross * distance && distance < kWidestGap * radius &&
         std::max(there.into_surface, back.into_surface) < 0;
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
  for (size_t i = 0; i < n; i += 1 + n / kMostPlaces) {
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

bool FaceEachOther(const LoopLine& a, const LoopLine& b, bool one_piece) {
  const double length_a = LengthOf(a), length_b = LengthOf(b);
  if (std::min(length_a, length_b) < kLeastLikeness * std::max(length_a, length_b)) return false;
  if (VectorAreaOf(a).normalized().dot(VectorAreaOf(b).normalized()) > kOpposite) return false;
  const Gap there = GapBetween(a, b), back = GapBetween(b, a);
  const double radius = (length_a + length_b) / (4 * std::numbers::pi);
  const double distance = std::max(there.distance, back.distance);
  const double edge = (length_a + length_b) / static_cast<double>(a.corners.size() + b.corners.size());
  if (std::min(there.cosine, back.cosine) > kGoesOn) {
    return distance < kNarrowestGap * edge || AreEndsOfATube(a, b, there, back, radius);
  }
  return !one_piece && std::max(there.cosine, back.cosine) < -kGoesOn && distance < kThickestWall * radius &&
         std::max(there.along_normal, back.along_normal) < kThrough;
}

}  // namespace tilemend
