#include "worker/fill/space/move_points.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <set>

#include "common/mesh/box_tree.h"
#include "common/mesh/triangle_shape.h"
#include "worker/fill/space/patch_crossings.h"
#include "worker/fill/space/patch_edit.h"

namespace tilemend {
namespace {

constexpr int kMaxPasses = 4;
constexpr double kDiagonal = std::numbers::sqrt2 / 2;
constexpr std::array<std::array<double, 2>, 8> kDirections = {{{1, 0},
                                                               {kDiagonal, kDiagonal},
                                                               {0, 1},
                                                               {-kDiagonal, kDiagonal},
                                                               {-1, 0},
                                                               {-kDiagonal, -kDiagonal},
                                                               {0, -1},
                                                               {kDiagonal, -kDiagonal}}};
constexpr double kSteps[] = {0.125, 0.25, 0.5};  // of the mean edge at the point
// Of the mean edge at a point: how far it may go beyond the box of the triangles around it.
constexpr double kMaxBeyond = 2;
// Of the way that a point goes: how far the surface that faces up may rise or fall where the point was.
constexpr double kMaxOff = 0.25;
// Bounds the work: tests of two triangles, seconds in all; triangles around a point that is moved.
constexpr int64_t kMaxTests = 20'000'000;
constexpr size_t kMaxAround = 64;

// HeightOver of a triangle that faces up.
std::optional<double> GroundOver(const SpaceTriangle& t, const Point3& p) {
  return FacesUp(t) ? HeightOver(t, p) : std::nullopt;
}

struct IsBefore {
  bool operator()(const Point3& a, const Point3& b) const { return std::ranges::lexicographical_compare(a, b); }
};

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
    in_star_.assign(placed_.size(), false);
    for (const Point3& p : hole.positions) taken_.insert(p);
    for (const Point3& p : patch.new_points) taken_.insert(p);
    for (const SpaceTriangle& t : surface) taken_.insert(t.begin(), t.end());
  }

  void Run(std::span<const int32_t> crossed) {
    std::set<int32_t> points;
    for (const int32_t t : crossed) {
      for (const int32_t v : patch_.triangles[t]) {
        if (v >= hole_.size() && at_point_[v - hole_.size()].size() <= kMaxAround) points.insert(v - hole_.size());
      }
    }
    FindReaches(points);
    for (int pass = 0; pass < kMaxPasses; ++pass) {
      bool has_moved = false;
      for (const int32_t point : points) has_moved = Move(point) || has_moved;
      if (!has_moved) return;
    }
  }

 private:
  // Where each point may go, and so each triangle.
  void FindReaches(const std::set<int32_t>& points) {
    std::vector<Eigen::AlignedBox3d> boxes;
    Eigen::AlignedBox3d whole;  // the surface is known there
    for (const SpaceTriangle& t : placed_) whole.extend(boxes.emplace_back(BoxOf(t)));
    reach_.resize(at_point_.size());
    is_water_.assign(at_point_.size(), false);
    for (const int32_t point : points) {
      for (const int32_t t : at_point_[point]) reach_[point].extend(BoxOf(placed_[t]));
      const Point3 beyond = Point3::Constant(kMaxBeyond * MeanEdge(point));
      reach_[point] =
          Eigen::AlignedBox3d(reach_[point].min() - beyond, reach_[point].max() + beyond).intersection(whole);
      const Point3& p = patch_.new_points[point];
      is_water_[point] = hole_.WaterLevelAt(p.head<2>()) == p.z();
    }
    for (const int32_t point : points) {
      for (const int32_t t : at_point_[point]) boxes[t].extend(reach_[point]);
    }
    tree_ = BoxTree(boxes);
  }

