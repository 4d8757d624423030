#include "worker/fill/space/patch_crossings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "common/mesh/box_tree.h"
#include "common/mesh/exact_signs.h"

namespace tilemend {
namespace {

using Eigen::AlignedBox3d;

// Triangles at an edge that lie closer together than the angle with this sine are folded onto each other.
constexpr double kFoldSine = 0.02;

bool Has(const SpaceTriangle& t, const Point3& p) { return t[0] == p || t[1] == p || t[2] == p; }

// Points of one plane seen along the axis that is most nearly across it.
class FlatView {
 public:
  explicit FlatView(const SpaceTriangle& t) {
    int axis = 0;
    (t[1] - t[0]).cross(t[2] - t[0]).cwiseAbs().maxCoeff(&axis);
    u_ = (axis + 1) % 3;
    v_ = (axis + 2) % 3;
  }
  Point2 operator()(const Point3& p) const { return {p[u_], p[v_]}; }

 private:
  int u_ = 0, v_ = 1;
};

bool SegmentsMeet(const Point2& p, const Point2& q, const Point2& a, const Point2& b) {
  const int at_a = TurnOf(p, q, a), at_b = TurnOf(p, q, b), at_p = TurnOf(a, b, p), at_q = TurnOf(a, b, q);
  if (at_a * at_b > 0 || at_p * at_q > 0) return false;
  if (at_a != 0 || at_b != 0) return true;
  return (p.cwiseMin(q).array() <= a.cwiseMax(b).array()).all() &&  // on one line
         (a.cwiseMin(b).array() <= p.cwiseMax(q).array()).all();
}

// Whether segment pq meets a triangle in its plane.
bool MeetsInPlane(const Point3& p, const Point3& q, const SpaceTriangle& t) {
  const FlatView view(t);
  const Point2 from = view(p), to = view(q), corners[3] = {view(t[0]), view(t[1]), view(t[2])};
  const int turns[3] = {TurnOf(corners[0], corners[1], from), TurnOf(corners[1], corners[2], from),
                        TurnOf(corners[2], corners[0], from)};
  const auto [least, most] = std::minmax({turns[0], turns[1], turns[2]});
  if (least >= 0 || most <= 0) return true;  // p lies in it
  return SegmentsMeet(from, to, corners[0], corners[1]) || SegmentsMeet(from, to, corners[1], corners[2]) ||
         SegmentsMeet(from, to, corners[2], corners[0]);
}

bool SegmentMeets(const Point3& p, const Point3& q, const SpaceTriangle& t) {
  const int from = SideOfPlane(t[0], t[1], t[2], p), to = SideOfPlane(t[0], t[1], t[2], q);
  if (from * to > 0) return false;
  if (from == 0 && to == 0) return MeetsInPlane(p, q, t);
  const auto [least, most] =
      std::minmax({SideOfPlane(p, q, t[0], t[1]), SideOfPlane(p, q, t[1], t[2]), SideOfPlane(p, q, t[2], t[0])});
  return least >= 0 || most <= 0;
}

// What rounding may change of a scalar product, as a share of the product of the lengths.
constexpr double kProductSlack = 1e-14;

// Whether p lies on the side of the plane across `way` at `on` that this leads to, by more than rounding.
bool IsAhead(const Point3& p, const Point3& on, const Eigen::Vector3d& way) {
  const Eigen::Vector3d from = p - on;
  const double ahead = from.dot(way);
  return ahead > 0 && ahead * ahead > kProductSlack * kProductSlack * from.squaredNorm() * way.squaredNorm();
}

// Whether the plane across `way` at `on` has the corners of a that are not there ahead of it and those of b behind it.
bool Parts(const Point3& on, const Eigen::Vector3d& way, const SpaceTriangle& a, const SpaceTriangle& b) {
  return std::ranges::all_of(a, [&](const Point3& p) { return p == on || IsAhead(p, on, way); }) &&
         std::ranges::all_of(b, [&](const Point3& p) { return p == on || IsAhead(p, on, -way); });
}

// Whether all of `other`, but for a corner at that edge, lies beyond an edge of t.
bool LiesBeyondAnEdge(const SpaceTriangle& other, const SpaceTriangle& t) {
  const Eigen::Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]);
  for (int k = 0; k < 3; ++k) {
    const Point3 &on = t[k], &end = t[(k + 1) % 3];
    const Eigen::Vector3d outward = (end - on).cross(normal);
    const auto is_beyond = [&](const Point3& p) { return p == on || p == end || IsAhead(p, on, outward); };
    // Else t is a needle, whose normal is none.
    if (std::ranges::all_of(other, is_beyond) && IsAhead(t[(k + 2) % 3], on, -outward)) return true;
  }
  return false;
}

// The most that rounding changes of the volume below, as a share of the product of the three lengths: more than the
// bound of Shewchuk 1997, 4.
constexpr double kVolumeSlack = 1e-14;

// Whether the corners of `other` that t does not have are surely on one side of its plane.
bool IsOnOneSide(const SpaceTriangle& other, const SpaceTriangle& t) {
  const Eigen::Vector3d u = t[1] - t[0], v = t[2] - t[0], normal = u.cross(v);
  const double most = kVolumeSlack * kVolumeSlack * u.squaredNorm() * v.squaredNorm();
  int ahead = 0, behind = 0;
  for (const Point3& p : other) {
    if (Has(t, p)) continue;
    const Eigen::Vector3d from = p - t[0];
    const double volume = normal.dot(from);
    if (volume * volume <= most * from.squaredNorm()) return false;
    ++(volume > 0 ? ahead : behind);
  }
  return ahead == 0 || behind == 0;
}

