#include "worker/papers/front/front_rules.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace tilemend {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Of the second fundamental form: how much a form that bends alike in all directions counts beside one neighbour.
constexpr double kEvenWeight = 0.1;
// The tangent of the most that a new edge is bent off the tangent plane.
constexpr double kMostBend = 1;

// The tangent plane with its x axis along an edge.
struct TangentPlane {
  TangentPlane(const Vector3d& normal, const Vector3d& along) {
    x = along - normal * normal.dot(along);
    if (!(x.norm() > 0)) x = normal.unitOrthogonal();
    x.normalize();
    y = normal.cross(x);
  }
  double AngleOf(const Vector3d& v) const {
    const double angle = std::atan2(v.dot(y), v.dot(x));
    return angle < 0 ? angle + 2 * std::numbers::pi : angle;
  }
  Vector3d At(double angle) const { return std::cos(angle) * x + std::sin(angle) * y; }

  Vector3d x, y;
};

// Unit: of the plane of the corner's edges, to the side of its normal; of edges in line, the normal.
Vector3d AcrossEdges(const FrontCorner& corner) {
  const Vector3d across = (corner.after - corner.at).cross(corner.before - corner.at);
  if (!(across.norm() > 0)) return corner.normal;
  return across.dot(corner.normal) > 0 ? across.normalized() : -across.normalized();
}

// Where a share of the corner's angle ends.
Vector3d DirectionAt(const FrontCorner& corner, const Vector3d& across, double share) {
  const TangentPlane plane(across, corner.after - corner.at);
  return plane.At(share * plane.AngleOf(corner.before - corner.at));
}

Point3 Bent(const FrontCorner& corner, const Vector3d& direction, double off) {
  return corner.at +
         corner.Length() * (direction + std::clamp(off, -kMostBend, kMostBend) * corner.normal).normalized();
}

// The normal curvature in direction cos(angle) x + sin(angle) y, 1 / metre; towards the normal is positive.
double CurvatureAlong(const FrontCorner& corner, const TangentPlane& plane, double angle) {
  Matrix3d left = Matrix3d::Zero();
  Vector3d right = Vector3d::Zero();
  double sum = 0, count = 0;
  for (const Point3& q : corner.neighbours) {
    const Vector3d d = q - corner.at;
    const double x = d.dot(plane.x), y = d.dot(plane.y), flat2 = x * x + y * y;
    if (!(flat2 > 0)) continue;
    const double curvature = 2 * corner.normal.dot(d) / d.squaredNorm();
    const Vector3d row = Vector3d(x * x, 2 * x * y, y * y) / flat2;
    left += row * row.transpose();
    right += curvature * row;
    sum += curvature;
    count += 1;
  }
  if (!(count > 0)) return 0;
  left += kEvenWeight * Matrix3d::Identity();
  right += kEvenWeight * sum / count * Vector3d(1, 0, 1);
  const Vector3d form = left.ldlt().solve(right);
  const double c = std::cos(angle), s = std::sin(angle);
  return form.dot(Vector3d(c * c, 2 * c * s, s * s));
}

}  // namespace

double FrontAngle(const Point3& at, const Point3& before, const Point3& after, const Vector3d& normal) {
  const Vector3d a = before - at, b = after - at, cross = b.cross(a);
  const double angle = std::atan2(cross.norm(), a.dot(b));
  return cross.dot(normal) > 0 ? angle : 2 * std::numbers::pi - angle;
}

FrontRule NormalCurvatureRule(std::optional<double> bend, FrontSteps steps) {
  if (steps == FrontSteps::kPrinted) {
    return [bend](const FrontCorner& corner, double share) -> Point3 {
      const Vector3d direction = DirectionAt(corner, AcrossEdges(corner), share);
      const double curvature = 2 * corner.normal.dot(direction) / corner.Length();  // eq. 4
      return Bent(corner, direction, bend.value_or(corner.Length() / 2) * curvature);
    };
  }
  return [bend](const FrontCorner& corner, double share) -> Point3 {
    const TangentPlane plane(corner.normal, corner.after - corner.at);
    const double angle = share * plane.AngleOf(corner.before - corner.at);
    return Bent(corner, plane.At(angle), bend.value_or(corner.Length() / 2) * CurvatureAlong(corner, plane, angle));
  };
}

FrontRule PlainRule(FrontSteps steps) {
  return [steps](const FrontCorner& corner, double share) -> Point3 {
    const Vector3d across = steps == FrontSteps::kPrinted ? AcrossEdges(corner) : corner.carried;
    return corner.at + corner.Length() * DirectionAt(corner, across, share);
  };
}

}  // namespace tilemend
