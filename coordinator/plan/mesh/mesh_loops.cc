#include "coordinator/plan/mesh/mesh_loops.h"

#include <Eigen/Geometry>
#include <set>
#include <unordered_map>

#include "common/mesh/disjoint_sets.h"

namespace tilemend {
namespace {

MeshLoop ReadLoop(const Rim& rim, const SurveyRecord& record, const std::vector<int32_t>& edges) {
  MeshLoop loop;
  loop.segments = Reversed(rim, edges);
  // The edges of one mesh are all unmatched: those of the rim are those of the record, in its order.
  loop.piece = record.edges[edges.front()].piece;
  const Point3& origin = rim.points[loop.segments[0].from].position;
  for (const RimSegment& s : loop.segments) {
    const Point3 &from = rim.points[s.from].position, &to = rim.points[s.to].position;
    loop.vector_area += (from - origin).cross(to - origin) / 2;
    loop.normal += rim.points[s.from].normal / static_cast<double>(loop.segments.size());
    loop.middle += from / static_cast<double>(loop.segments.size());
    loop.length += (to - from).norm();
  }
  return loop;
}

void FindGroups(std::vector<MeshLoop>& loops) {
  DisjointSets sets(static_cast<int32_t>(loops.size()));
  std::unordered_map<int32_t, int32_t> loop_at;  // by point
  for (size_t l = 0; l < loops.size(); ++l) {
    for (const RimSegment& s : loops[l].segments) {
      const auto [it, fresh] = loop_at.try_emplace(s.from, static_cast<int32_t>(l));
      if (fresh) continue;
      sets.Join(it->second, static_cast<int32_t>(l));
      loops[l].touches = loops[it->second].touches = true;
    }
  }
  const std::vector<int32_t> groups = sets.Groups();
  for (size_t l = 0; l < loops.size(); ++l) loops[l].group = groups[l];
}

}  // namespace

std::vector<MeshLoop> ReadMeshLoops(const Rim& rim, const SurveyRecord& record) {
  std::vector<MeshLoop> loops;
  for (const std::vector<int32_t>& edges : rim.loops) loops.push_back(ReadLoop(rim, record, edges));
  FindGroups(loops);
  return loops;
}

int32_t CountContinuous(const std::vector<MeshLoop>& loops) {
  std::set<int32_t> groups;
  for (const MeshLoop& loop : loops) {
    if (loop.touches) groups.insert(loop.group);
  }
  return static_cast<int32_t>(groups.size());
}

}  // namespace tilemend
