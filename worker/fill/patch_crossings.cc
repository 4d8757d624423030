#include "worker/fill/patch_crossings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

namespace tilemend {
namespace {

// Triangles at an edge that lie closer together than the angle with this sine are folded onto each other.
constexpr double kFoldSine = 0.01;

double Volume(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  return (b - a).cross(c - a).dot(d - a);
}

bool PassesThrough(const Point3& p, const Point3& q, const SpaceTriangle& t) {
  const double from = Volume(t[0], t[1], t[2], p), to = Volume(t[0], t[1], t[2], q);
  if (from * to > 0 || (from == 0 && to == 0)) return false;
  const double u = Volume(p, q, t[0], t[1]), v = Volume(p, q, t[1], t[2]), w = Volume(p, q, t[2], t[0]);
  return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
}

bool Has(const SpaceTriangle& t, const Point3& p) { return t[0] == p || t[1] == p || t[2] == p; }

// Whether an edge of a between corners that b does not have passes through b.
bool EdgePasses(const SpaceTriangle& a, const SpaceTriangle& b) {
  for (int k = 0; k < 3; ++k) {
    const Point3 &p = a[k], &q = a[(k + 1) % 3];
    if (!Has(b, p) && !Has(b, q) && PassesThrough(p, q, b)) return true;
  }
  return false;
}

bool IsFolded(const SpaceTriangle& a, const SpaceTriangle& b) {
  const auto own = [](const SpaceTriangle& t, const SpaceTriangle& other) {
    int k = 0;
    while (k < 2 && Has(other, t[k])) ++k;
    return k;
  };
  const int k = own(a, b);
  const Point3& p = a[(k + 1) % 3];
  const Eigen::Vector3d edge = (a[(k + 2) % 3] - p).normalized();
  const auto across = [&](const Point3& q) { return Eigen::Vector3d((q - p) - (q - p).dot(edge) * edge).normalized(); };
  const Eigen::Vector3d u = across(a[k]), v = across(b[own(b, a)]);
  return u.dot(v) > 0 && u.cross(v).norm() < kFoldSine;
}

bool Cross(const SpaceTriangle& a, const SpaceTriangle& b) {
  const auto shared = std::count_if(a.begin(), a.end(), [&](const Point3& p) { return Has(b, p); });
  if (shared == 2) return IsFolded(a, b);
  return shared < 2 && (EdgePasses(a, b) || EdgePasses(b, a));
}

struct Boxed {
  Point3 lo, hi;
  const SpaceTriangle* triangle;
  bool of_patch;
};

Boxed Box(const SpaceTriangle& t, bool of_patch) {
  return {t[0].cwiseMin(t[1]).cwiseMin(t[2]), t[0].cwiseMax(t[1]).cwiseMax(t[2]), &t, of_patch};
}

bool Overlap(const Boxed& a, const Boxed& b) {
  return (a.lo.array() <= b.hi.array()).all() && (b.lo.array() <= a.hi.array()).all();
}

}  // namespace

bool PatchCrosses(std::span<const SpaceTriangle> patch, std::span<const SpaceTriangle> surface) {
  if (patch.empty()) return false;
  std::vector<Boxed> boxes;
  Boxed all = Box(patch[0], true);
  for (const SpaceTriangle& t : patch) {
    boxes.push_back(Box(t, true));
    all.lo = all.lo.cwiseMin(boxes.back().lo);
    all.hi = all.hi.cwiseMax(boxes.back().hi);
  }
  for (const SpaceTriangle& t : surface) {
    if (Overlap(Box(t, false), all)) boxes.push_back(Box(t, false));
  }
  int axis = 0;
  (all.hi - all.lo).maxCoeff(&axis);
  std::sort(boxes.begin(), boxes.end(), [&](const Boxed& a, const Boxed& b) { return a.lo[axis] < b.lo[axis]; });
  for (size_t i = 0; i < boxes.size(); ++i) {
    for (size_t k = i + 1; k < boxes.size() && boxes[k].lo[axis] <= boxes[i].hi[axis]; ++k) {
      if (!boxes[i].of_patch && !boxes[k].of_patch) continue;
      if (Overlap(boxes[i], boxes[k]) && Cross(*boxes[i].triangle, *boxes[k].triangle)) return true;
    }
  }
  return false;
}

}  // namespace tilemend
