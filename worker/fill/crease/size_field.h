// The wanted size of triangles inside a hole that is not yet triangulated.
#ifndef TILEMEND_WORKER_FILL_CREASE_SIZE_FIELD_H_
#define TILEMEND_WORKER_FILL_CREASE_SIZE_FIELD_H_

#include <utility>
#include <vector>

#include "worker/fill/crease/crease_network.h"
#include "worker/fill/hole/local_hole.h"
#include "worker/fill/region/refine_region.h"

namespace tilemend {

// Sizes in metres anywhere in a hole. They grow from the rim's with the distance (Persson 2006, as in RefineRegion);
// with `uniform` they lie between the rim's.
class SizeField {
 public:
  SizeField(const LocalHole& hole, const RefineOptions& options);

  double At(const Point3& p) const;  // O(rim)

 private:
  double Least(const Point3& p) const;
  double Between(const Point3& p) const;

  const bool uniform_;
  std::vector<std::pair<Point3, double>> rim_;  // positions and sizes
  double limit_ = 0, slope_ = 0;
};

// Points along a curve, its ends left out, as far apart as the field wants. At least `least` of them.
std::vector<Point3> PointsAlong(const CreaseCurve& curve, const SizeField& size, int least);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_CREASE_SIZE_FIELD_H_
