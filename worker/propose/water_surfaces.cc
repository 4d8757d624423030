#include "worker/propose/water_surfaces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <utility>

#include "common/mesh/box_tree.h"
#include "common/mesh/disjoint_sets.h"
#include "worker/ground/join_rasters.h"

namespace tilemend {
namespace {

Eigen::AlignedBox3d BoxOf(const GroundRaster& r) {
  if (r.empty()) return {};
  return {Point3(r.col * r.square, r.row * r.square, 0),
          Point3((r.col + r.cols) * r.square, (r.row + r.rows) * r.square, 0)};
}

// Rasters that are so far from all others that neither tells what is ground in the other are a group of their own.
std::vector<std::vector<GroundRaster>> GroupsOf(std::span<const GroundRaster> rasters) {
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const GroundRaster& r : rasters) boxes.push_back(BoxOf(r));
  const BoxTree tree(boxes);
  DisjointSets sets(static_cast<int32_t>(rasters.size()));
  const Point3 reach = Point3::Constant(kGroundReach);
  for (size_t i = 0; i < boxes.size(); ++i) {
    if (boxes[i].isEmpty()) continue;
    tree.AnyMeeting({boxes[i].min() - reach, boxes[i].max() + reach}, [&](int32_t other) {
      sets.Join(static_cast<int32_t>(i), other);
      return false;
    });
  }
  std::vector<std::vector<GroundRaster>> groups;
  const std::vector<int32_t> group = sets.Groups();
  for (size_t i = 0; i < rasters.size(); ++i) {
    const auto number = static_cast<size_t>(group[i]);
    if (number >= groups.size()) groups.resize(number + 1);
    groups[number].push_back(rasters[i]);
  }
  return groups;
}

std::vector<LowRegion> FindIn(std::span<const GroundRaster> rasters, const GroundFilterOptions& ground,
                              const LevelRegionOptions& options) {
  const GroundRaster lowest = JoinRasters(rasters);
  if (lowest.empty()) return {};
  const FilteredGround filtered(lowest, ground);
  std::vector<bool> is_ground;
  for (int32_t row = lowest.row; row < lowest.row + lowest.rows; ++row) {
    for (int32_t col = lowest.col; col < lowest.col + lowest.cols; ++col) {
      is_ground.push_back(filtered.IsGround(col, row));
    }
  }
  return FindLevelRegions(lowest, is_ground, options);
}

}  // namespace

std::vector<LowRegion> FindWaterSurfaces(std::span<const GroundRaster> rasters, const GroundFilterOptions& ground,
                                         const LevelRegionOptions& options) {
  std::vector<LowRegion> regions;
  for (const std::vector<GroundRaster>& group : GroupsOf(rasters)) {
    for (LowRegion& region : FindIn(group, ground, options)) regions.push_back(std::move(region));
  }
  std::ranges::stable_sort(regions, std::ranges::greater(), &LowRegion::area);
  return regions;
}

}  // namespace tilemend
