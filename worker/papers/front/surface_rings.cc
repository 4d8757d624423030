#include "worker/papers/front/surface_rings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>
#include <map>

#include "worker/papers/front/cotangent_system.h"

namespace tilemend {
namespace {

constexpr int32_t kFar = std::numeric_limits<int32_t>::max();

struct WeldedSurface {
  std::vector<Point3> points;
  std::vector<Triangle> triangles;
  int32_t rim = 0;
};

// The vertices of the rim first.
WeldedSurface Weld(std::span<const Point3> rim, std::span<const SpaceTriangle> surface) {
  WeldedSurface welded;
  std::map<std::array<double, 3>, int32_t> number;
  const auto vertex = [&](const Point3& p) {
    const auto [it, is_new] = number.try_emplace({p.x(), p.y(), p.z()}, static_cast<int32_t>(welded.points.size()));
    if (is_new) welded.points.push_back(p);
    return it->second;
  };
  for (const Point3& p : rim) vertex(p);
  welded.rim = static_cast<int32_t>(welded.points.size());
  for (const SpaceTriangle& t : surface) {
    const Triangle corners = {vertex(t[0]), vertex(t[1]), vertex(t[2])};
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0]) {
      welded.triangles.push_back(corners);
    }
  }
  return welded;
}

// The ring of each vertex; 0: the rim; kFar: further off than `rings`.
std::vector<int32_t> RingOf(const WeldedSurface& surface, int32_t rings) {
  std::vector<int32_t> ring(surface.points.size(), kFar);
  std::fill_n(ring.begin(), surface.rim, 0);
  for (int32_t r = 1; r <= rings; ++r) {
    for (const Triangle& t : surface.triangles) {
      const bool touches = ring[t[0]] == r - 1 || ring[t[1]] == r - 1 || ring[t[2]] == r - 1;
      for (const int32_t v : t) {
        if (touches && ring[v] == kFar) ring[v] = r;
      }
    }
  }
  return ring;
}

}  // namespace

std::vector<LaplacianSample> SampleRings(std::span<const Point3> rim, std::span<const SpaceTriangle> surface,
                                         int32_t rings, LaplacianScale scale) {
  const WeldedSurface welded = Weld(rim, surface);
  const std::vector<int32_t> ring = RingOf(welded, rings);
  std::vector<Eigen::Vector3d> sum(welded.points.size(), Eigen::Vector3d::Zero());
  std::vector<double> weight(welded.points.size(), 0);
  // At a vertex that triangles surround, each neighbour ends one edge and begins another.
  std::vector<int64_t> open(welded.points.size(), 0);
  for (const Triangle& t : welded.triangles) {
    const SpaceTriangle corners = {welded.points[t[0]], welded.points[t[1]], welded.points[t[2]]};
    const Eigen::Vector3d cotangents = HalfCotangents(corners), areas = MixedAreas(corners);
    for (int k = 0; k < 3; ++k) {
      const int32_t a = t[(k + 1) % 3], b = t[(k + 2) % 3];
      sum[a] += cotangents[k] * (welded.points[b] - welded.points[a]);
      sum[b] += cotangents[k] * (welded.points[a] - welded.points[b]);
      if (scale == LaplacianScale::kArea) {
        weight[t[k]] += areas[k];
      } else {
        weight[a] += cotangents[k];
        weight[b] += cotangents[k];
      }
      open[t[k]] += a - b;
    }
  }
  std::vector<LaplacianSample> samples;
  for (size_t v = 0; v < welded.points.size(); ++v) {
    if (ring[v] == 0 || ring[v] == kFar || open[v] != 0 || !(weight[v] > 0)) continue;
    samples.push_back({welded.points[v], sum[v] / weight[v]});
  }
  return samples;
}

}  // namespace tilemend
