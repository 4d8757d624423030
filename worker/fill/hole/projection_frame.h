// The plane that a hole is triangulated over.
#ifndef TILEMEND_WORKER_FILL_HOLE_PROJECTION_FRAME_H_
#define TILEMEND_WORKER_FILL_HOLE_PROJECTION_FRAME_H_

#include <Eigen/Geometry>
#include <cmath>

#include "common/mesh/tri_mesh.h"

namespace tilemend {

// An orthonormal frame: x and y in the plane, z the height over it. The upright frame leaves coordinates untouched, bit
// for bit.
class ProjectionFrame {
 public:
  static ProjectionFrame Upright() { return ProjectionFrame(); }

  // The frame with the given normal (not zero) through `origin`. Its x axis runs along `along`, as far as that lies in
  // the plane, or, if it does not, by the axes of the scene.
  ProjectionFrame(const Point3& origin, const Eigen::Vector3d& normal,
                  const Eigen::Vector3d& along = Eigen::Vector3d::Zero())
      : upright_(false), origin_(origin) {
    const Eigen::Vector3d n = normal.normalized(), within = along - along.dot(n) * n;
    const Eigen::Vector3d helper = std::abs(n.z()) < 0.9 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitX();
    const Eigen::Vector3d u = (within.isZero(0) ? Eigen::Vector3d(helper.cross(n)) : within).normalized();
    axes_.row(0) = u;
    axes_.row(1) = n.cross(u);
    axes_.row(2) = n;
  }

  bool upright() const { return upright_; }
  // How far a way in the scene leads up over the plane.
  double HeightAlong(const Eigen::Vector3d& way) const { return upright_ ? way.z() : axes_.row(2).dot(way); }
  Point3 ToFrame(const Point3& p) const { return upright_ ? p : Point3(axes_ * (p - origin_)); }
  Point3 ToScene(const Point3& p) const { return upright_ ? p : Point3(axes_.transpose() * p + origin_); }

 private:
  ProjectionFrame() = default;

  bool upright_ = true;
  Point3 origin_{0, 0, 0};
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();
};

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_HOLE_PROJECTION_FRAME_H_
