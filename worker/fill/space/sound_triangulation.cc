#include "worker/fill/space/sound_triangulation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "common/mesh/position_index.h"
#include "common/mesh/triangle_shape.h"
#include "worker/fill/space/minimum_weight.h"

namespace tilemend {
namespace {

using Box3 = Eigen::AlignedBox3d;

// Each round forbids at least one triangle; noisy rims need a few.
constexpr int kRounds = 40;

Box3 BoxOf(const SpaceTriangle& t) {
  Box3 box(t[0]);
  box.extend(t[1]);
  box.extend(t[2]);
  return box;
}

double AreaOf(const SpaceTriangle& t) { return TriangleArea(t[0], t[1], t[2]); }

class SoundTriangulator {
 public:
  SoundTriangulator(std::span<const Point3> loop, std::span<const SpaceTriangle> surface) : loop_(loop) {
    Box3 extent;
    PositionIndex index;
    for (const Point3& p : loop) {
      extent.extend(p);
      places_.push_back(index.Insert(p));
    }
    for (const SpaceTriangle& t : surface) {
      const Box3 box = BoxOf(t);
      if (box.intersects(extent) && AreaOf(t) > 0) surface_.emplace_back(box, &t);
    }
  }

  std::vector<Triangle> Run(std::span<const Eigen::Vector3d> outside,
                            const std::function<bool(int32_t, int32_t)>& allowed) {
    std::vector<Triangle> triangles;
    for (int round = 0; round < kRounds; ++round) {
      triangles = TriangulateLoop(loop_, outside, allowed, [&](int32_t i, int32_t j, int32_t k) {
        return Fits({i, j, k});
      });
      if (triangles.empty() || !ForbidCrossing(triangles)) break;
    }
    return triangles;
  }

 private:
  SpaceTriangle InSpace(const Triangle& t) const { return {loop_[t[0]], loop_[t[1]], loop_[t[2]]}; }

  bool Fits(const Triangle& t) {
    const auto [it, fresh] = fits_.try_emplace(KeyOf(t), false);
    if (!fresh) return it->second;
    const SpaceTriangle triangle = InSpace(t);
    const Box3 box = BoxOf(triangle);
    it->second = std::none_of(surface_.begin(), surface_.end(), [&](const auto& other) {
      return other.first.intersects(box) && TrianglesCross(triangle, *other.second);
    });
    return it->second;
  }

  // Forbids the larger one of any two that cross, and the largest of those at an edge with more than two; false if
  // there are none.
  bool ForbidCrossing(const std::vector<Triangle>& triangles) {
    std::vector<SpaceTriangle> in_space;
    for (const Triangle& t : triangles) in_space.push_back(InSpace(t));
    const auto larger = [&](int32_t a, int32_t b) { return AreaOf(in_space[a]) >= AreaOf(in_space[b]) ? a : b; };
    std::vector<int32_t> forbidden;
    for (const auto& [a, b] : SelfCrossings(in_space)) forbidden.push_back(larger(a, b));
    std::map<std::pair<int32_t, int32_t>, std::vector<int32_t>> at_edge;
    for (size_t t = 0; t < triangles.size(); ++t) {
      for (int k = 0; k < 3; ++k) {
        at_edge[std::minmax(places_[triangles[t][k]], places_[triangles[t][(k + 1) % 3]])].push_back(
            static_cast<int32_t>(t));
      }
    }
    for (const auto& [edge, around] : at_edge) {
      if (around.size() > 2) forbidden.push_back(std::accumulate(around.begin(), around.end(), around[0], larger));
    }
    for (const int32_t t : forbidden) fits_[KeyOf(triangles[t])] = false;
    return !forbidden.empty();
  }

  int64_t KeyOf(const Triangle& t) const {
    const auto n = static_cast<int64_t>(loop_.size());
    return (t[0] * n + t[1]) * n + t[2];
  }

  std::span<const Point3> loop_;
  std::vector<int32_t> places_;  // equal for equal positions
  std::vector<std::pair<Box3, const SpaceTriangle*>> surface_;
  std::unordered_map<int64_t, bool> fits_;  // by the corners' numbers
};

}  // namespace

std::vector<Triangle> TriangulateSoundly(std::span<const Point3> loop, std::span<const Eigen::Vector3d> outside,
                                         const std::function<bool(int32_t, int32_t)>& allowed,
                                         std::span<const SpaceTriangle> surface) {
  if (static_cast<int32_t>(loop.size()) > kLongestSoundLoop) return TriangulateLoop(loop, outside, allowed);
  return SoundTriangulator(loop, surface).Run(outside, allowed);
}

}  // namespace tilemend
