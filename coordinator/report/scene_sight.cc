#include "coordinator/report/scene_sight.h"

#include <algorithm>
#include <utility>

#include "coordinator/report/page_holes.h"
#include "coordinator/report/planned_holes.h"

namespace tilemend {

SceneSight::SceneSight(const Scene& scene) : root_(scene.root), cell_size_(scene.grid.cell_size) {
  tiles_.reserve(scene.tiles.size());
  const auto put = [this](const std::string& path) {
    const size_t at = paths_.size();
    paths_.append(path).push_back('\0');
    return at;
  };
  for (const SceneTile& tile : scene.tiles) {
    cells_.Set(tile.cell, tile.path.empty() ? kWithoutSurface : kWithTile);
    const std::string output = OutputPath(tile);
    const size_t before = put(tile.path);
    tiles_.push_back({tile.cell, before, output == tile.path ? before : put(output)});
    if (!tile.frame.empty()) frames_[tile.cell] = tile.frame;
  }
  std::ranges::sort(tiles_, {}, &Tile::cell);
}

std::optional<SceneSight::Place> SceneSight::TileOf(CellId cell, bool after) const {
  const auto tile = std::ranges::lower_bound(tiles_, cell, {}, &Tile::cell);
  if (tile == tiles_.end() || tile->cell != cell) return std::nullopt;
  Place place{&paths_[after ? tile->after : tile->before], {}};
  if (place.path.empty()) return std::nullopt;
  if (const auto frame = frames_.find(cell); frame != frames_.end()) place.frame = frame->second;
  return place;
}

void SceneSight::SetPlan(const Plan& plan, const std::set<CellId>& chosen) {
  auto holes = std::make_shared<const std::string>(PlannedHolesJson(plan, chosen, kMostListedHoles));
  const std::lock_guard<std::mutex> lock(mutex_);
  planned_holes_ = std::move(holes);
}

std::shared_ptr<const std::string> SceneSight::planned_holes() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return planned_holes_;
}

}  // namespace tilemend
