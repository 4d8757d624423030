#include "worker/fill/space/sound_triangulation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <utility>

#include "common/mesh/position_index.h"
#include "common/mesh/triangle_shape.h"
#include "worker/fill/space/clip_ears.h"
#include "worker/fill/space/patch_crossings.h"

namespace tilemend {
namespace {

// Each round forbids at least one triangle; noisy rims need a few.
constexpr int kRounds = 40;
// Long loops are cut down to this: few enough to choose the best of all triangulations, enough to have a shape.
constexpr int32_t kClippedTo = 60;

double AreaOf(const SpaceTriangle& t) { return TriangleArea(t[0], t[1], t[2]); }

class SoundTriangulator {
 public:
  SoundTriangulator(std::span<const Point3> loop, const CrossingIndex& surface) : loop_(loop), surface_(surface) {
    PositionIndex index;
    for (const Point3& p : loop) places_.push_back(index.Insert(p));
    fits_.assign(loop.size() * loop.size() * loop.size(), Answer::kUnknown);
  }

  std::vector<Triangle> Run(std::span<const Eigen::Vector3d> outside,
                            const std::function<bool(int32_t, int32_t)>& allowed, Misfits misfits) {
    const std::function<bool(int32_t, int32_t, int32_t)> fits = [&](int32_t i, int32_t j, int32_t k) {
      return Fits({i, j, k});
    };
    LoopTriangulation triangulation(loop_, outside, allowed, fits, misfits);
    std::vector<Triangle> triangles;
    for (int round = 0; round < kRounds; ++round) {
      triangles = triangulation.Run();
      if (triangles.empty() || !ForbidCrossing(triangles, triangulation)) break;
    }
    return triangles;
  }

 private:
  enum class Answer : uint8_t { kUnknown, kNo, kYes };

  SpaceTriangle InSpace(const Triangle& t) const { return {loop_[t[0]], loop_[t[1]], loop_[t[2]]}; }

  bool Fits(const Triangle& t) {
    Answer& answer = fits_[KeyOf(t)];
    if (answer == Answer::kUnknown) answer = surface_.IsCrossedBy(InSpace(t)) ? Answer::kNo : Answer::kYes;
    return answer == Answer::kYes;
  }

  // Forbids the larger one of any two that cross, and the largest of those at an edge with more than two; false if
  // there are none that were not forbidden before.
  bool ForbidCrossing(const std::vector<Triangle>& triangles, LoopTriangulation& triangulation) {
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
    bool is_new = false;
    for (const int32_t t : forbidden) {
      Answer& answer = fits_[KeyOf(triangles[t])];
      is_new = is_new || answer != Answer::kNo;
      answer = Answer::kNo;
      triangulation.Forbid(triangles[t]);
    }
    return is_new;
  }

  size_t KeyOf(const Triangle& t) const {
    const size_t n = loop_.size();
    return (static_cast<size_t>(t[0]) * n + static_cast<size_t>(t[1])) * n + static_cast<size_t>(t[2]);
  }

  std::span<const Point3> loop_;
  std::vector<int32_t> places_;  // equal for equal positions
  const CrossingIndex& surface_;
  std::vector<Answer> fits_;  // by the corners' numbers
};

}  // namespace

std::vector<Triangle> TriangulateSoundly(std::span<const Point3> loop, std::span<const Eigen::Vector3d> outside,
                                         const std::function<bool(int32_t, int32_t)>& allowed,
                                         const CrossingIndex& surface, Misfits misfits) {
  if (static_cast<int32_t>(loop.size()) <= kLongestSoundLoop)
    return SoundTriangulator(loop, surface).Run(outside, allowed, misfits);
  CrossingIndex taken = surface;
  ClippedLoop clipped = ClipEars(loop, outside, allowed, kClippedTo, taken);
  const std::vector<int32_t>& rest = clipped.rest;
  if (static_cast<int32_t>(rest.size()) > kLongestSoundLoop) return {};
  std::vector<Point3> places;
  for (const int32_t i : rest) places.push_back(loop[i]);
  const auto allowed_rest = [&](int32_t i, int32_t k) { return allowed(rest[i], rest[k]); };
  const std::vector<Triangle> inner = SoundTriangulator(places, taken).Run(clipped.outside, allowed_rest, misfits);
  if (inner.empty()) return {};
  for (const Triangle& t : inner) clipped.triangles.push_back({rest[t[0]], rest[t[1]], rest[t[2]]});
  return std::move(clipped.triangles);
}

}  // namespace tilemend
