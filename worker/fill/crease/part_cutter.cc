#include "worker/fill/crease/part_cutter.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace tilemend {
namespace {

using Eigen::Vector3d;

// The normal of the surface along the rim follows that beside each edge by this share.
constexpr double kFollow = 0.3;

// Cuts the loops of a hole along the curves of a network.
class PartCutter {
 public:
  PartCutter(const LocalHole& hole, const CreaseNetwork& network, const std::vector<std::vector<int32_t>>& curve_points)
      : hole_(hole), loops_(hole.loops), network_(network), curve_points_(curve_points) {
    curve_of_.assign(network.ends.size(), -1);
    for (size_t c = 0; c < network.curves.size(); ++c) {
      const CreaseCurve& curve = network.curves[c];
      for (const int32_t end : {curve.from, curve.to}) {
        if (end >= 0) curve_of_[end] = static_cast<int32_t>(c);
      }
    }
  }

  std::vector<PartBoundary> Run() const {
    std::vector<PartBoundary> parts;
    std::vector<bool> used(network_.ends.size(), false);
    for (int32_t e = 0; e < static_cast<int32_t>(used.size()); ++e) {
      if (used[e] || curve_of_[e] < 0) continue;
      std::vector<PartCorner> loop;
      for (int32_t at = e; !used[at];) {
        used[at] = true;
        at = AlongRim(at, loop);
        at = AlongCurve(at, loop);
      }
      parts.push_back({std::move(loop)});
    }
    return parts;
  }

  // Whether a curve ends at a loop.
  bool Touches(int32_t loop) const {
    for (size_t e = 0; e < curve_of_.size(); ++e) {
      if (curve_of_[e] >= 0 && network_.ends[e].loop == loop) return true;
    }
    return false;
  }

 private:
  // From an end along the rim to the next one that a curve leaves from; appends the vertices on the way, the last one
  // left out.
  int32_t AlongRim(int32_t end, std::vector<PartCorner>& corners) const {
    const CreaseEnd& from = network_.ends[end];
    const RimLoop& loop = loops_[from.loop];
    int32_t next = -1, least = 0;
    for (int32_t e = 0; e < static_cast<int32_t>(curve_of_.size()); ++e) {
      if (curve_of_[e] < 0 || network_.ends[e].loop != from.loop) continue;
      const int32_t way = (RankOf(e) - RankOf(end) + 2 * loop.size() - 1) % (2 * loop.size()) + 1;
      if (next >= 0 && way >= least) continue;
      next = e;
      least = way;
    }
    const int32_t edges = (least + from.order - network_.ends[next].order) / 2;
    Vector3d normal = from.after;
    for (int32_t k = 0; k < edges; ++k) {
      const int32_t place = (from.place + k) % loop.size();
      corners.push_back({loop.vertices[place], normal, k == 0});
      // Where the rim runs along the crease the surface beside it is that of the other side.
      if (loop.outside[place].dot(normal) < kSamePartCosine) continue;
      normal = (normal + kFollow * (loop.outside[place] - normal)).normalized();
    }
    return next;
  }

  // From an end along its curve, and on from corners, to the end from which the part's boundary goes on along the rim;
  // appends end and points.
  int32_t AlongCurve(int32_t end, std::vector<PartCorner>& corners) const {
    const CreaseEnd& from = network_.ends[end];
    corners.push_back({loops_[from.loop].vertices[from.place], from.before, true});
    int32_t at = end, by = curve_of_[end];
    while (true) {
      const CreaseCurve& curve = network_.curves[by];
      AppendPoints(by, at == curve.from, corners);
      at = at == curve.from ? curve.to : curve.from;
      if (at >= 0) return at;
      corners.push_back({hole_.size() - 1 - at});  // corners are the first new points
      const auto& around = network_.corners[-1 - at].curves;
      const auto place = static_cast<size_t>(std::ranges::find(around, by) - around.begin());
      by = around[(place + around.size() - 1) % around.size()];
    }
  }

  void AppendPoints(int32_t c, bool forward, std::vector<PartCorner>& corners) const {
    std::vector<int32_t> points = curve_points_[c];
    if (!forward) std::reverse(points.begin(), points.end());
    for (const int32_t p : points) corners.push_back({hole_.size() + p});
  }

  // The ends of a loop in order have rising ranks.
  int32_t RankOf(int32_t end) const { return 2 * network_.ends[end].place + network_.ends[end].order; }

  const LocalHole& hole_;
  const std::vector<RimLoop>& loops_;
  const CreaseNetwork& network_;
  const std::vector<std::vector<int32_t>>& curve_points_;
  std::vector<int32_t> curve_of_;  // per end; -1: none
};

// A place that islands are looked at from: a part's outer loop.
class PartView {
 public:
  PartView(const LocalHole& hole, std::span<const Point3> new_points, const std::vector<PartCorner>& outer) {
    for (const PartCorner& c : outer) {
      outer_.push_back(c.vertex < hole.size() ? hole.positions[c.vertex] : new_points[c.vertex - hole.size()]);
    }
    for (const Point3& p : outer_) middle_ += p / static_cast<double>(outer_.size());
    for (size_t i = 0; i < outer_.size(); ++i) {
      normal_ += (outer_[i] - middle_).cross(outer_[(i + 1) % outer_.size()] - middle_);
    }
    normal_.normalize();
  }

  // How far off the part's plane p is.
  double DistanceTo(const Point3& p) const { return std::abs(normal_.dot(p - middle_)); }

  // Whether the loop goes around the line through p along the normal.
  bool GoesAround(const Point3& p) const {
    double angle = 0;
    for (size_t i = 0; i < outer_.size(); ++i) {
      Vector3d a = outer_[i] - p, b = outer_[(i + 1) % outer_.size()] - p;
      a -= a.dot(normal_) * normal_;
      b -= b.dot(normal_) * normal_;
      angle += std::atan2(a.cross(b).dot(normal_), a.dot(b));
    }
    return angle > std::numbers::pi;
  }

 private:
  std::vector<Point3> outer_;
  Point3 middle_ = Point3::Zero();
  Vector3d normal_ = Vector3d::Zero();
};

std::vector<PartCorner> WholeLoop(const LocalHole& hole, const RimLoop& loop) {
  std::vector<PartCorner> corners;
  for (const int32_t v : loop.vertices) corners.push_back({v, hole.normals[v], false});
  return corners;
}

}  // namespace

std::vector<PartBoundary> CutAlong(const CreaseNetwork& network, const LocalHole& hole,
                                   std::span<const Point3> new_points,
                                   const std::vector<std::vector<int32_t>>& curve_points) {
  const PartCutter cutter(hole, network, curve_points);
  std::vector<PartBoundary> parts = cutter.Run();
  std::vector<PartView> views;
  for (const PartBoundary& part : parts) views.emplace_back(hole, new_points, part[0]);
  for (size_t l = 0; l < hole.loops.size(); ++l) {
    if (cutter.Touches(static_cast<int32_t>(l))) continue;
    const Point3& p = hole.loops[l].positions[0];
    PartBoundary* nearest = nullptr;
    double least = INFINITY;
    for (size_t k = 0; k < parts.size(); ++k) {
      const double off = views[k].DistanceTo(p);
      if (off >= least || !views[k].GoesAround(p)) continue;
      least = off;
      nearest = &parts[k];
    }
    if (nearest == nullptr) return {};
    nearest->push_back(WholeLoop(hole, hole.loops[l]));
  }
  return parts;
}

}  // namespace tilemend
