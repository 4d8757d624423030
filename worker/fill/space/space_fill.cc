#include "worker/fill/space/space_fill.h"

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>

#include "common/mesh/rounding.h"
#include "worker/fill/space/cone_fill.h"
#include "worker/fill/space/faired_fill.h"
#include "worker/fill/space/loop_bridges.h"
#include "worker/fill/space/sound_triangulation.h"
#include "worker/fill/space/unrolled_fill.h"

namespace tilemend {
namespace {

// How far a patch over triangles of the rim alone bends, tried in this order.
constexpr double kBends[] = {1, 0.5, 0};
// Of the ways to tie the first island to the rest of a rim.
constexpr size_t kBridgesTried = 12;

BridgeEnds EndsIn(const LocalHole& hole) {
  return {[&](int32_t v) { return hole.positions[v]; }, [&](int32_t a, int32_t b) { return hole.MayJoin(a, b); }};
}

void Cross(const Bridge& bridge, std::vector<VertexLoop>& loops, std::set<VertexPair>& bridges) {
  const VertexPair ends = Undirected(loops[0][bridge.from], loops[bridge.loop][bridge.to]);
  if (BuildBridge(bridge, loops)) bridges.insert(ends);
}

// A loop of vertices of the hole, as what triangulates it takes it.
struct LoopInSpace {
  LoopInSpace(const LocalHole& hole, const VertexLoop& loop, const std::set<VertexPair>& used)
      : allowed([&](int32_t a, int32_t b) {
          return hole.MayJoin(loop[a], loop[b]) && !used.contains(Undirected(loop[a], loop[b]));
        }) {
    for (size_t i = 0; i < loop.size(); ++i) {
      positions.push_back(hole.positions[loop[i]]);
      outside.push_back(hole.NormalBeside(loop[i], loop[(i + 1) % loop.size()]));
    }
  }

  std::vector<Point3> positions;
  std::vector<Eigen::Vector3d> outside;
  std::function<bool(int32_t, int32_t)> allowed;
};

LocalPatch CloseLoopByCone(const LocalHole& hole, const VertexLoop& loop, const std::set<VertexPair>& bridges,
                           const CrossingIndex& surface) {
  // In scenes folds are cut off instead, which keeps to the ground.
  if (hole.cell->upright) return {FillFailure::kCrosses};
  const LoopInSpace in_space(hole, loop, bridges);
  const std::optional<ConeFill> cone =
      CloseByCone(in_space.positions, in_space.outside, in_space.allowed, surface,
                  [&](const Point3& p) { return RoundedToLattice(p, hole.cell->lattice_step); });
  if (!cone) return {FillFailure::kCrosses};
  LocalPatch patch;
  patch.is_bare = true;
  patch.new_points = {cone->tip};
  const auto vertex = [&](int32_t place) { return place < std::ssize(loop) ? loop[place] : hole.size(); };
  for (const Triangle& t : cone->triangles) patch.triangles.push_back({vertex(t[0]), vertex(t[1]), vertex(t[2])});
  return patch;
}

LocalPatch FillLoop(const LocalHole& hole, const VertexLoop& loop, const std::set<VertexPair>& bridges,
                    const FillOptions& options, const CrossingIndex& surface, CrossingCheck& check) {
  LocalPatch patch;
  patch.triangles = TriangulateInSpace(hole, loop, bridges, surface);
  if (patch.triangles.empty()) return CloseLoopByCone(hole, loop, bridges, surface);
  if (options.surface == Surface::kWang) {
    LocalPatch shaped = options.published->in_space(hole, patch.triangles, options);
    if (shaped.ok() && check.StaysNear(shaped) && check.IsSound(shaped)) return shaped;
    patch.is_bare = true;
    return patch;
  }
  if (bridges.empty() && hole.size() <= kLongestSpatialLoop) {
    for (const double bend : kBends) {
      LocalPatch refined = FillOver(patch.triangles, bend, hole, options);
      if (refined.ok() && check.StaysNear(refined) && check.IsSound(refined)) return refined;
    }
  }
  LocalPatch faired = FillFaired(patch.triangles, hole, options, check);
  if (faired.ok() && check.StaysNear(faired)) return faired;
  patch.is_bare = true;
  return check.IsSound(patch) ? patch : CloseLoopByCone(hole, loop, bridges, surface);
}

}  // namespace

std::vector<Triangle> TriangulateInSpace(const LocalHole& hole, const std::vector<int32_t>& loop,
                                         const std::set<VertexPair>& used, const CrossingIndex& surface) {
  const LoopInSpace in_space(hole, loop, used);
  std::vector<Triangle> triangles = TriangulateSoundly(in_space.positions, in_space.outside, in_space.allowed, surface);
  for (Triangle& t : triangles) t = {loop[t[0]], loop[t[1]], loop[t[2]]};
  return triangles;
}

std::vector<int32_t> JoinedLoop(const LocalHole& hole, std::set<VertexPair>& bridges) {
  std::vector<VertexLoop> loops;
  for (const RimLoop& loop : hole.loops) loops.push_back(loop.vertices);
  while (loops.size() > 1) {
    const std::vector<Bridge> next = BridgesFrom(EndsIn(hole), loops);
    if (next.empty()) return {};
    Cross(next[0], loops, bridges);
  }
  return loops.empty() ? VertexLoop() : loops[0];
}

LocalPatch FillInSpace(const LocalHole& hole, const FillOptions& options, CrossingCheck& check) {
  const bool too_long = hole.cell->upright && hole.segments.size() > kLongestSpatialLoop;
  if (hole.loops.empty() || too_long) return {FillFailure::kTooLongForSpace};
  std::vector<VertexLoop> loops;
  for (const RimLoop& loop : hole.loops) loops.push_back(loop.vertices);
  const CrossingIndex surface(check.Surface());
  if (loops.size() == 1) return FillLoop(hole, loops[0], {}, options, surface, check);
  LocalPatch patch{FillFailure::kNoBridge};
  const std::vector<Bridge> first = BridgesFrom(EndsIn(hole), loops);
  for (size_t b = 0; b < std::min(first.size(), kBridgesTried); ++b) {
    std::vector<VertexLoop> joined = loops;
    std::set<VertexPair> used;
    Cross(first[b], joined, used);
    while (joined.size() > 1) {
      const std::vector<Bridge> next = BridgesFrom(EndsIn(hole), joined);
      if (next.empty()) return patch;
      Cross(next[0], joined, used);
    }
    patch = FillLoop(hole, joined[0], used, options, surface, check);
    if (patch.ok() && check.IsSound(patch)) return patch;
  }
  return patch;
}

}  // namespace tilemend
