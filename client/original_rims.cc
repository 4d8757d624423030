#include "client/original_rims.h"

#include <algorithm>

namespace tilemend {
namespace {

std::array<double, 3> PositionKey(const Point3& p) { return {p.x(), p.y(), p.z()}; }

}  // namespace

void OriginalRims::Add(int32_t row, const std::vector<OpenEdge>& edges) {
  for (const OpenEdge& e : edges) {
    if (e.before == 0) continue;
    for (const Point3* p : {&e.from, &e.to}) {
      int32_t& highest = rows_.try_emplace(PositionKey(*p), row).first->second;
      highest = std::max(highest, row);
    }
  }
}

AreaRim::OriginalEnds OriginalRims::EndsOf(const OpenEdge& edge) const {
  if (!edge.is_added) return {true, true};
  return {Has(edge.from), Has(edge.to)};
}

bool OriginalRims::Has(const Point3& p) const { return rows_.contains(PositionKey(p)); }

void OriginalRims::ForgetBelow(int32_t row) {
  std::erase_if(rows_, [&](const auto& entry) { return entry.second < row; });
}

}  // namespace tilemend
