#include "worker/fill/space/move_points.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <set>

#include "common/mesh/box_tree.h"
#include "common/mesh/rounding.h"
#include "common/mesh/triangle_shape.h"
#include "worker/fill/space/patch_crossings.h"
#include "worker/fill/space/patch_edit.h"

namespace tilemend {
namespace {

constexpr int kMostPasses = 4;
constexpr int kDirections = 8;
constexpr double kSteps[] = {0.125, 0.25, 0.5};  // of the mean edge at the point

// Of the way that a point goes: how far the surface that faces up may rise or fall where the point was.
constexpr double kMostOff = 0.25;

// Of a triangle that faces up and lies over p or under it, above p.
std::optional<double> HeightOver(const SpaceTriangle& t, const Point3& p) {
  const Eigen::Vector3d normal = TwiceVectorArea(t);
  if (normal.z() <= kFacesUp * normal.norm()) return std::nullopt;
  for (int k = 0; k < 3; ++k) {
    const Point2 side = (t[(k + 1) % 3] - t[k]).head<2>(), to = (p - t[k]).head<2>();
    if (side.x() * to.y() - side.y() * to.x() < 0) return std::nullopt;
  }
  return normal.dot(t[0] - p) / normal.z();
}

class PointMover {
 public:
  PointMover(const LocalHole& hole, std::span<const SpaceTriangle> surface, LocalPatch& patch)
      : hole_(hole), surface_(surface), surface_tree_(TreeOver(surface)), patch_(patch) {
    at_point_.resize(patch.new_points.size());
    for (size_t t = 0; t < patch.triangles.size(); ++t) {
      placed_.push_back(InSpace(hole, patch, patch.triangles[t]));
      for (const int32_t v : patch.triangles[t]) {
        if (v >= hole.size()) at_point_[v - hole.size()].push_back(static_cast<int32_t>(t));
      }
    }
  }

  void Run(std::span<const int32_t> crossed) {
    std::set<int32_t> points;
    for (const int32_t t : crossed) {
      for (const int32_t v : patch_.triangles[t]) {
        if (v >= hole_.size()) points.insert(v - hole_.size());
      }
    }
    for (int pass = 0; pass < kMostPasses; ++pass) {
      tree_ = BoxTree(BoxesInReach());
      bool has_moved = false;
      for (const int32_t point : points) has_moved = Move(point) || has_moved;
      if (!has_moved) return;
    }
  }

 private:
  // Whether fewer triangles cross afterwards.
  bool Move(int32_t point) {
    const std::vector<int32_t>& around = at_point_[point];
    const Point3 from = patch_.new_points[point];
    int fewest = CrossingsOf(around, StarAt(point, from), std::numeric_limits<int>::max());
    if (fewest == 0) return false;
    Point3 best = from;
    const double edge = MeanEdge(point);
    for (const double step : kSteps) {
      for (int k = 0; k < kDirections; ++k) {
        const double angle = k * 2 * std::numbers::pi / kDirections;
        const Point3 to = Storable(OnSurface(point, from + step * edge * Point3(std::cos(angle), std::sin(angle), 0)));
        const std::vector<SpaceTriangle> star = StarAt(point, to);
        if (!KeepsFacing(around, star) || !KeepsHeight(from, (to - from).norm(), star)) continue;
        const int count = CrossingsOf(around, star, fewest);
        if (count >= fewest) continue;
        fewest = count;
        best = to;
      }
    }
    if (best == from) return false;
    patch_.new_points[point] = best;
    const std::vector<SpaceTriangle> star = StarAt(point, best);
    for (size_t k = 0; k < around.size(); ++k) placed_[around[k]] = star[k];
    return true;
  }

  // Of the patch: where each triangle may be at the end of a pass, in which a point moves once.
  std::vector<Eigen::AlignedBox3d> BoxesInReach() const {
    std::vector<Eigen::AlignedBox3d> boxes;
    for (const SpaceTriangle& t : placed_) boxes.push_back(BoxOf(t));
    for (size_t point = 0; point < at_point_.size(); ++point) {
      if (at_point_[point].empty()) continue;
      Eigen::AlignedBox3d star;
      for (const int32_t t : at_point_[point]) star.extend(BoxOf(placed_[t]));
      const double far = kSteps[std::size(kSteps) - 1] * MeanEdge(static_cast<int32_t>(point));
      const Point3 from = patch_.new_points[point];
      const Eigen::AlignedBox3d reach(Point3(from.x() - far, from.y() - far, star.min().z()),
                                      Point3(from.x() + far, from.y() + far, star.max().z()));
      for (const int32_t t : at_point_[point]) boxes[t].extend(reach);
    }
    return boxes;
  }

