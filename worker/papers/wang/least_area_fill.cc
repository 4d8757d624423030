#include "worker/papers/wang/least_area_fill.h"

#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "worker/fill/space/space_fill.h"
#include "worker/papers/wang/minimum_area.h"
#include "worker/papers/wang/wang_fill.h"

namespace tilemend {

LocalPatch FillLeastArea(const LocalHole& hole, const FillOptions& options) {
  std::set<VertexPair> bridges;
  const std::vector<int32_t> loop = JoinedLoop(hole, bridges);
  if (loop.empty()) return {FillFailure::kNoBridge};
  if (std::ssize(loop) > options.wang.longest_loop) return {FillFailure::kTooLongForArea};
  std::vector<Point3> positions;
  for (const int32_t v : loop) positions.push_back(hole.positions[v]);
  std::vector<Triangle> triangles = TriangulateLeastArea(
      positions,
      [&](int32_t i, int32_t k) {
        return hole.MayJoin(loop[i], loop[k]) && !bridges.contains(Undirected(loop[i], loop[k]));
      },
      [](int32_t, int32_t, int32_t) { return true; }, options.refine.is_cancelled);
  if (triangles.empty()) return {FillFailure::kRepeatsEdges};
  for (Triangle& t : triangles) t = {loop[t[0]], loop[t[1]], loop[t[2]]};
  return ShapeAsWang(hole, std::move(triangles), options);
}

}  // namespace tilemend
