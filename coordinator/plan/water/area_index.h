// Which areas of the user's cover a region, found by where they lie.
#ifndef TILEMEND_COORDINATOR_PLAN_WATER_AREA_INDEX_H_
#define TILEMEND_COORDINATOR_PLAN_WATER_AREA_INDEX_H_

#include <optional>
#include <span>
#include <vector>

#include "common/mesh/polygon_tree.h"
#include "coordinator/plan/water/area_cover.h"

namespace tilemend {

// Answers only what it is asked until it is cancelled: then shares are missing, and nothing is decided.
class AreaIndex {
 public:
  // Of areas that stay as they are, and where. `is_cancelled` is asked for each area that a region may meet.
  explicit AreaIndex(std::span<const WaterArea> areas, IsCancelled is_cancelled = {});

  bool cancelled() const { return is_cancelled_ && is_cancelled_(); }

  // The areas for which counts(area) that cover some of the region, in rising order. Cost as CoverLines::ShareIn for
  // each area whose bounds meet those of the region.
  template <typename Counts>
  std::vector<AreaShare> SharesOf(const CoverLines& region, const Counts& counts) const;

  // FindDecidingArea of these areas.
  std::optional<DecidingArea> DeciderOf(const CoverLines& region, std::span<const AreaShare> shares) const {
    return FindDecidingArea(region, shares, areas_, is_cancelled_);
  }

 private:
  std::span<const WaterArea> areas_;
  IsCancelled is_cancelled_;
  PolygonTree tree_;
};

template <typename Counts>
std::vector<AreaShare> AreaIndex::SharesOf(const CoverLines& region, const Counts& counts) const {
  std::vector<AreaShare> shares;
  for (const int32_t a : tree_.Meeting(region.lo(), region.hi())) {
    if (cancelled()) return {};
    if (!counts(areas_[a])) continue;
    const double share = region.ShareIn(areas_[a]);
    if (share > 0) shares.push_back({static_cast<size_t>(a), share});
  }
  return shares;
}

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_PLAN_WATER_AREA_INDEX_H_