  // The triangles around a point, if it were at `place`.
  std::vector<SpaceTriangle> StarAt(int32_t point, const Point3& place) const {
    std::vector<SpaceTriangle> star;
    for (const int32_t t : at_point_[point]) {
      SpaceTriangle& placed = star.emplace_back(placed_[t]);
      for (int k = 0; k < 3; ++k) {
        if (patch_.triangles[t][k] == hole_.size() + point) placed[k] = place;
      }
    }
    return star;
  }

  double MeanEdge(int32_t point) const {
    double sum = 0;
    int count = 0;
    for (const int32_t t : at_point_[point]) {
      for (int k = 0; k < 3; ++k) {
        if (patch_.triangles[t][k] == hole_.size() + point) continue;
        sum += (placed_[t][k] - patch_.new_points[point]).norm();
        ++count;
      }
    }
    return sum / count;
  }

  // At the height of the surface that faces up around the point; at its own beside that.
  Point3 OnSurface(int32_t point, const Point3& p) const {
    for (const int32_t t : at_point_[point]) {
      if (const std::optional<double> height = HeightOver(placed_[t], p)) return p + Point3(0, 0, *height);
    }
    return p;
  }

  Point3 Storable(const Point3& p) const {
    return RoundedTo(hole_.cell->float32 ? NumberType::kFloat32 : NumberType::kFloat64,
                     RoundedToLattice(p, hole_.cell->lattice_step));
  }

  // Whether what faced up does so yet, and nothing has lost its area.
  bool KeepsFacing(std::span<const int32_t> around, std::span<const SpaceTriangle> star) const {
    for (size_t k = 0; k < around.size(); ++k) {
      if (!HasArea(star[k])) return false;
      const Eigen::Vector3d before = TwiceVectorArea(placed_[around[k]]), after = TwiceVectorArea(star[k]);
      if (before.z() > kFacesUp * before.norm() && after.z() <= kFacesUp * after.norm()) return false;
    }
    return true;
  }

  // Whether what faces up is yet near where the point was.
  static bool KeepsHeight(const Point3& from, double way, std::span<const SpaceTriangle> star) {
    return std::ranges::all_of(star, [&](const SpaceTriangle& t) {
      const std::optional<double> height = HeightOver(t, from);
      return !height || std::abs(*height) <= kMostOff * way;
    });
  }

  // Pairs of triangles that cross, one or both of the star; counted up to a bound.
  int CrossingsOf(std::span<const int32_t> around, const std::vector<SpaceTriangle>& star, int bound) const {
    auto count = static_cast<int>(SelfCrossings(star).size());
    for (const SpaceTriangle& t : star) {
      if (count >= bound) break;
      const Eigen::AlignedBox3d box = BoxOf(t);
      const auto meet = [&](const SpaceTriangle& other) {
        if (BoxOf(other).intersects(box) && HasArea(other) && TrianglesCross(t, other)) ++count;
        return count >= bound;
      };
      surface_tree_.AnyMeeting(box, [&](int32_t other) { return meet(surface_[other]); });
      tree_.AnyMeeting(
          box, [&](int32_t other) { return std::ranges::find(around, other) == around.end() && meet(placed_[other]); });
    }
    return count;
  }

  const LocalHole& hole_;
  const std::span<const SpaceTriangle> surface_;
  const BoxTree surface_tree_;
  LocalPatch& patch_;
  std::vector<SpaceTriangle> placed_;           // of the patch
  std::vector<std::vector<int32_t>> at_point_;  // triangles at each new point
  BoxTree tree_;                                // BoxesInReach
};

}  // namespace

void MovePoints(const LocalHole& hole, std::span<const SpaceTriangle> surface, std::span<const int32_t> crossed,
                LocalPatch& patch) {
  PointMover(hole, surface, patch).Run(crossed);
}

}  // namespace tilemend
