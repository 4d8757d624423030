#include "worker/fill/seam/smooth_seam.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "common/mesh/bin_grid.h"
#include "common/mesh/rounding.h"

namespace tilemend {
namespace {

struct SmoothPoint {
  Point3 position;
  int32_t number = -1;  // among the new points of its side; else it is of the rim
};

struct Reach {
  Point2 position;
  double width = 0;  // metres
};

Eigen::AlignedBox2d BoxAround(const Point2& p, double reach) {
  return {p - Point2::Constant(reach), p + Point2::Constant(reach)};
}

class Smoother {
 public:
  Smoother(const SeamHeightColumns& seam, const SeamSmoothing& options) : options_(options) {
    for (size_t i = 0; i < seam.seam_vertex.size(); ++i) {
      place_of_[seam.seam_vertex[i]] = static_cast<int32_t>(i);
      points_.push_back({Point3(0, 0, seam.height[i])});
    }
    reaches_.resize(points_.size());
    found_.assign(points_.size(), false);
  }

  // Returns which of all points are the side's.
  std::pair<size_t, size_t> Add(const SeamSide& side) {
    const size_t first = points_.size();
    std::vector<bool> used(side.vertices.size(), false);
    int32_t number = 0;
    for (const HolePatch& patch : side.patches) {
      const auto count = static_cast<int32_t>(patch.new_points.size());
      if (std::find(side.holes.begin(), side.holes.end(), patch.hole) != side.holes.end()) {
        for (int32_t k = 0; k < count; ++k) points_.push_back({patch.new_points[k], number + k});
        for (const Triangle& t : patch.triangles) {
          for (const int32_t v : t) {
            if (v >= 0) used[v] = true;
          }
        }
      }
      number += count;
    }
    for (size_t v = 0; v < used.size(); ++v) {
      if (used[v]) AddRimVertex(side.vertices[v]);
    }
    return {first, points_.size()};
  }

  void Index() {
    for (size_t i = 0; i < reaches_.size(); ++i) {
      if (!found_[i]) reaches_[i].width = 0;
    }
    Eigen::AlignedBox2d extent;
    double widest = 0;
    for (const Reach& r : reaches_) {
      if (r.width == 0) continue;
      extent.extend(BoxAround(r.position, 2 * r.width));
      widest = std::max(widest, r.width);
    }
    if (widest == 0) return;
    near_.emplace(extent, widest, static_cast<int32_t>(reaches_.size()),
                  [&](int32_t i) { return BoxAround(reaches_[i].position, reaches_[i].width); });
    bins_.emplace(extent, widest, static_cast<int32_t>(points_.size()), [&](int32_t i) {
      const Point2 p = points_[i].position.head<2>();
      return Eigen::AlignedBox2d(p, p);
    });
  }

  // Equations 5 and 6; nothing for a point out of the buffer.
  std::optional<double> Smoothed(size_t i) const {
    const Point2 p = points_[i].position.head<2>();
    const double width = WidthAt(p);
    if (width == 0) return std::nullopt;
    const double height = points_[i].position.z();
    double sum = 0;
    int count = 0;
    for (const int32_t k : bins_->In(BoxAround(p, width))) {
      if (k == static_cast<int32_t>(i) || (points_[k].position.head<2>() - p).norm() > width) continue;
      if (k < std::ssize(found_) && !found_[k]) continue;
      sum += points_[k].position.z() - height;
      ++count;
    }
    if (count == 0) return std::nullopt;
    return RoundedToLattice(height + options_.gamma * sum / count, options_.lattice_step);
  }

  double HeightOf(size_t i) const { return points_[i].position.z(); }

  std::vector<SmoothedPoint> SmoothedOf(const std::pair<size_t, size_t>& range) const {
    std::vector<SmoothedPoint> moved;
    for (size_t i = range.first; i < range.second; ++i) {
      if (points_[i].number < 0) continue;
      if (const auto height = Smoothed(i)) moved.push_back({points_[i].number, *height});
    }
    return moved;
  }

 private:
  void AddRimVertex(const RimVertex& v) {
    const auto place = v.index < 0 ? place_of_.find(v.follows >= 0 ? v.follows : v.seam_vertex) : place_of_.end();
    if (place == place_of_.end()) {
      const bool fresh = rim_places_.insert({v.position.x(), v.position.y(), v.position.z()}).second;
      if (fresh) points_.push_back({v.position});
      return;
    }
    const int32_t i = place->second;
    if (found_[i]) return;
    found_[i] = true;
    points_[i].position.head<2>() = v.position.head<2>();
    reaches_[i] = {v.position.head<2>(), options_.buffer * v.size};
  }

  // Of the buffer at a point; 0 outside.
  double WidthAt(const Point2& p) const {
    if (!near_) return 0;
    double width = 0, nearest = 0;
    for (const int32_t i : near_->In(BoxAround(p, 0))) {
      const double distance = (reaches_[i].position - p).norm();
      if (distance > reaches_[i].width || (width > 0 && distance >= nearest)) continue;
      nearest = distance;
      width = reaches_[i].width;
    }
    return width;
  }

  const SeamSmoothing options_;
  std::map<int32_t, int32_t> place_of_;  // of seam vertices
  std::vector<SmoothPoint> points_;      // the seam's first
  std::set<std::array<double, 3>> rim_places_;
  std::vector<bool> found_;             // of the seam's: a patch has it
  std::vector<Reach> reaches_;          // of the seam's
  std::optional<BinGrid> near_, bins_;  // of reaches_, of points_
};

}  // namespace

SmoothedPatches SmoothSeam(const SeamSide& a, const SeamSide& b, const SeamHeightColumns& seam,
                           const SeamSmoothing& options) {
  Smoother smoother(seam, options);
  const auto of_a = smoother.Add(a), of_b = smoother.Add(b);
  smoother.Index();
  SmoothedPatches smoothed;
  for (size_t i = 0; i < seam.seam_vertex.size(); ++i) {
    smoothed.heights.push_back(smoother.Smoothed(i).value_or(smoother.HeightOf(i)));
  }
  smoothed.a = smoother.SmoothedOf(of_a);
  smoothed.b = smoother.SmoothedOf(of_b);
  return smoothed;
}

}  // namespace tilemend
