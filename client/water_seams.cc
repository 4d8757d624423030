#include "client/water_seams.h"

#include <algorithm>

namespace tilemend {

void WaterSeams::Add(CellId cell, const std::vector<Point3>& off) {
  for (const Point3& p : off) {
    found_.try_emplace({p.x(), p.y(), p.z()}, Found{cell, cell}).first->second.last = cell;
  }
}

std::vector<WaterSeams::Place> WaterSeams::ReleaseBelow(int32_t row, const OriginalRims& originals) {
  std::vector<Place> places;
  for (auto it = found_.begin(); it != found_.end();) {
    const auto& [key, found] = *it;
    if (std::max(found.first.row, found.last.row) >= row) {
      ++it;
      continue;
    }
    const Point3 p(key[0], key[1], key[2]);
    if (found.first != found.last && !originals.Has(p)) places.push_back({found.first, p});
    it = found_.erase(it);
  }
  return places;
}

}  // namespace tilemend
