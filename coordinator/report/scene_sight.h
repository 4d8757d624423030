// What the coordinator's page may see of a scene: its cells, where their tiles lie, and the holes once they are
// planned.
#ifndef TILEMEND_COORDINATOR_REPORT_SCENE_SIGHT_H_
#define TILEMEND_COORDINATOR_REPORT_SCENE_SIGHT_H_

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "common/grid/cell_letters.h"
#include "common/grid/scene.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// Thread-safe. Holds some 20 bytes a cell and the paths.
class SceneSight {
 public:
  static constexpr char kWithTile = '.', kWithoutSurface = '-';

  // Cost: O(tiles).
  explicit SceneSight(const Scene& scene);

  // kWithTile or kWithoutSurface of each cell.
  const CellLetters& cells() const { return cells_; }
  const Point2& cell_size() const { return cell_size_; }  // 0: not known
  // The folder of the tiles before.
  const std::string& root() const { return root_; }

  struct Place {
    std::string path;  // relative to root(), or to the output's folder
    TileFrame frame;
  };
  // The tile of a cell in the scene (`after` false) or in the output. None if it has none.
  std::optional<Place> TileOf(CellId cell, bool after) const;

  // Takes what PlannedHolesJson says of a plan.
  void SetPlan(const Plan& plan, const std::set<CellId>& chosen);
  // Null before there is a plan.
  std::shared_ptr<const std::string> planned_holes() const;

 private:
  struct Tile {
    CellId cell;
    size_t before = 0, after = 0;  // where its paths begin in paths_
  };

  const std::string root_;
  const Point2 cell_size_;
  CellLetters cells_;
  std::vector<Tile> tiles_;  // sorted by cell
  std::string paths_;        // each with a zero at its end
  std::map<CellId, TileFrame> frames_;

  mutable std::mutex mutex_;
  std::shared_ptr<const std::string> planned_holes_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_REPORT_SCENE_SIGHT_H_