// Whether triangles with one common corner, or none, are told apart by the plane of one of them, by a plane halfway
// between them, or one along an edge: most are, without exact signs.
bool IsApart(const SpaceTriangle& a, const SpaceTriangle& b, bool has_common) {
  if (IsOnOneSide(a, b) || IsOnOneSide(b, a)) return true;
  if (!has_common) {
    const Point3 from = (a[0] + a[1] + a[2]) / 3, to = (b[0] + b[1] + b[2]) / 3;
    return Parts((from + to) / 2, from - to, a, b) || LiesBeyondAnEdge(a, b) || LiesBeyondAnEdge(b, a);
  }
  const Point3& common = *std::ranges::find_if(a, [&](const Point3& p) { return Has(b, p); });
  const auto direction = [&](const SpaceTriangle& t) {
    return Eigen::Vector3d((t[0] + t[1] + t[2] - 3 * common).normalized());
  };
  return Parts(common, direction(a) - direction(b), a, b) || LiesBeyondAnEdge(a, b) || LiesBeyondAnEdge(b, a);
}

// Whether an edge of a between corners that b does not have meets b.
bool EdgeMeets(const SpaceTriangle& a, const SpaceTriangle& b) {
  for (int k = 0; k < 3; ++k) {
    const Point3 &p = a[k], &q = a[(k + 1) % 3];
    if (!Has(b, p) && !Has(b, q) && SegmentMeets(p, q, b)) return true;
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

}  // namespace

AlignedBox3d BoxOf(const SpaceTriangle& t) {
  AlignedBox3d box(t[0]);
  box.extend(t[1]);
  box.extend(t[2]);
  return box;
}

bool HasArea(const SpaceTriangle& t) {
  for (int k = 0; k < 3; ++k) {
    const auto view = [&](const Point3& p) { return Point2(p[k], p[(k + 1) % 3]); };
    if (TurnOf(view(t[0]), view(t[1]), view(t[2])) != 0) return true;
  }
  return false;
}

bool SegmentCrosses(const Point3& p, const Point3& q, const SpaceTriangle& t) {
  return HasArea(t) && SegmentMeets(p, q, t);
}

bool TrianglesCross(const SpaceTriangle& a, const SpaceTriangle& b) {
  const auto shared = std::count_if(a.begin(), a.end(), [&](const Point3& p) { return Has(b, p); });
  if (shared == 2) return IsFolded(a, b);
  if (shared < 2 && IsApart(a, b, shared == 1)) return false;
  return shared > 2 || EdgeMeets(a, b) || EdgeMeets(b, a);
}

namespace {

// Calls found(a, b) for the numbers of patch triangles that cross, a < b, until it returns true; returns whether it
// did.
template <typename Found>
bool FindCrossing(std::span<const SpaceTriangle> patch, const BoxTree& tree, const Found& found) {
  for (size_t a = 0; a < patch.size(); ++a) {
    const auto number = static_cast<int32_t>(a);
    const bool any = tree.AnyMeeting(BoxOf(patch[a]), [&](int32_t b) {
      return b > number && TrianglesCross(patch[a], patch[b]) && found(number, b);
    });
    if (any) return true;
  }
  return false;
}

BoxTree TreeOf(std::span<const SpaceTriangle> triangles) {
  std::vector<AlignedBox3d> boxes;
  boxes.reserve(triangles.size());
  for (const SpaceTriangle& t : triangles) boxes.push_back(BoxOf(t));
  return BoxTree(boxes);
}

}  // namespace

bool PatchCrosses(std::span<const SpaceTriangle> patch, std::span<const SpaceTriangle> surface) {
  const BoxTree tree = TreeOf(patch);
  const bool crosses_surface = std::any_of(surface.begin(), surface.end(), [&](const SpaceTriangle& t) {
    return tree.AnyMeeting(BoxOf(t), [&](int32_t k) { return HasArea(t) && TrianglesCross(patch[k], t); });
  });
  return crosses_surface || FindCrossing(patch, tree, [](int32_t, int32_t) { return true; });
}

std::vector<int32_t> CrossedTriangles(std::span<const SpaceTriangle> patch, std::span<const SpaceTriangle> surface) {
  std::set<int32_t> crossed;
  for (const auto& [t, of_surface] : SurfaceCrossings(patch, surface)) crossed.insert(t);
  for (const auto& [a, b] : SelfCrossings(patch)) crossed.insert({a, b});
  return {crossed.begin(), crossed.end()};
}

std::vector<std::pair<int32_t, int32_t>> SurfaceCrossings(std::span<const SpaceTriangle> patch,
                                                          std::span<const SpaceTriangle> surface) {
  const BoxTree tree = TreeOf(patch);
  std::vector<std::pair<int32_t, int32_t>> crossings;
  for (int32_t s = 0; s < std::ssize(surface); ++s) {
    tree.AnyMeeting(BoxOf(surface[s]), [&](int32_t t) {
      if (HasArea(surface[s]) && TrianglesCross(patch[t], surface[s])) crossings.emplace_back(t, s);
      return false;
    });
  }
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

std::vector<std::pair<int32_t, int32_t>> SelfCrossings(std::span<const SpaceTriangle> patch) {
  std::vector<std::pair<int32_t, int32_t>> crossings;
  FindCrossing(patch, TreeOf(patch), [&](int32_t a, int32_t b) {
    crossings.emplace_back(a, b);
    return false;
  });
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

}  // namespace tilemend
