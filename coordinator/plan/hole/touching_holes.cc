#include "coordinator/plan/hole/touching_holes.h"

#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>

#include "common/mesh/edge_key.h"
#include "coordinator/plan/types/cell_side.h"

namespace tilemend {
namespace {

uint64_t UndirectedKey(int32_t a, int32_t b) { return EdgeKey(std::min(a, b), std::max(a, b)); }

// The hole at each seam segment.
std::unordered_map<uint64_t, int32_t> HolesAtSeams(const Plan& plan, uint64_t (*key)(int32_t, int32_t)) {
  std::unordered_map<uint64_t, int32_t> hole_at;
  for (size_t h = 0; h < plan.holes.size(); ++h) {
    if (!plan.holes[h].failure.empty()) continue;
    for (const RimSegment& s : plan.holes[h].segments) {
      if (s.seam) hole_at[key(s.from, s.to)] = static_cast<int32_t>(h);
    }
  }
  return hole_at;
}

// What one hole takes up of a border.
struct Stretch {
  double lo, hi;  // along the line
  int32_t hole;
};

}  // namespace

std::vector<std::pair<int32_t, int32_t>> HolesThatTouch(const Plan& plan) {
  const auto hole_at = HolesAtSeams(plan, EdgeKey);
  std::set<std::pair<int32_t, int32_t>> pairs;
  for (const auto& [key, hole] : hole_at) {
    const auto other = hole_at.find(key << 32 | key >> 32);
    if (other != hole_at.end() && other->second != hole) pairs.insert(std::minmax(hole, other->second));
  }
  return {pairs.begin(), pairs.end()};
}

std::vector<std::pair<int32_t, int32_t>> HolesThatFace(const Plan& plan) {
  const auto hole_at = HolesAtSeams(plan, UndirectedKey);
  std::map<std::pair<CellId, CellId>, std::vector<Stretch>> along;
  for (const Seam& seam : plan.seams) {
    const int axis = AxisAlong({seam.a, seam.b});
    const auto hole = hole_at.find(UndirectedKey(seam.vertices[0], seam.vertices[1]));
    if (hole == hole_at.end()) continue;
    along[{seam.a, seam.b}].push_back({plan.vertices[seam.vertices.front()].position[axis],
                                       plan.vertices[seam.vertices.back()].position[axis], hole->second});
  }
  std::set<std::pair<int32_t, int32_t>> pairs;
  for (const auto& [border, stretches] : along) {
    for (auto a = stretches.begin(); a != stretches.end(); ++a) {
      for (auto b = a + 1; b != stretches.end(); ++b) {
        if (a->hole != b->hole && a->lo < b->hi && b->lo < a->hi) pairs.insert(std::minmax(a->hole, b->hole));
      }
    }
  }
  return {pairs.begin(), pairs.end()};
}

}  // namespace tilemend