  // Whether fewer pairs cross afterwards.
  bool Move(int32_t point) {
    const std::vector<int32_t>& around = at_point_[point];
    const Point3 from = patch_.new_points[point];
    for (const int32_t t : around) in_star_[t] = true;
    int fewest = CrossingsOf(StarAt(point, from), std::numeric_limits<int>::max());
    Point3 best = from;
    const double edge = MeanEdge(point);
    for (const double step : kSteps) {
      for (const auto& [x, y] : kDirections) {
        if (fewest == 0 || tests_ > kMaxTests) break;
        const Point3 to = hole_.Storable(OnSurface(point, from + step * edge * Point3(x, y, 0)));
        if (!reach_[point].contains(to) || taken_.contains(to)) continue;
        const std::vector<SpaceTriangle> star = StarAt(point, to);
        if (!KeepsFacing(around, star) || !KeepsHeight(from, (to - from).norm(), star)) continue;
        const int count = CrossingsOf(star, fewest);
        if (count >= fewest || tests_ > kMaxTests) continue;
        fewest = count;
        best = to;
      }
    }
    for (const int32_t t : around) in_star_[t] = false;
    if (best == from) return false;
    taken_.insert(best);
    patch_.new_points[point] = best;
    const std::vector<SpaceTriangle> star = StarAt(point, best);
    for (size_t k = 0; k < around.size(); ++k) placed_[around[k]] = star[k];
    return true;
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

  // At the water's level if the point is water. Else at the height of the surface that faces up around the point; at
  // its own beside that.
  Point3 OnSurface(int32_t point, const Point3& p) const {
    if (is_water_[point]) return {p.x(), p.y(), *hole_.WaterLevelAt(p.head<2>())};
    for (const int32_t t : at_point_[point]) {
      if (const std::optional<double> height = GroundOver(placed_[t], p)) return p + Point3(0, 0, *height);
    }
    return p;
  }

  // Whether no triangle turns over or loses its area, and what faced up still does.
  bool KeepsFacing(std::span<const int32_t> around, std::span<const SpaceTriangle> star) const {
    for (size_t k = 0; k < around.size(); ++k) {
      const Eigen::Vector3d before = TwiceVectorArea(placed_[around[k]]), after = TwiceVectorArea(star[k]);
      if (!HasArea(star[k]) || before.dot(after) <= 0) return false;
      if (FacesUp(placed_[around[k]]) && !FacesUp(star[k])) return false;
    }
    return true;
  }

  // Whether what faces up is still near where the point was.
  static bool KeepsHeight(const Point3& from, double way, std::span<const SpaceTriangle> star) {
    return std::ranges::all_of(star, [&](const SpaceTriangle& t) {
      const std::optional<double> height = GroundOver(t, from);
      return !height || std::abs(*height) <= kMaxOff * way;
    });
  }

  // Pairs of triangles that cross, one or both of the star; counted up to a bound.
  int CrossingsOf(const std::vector<SpaceTriangle>& star, int bound) {
    auto count = static_cast<int>(SelfCrossings(star).size());
    tests_ += std::ssize(star) * std::ssize(star);
    for (const SpaceTriangle& t : star) {
      if (count >= bound) break;
      const Eigen::AlignedBox3d box = BoxOf(t);
      const auto meet = [&](const SpaceTriangle& other) {
        ++tests_;
        if (BoxOf(other).intersects(box) && HasArea(other) && TrianglesCross(t, other)) ++count;
        return count >= bound || tests_ > kMaxTests;
      };
      surface_tree_.AnyMeeting(box, [&](int32_t other) { return meet(surface_[other]); });
      tree_.AnyMeeting(box, [&](int32_t other) { return !in_star_[other] && meet(placed_[other]); });
    }
    return count;
  }

  const LocalHole& hole_;
  const std::span<const SpaceTriangle> surface_;
  const BoxTree surface_tree_;
  LocalPatch& patch_;
  std::vector<SpaceTriangle> placed_;           // of the patch
  std::vector<std::vector<int32_t>> at_point_;  // triangles at each new point
  std::vector<Eigen::AlignedBox3d> reach_;      // of each new point
  std::vector<bool> is_water_;                  // the same: it lies in the water
  BoxTree tree_;                                // where each triangle of the patch may come
  std::vector<bool> in_star_;                   // triangles at the point that is moved
  std::set<Point3, IsBefore> taken_;            // places where there is, or was, a vertex
  int64_t tests_ = 0;
};

}  // namespace

void MovePoints(const LocalHole& hole, std::span<const SpaceTriangle> surface, std::span<const int32_t> crossed,
                LocalPatch& patch) {
  PointMover(hole, surface, patch).Run(crossed);
}

}  // namespace tilemend
