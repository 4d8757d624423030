#include "coordinator/plan/hole/touching_holes.h"

#include <algorithm>
#include <set>
#include <unordered_map>

#include "common/mesh/edge_key.h"

namespace tilemend {
namespace {

// The hole at each seam segment.
std::unordered_map<uint64_t, int32_t> HolesAtSeams(const Plan& plan) {
  std::unordered_map<uint64_t, int32_t> hole_at;
  for (size_t h = 0; h < plan.holes.size(); ++h) {
    if (!plan.holes[h].failure.empty()) continue;
    for (const RimSegment& s : plan.holes[h].segments) {
      if (s.seam) hole_at[EdgeKey(s.from, s.to)] = static_cast<int32_t>(h);
    }
  }
  return hole_at;
}

}  // namespace

std::vector<std::pair<int32_t, int32_t>> HolesThatTouch(const Plan& plan) {
  const auto hole_at = HolesAtSeams(plan);
  std::set<std::pair<int32_t, int32_t>> pairs;
  for (const auto& [key, hole] : hole_at) {
    const auto other = hole_at.find(key << 32 | key >> 32);
    if (other == hole_at.end() || other->second == hole) continue;
    if (plan.holes[other->second].water == plan.holes[hole].water) pairs.insert(std::minmax(hole, other->second));
  }
  return {pairs.begin(), pairs.end()};
}

}  // namespace tilemend
