// What became of the levels of detail of tiles, against what the report of the output says.
#ifndef TILEMEND_CLIENT_COARSER_LEVELS_H_
#define TILEMEND_CLIENT_COARSER_LEVELS_H_

#include <cstdint>
#include <string>
#include <vector>

#include "common/grid/scene.h"
#include "common/records/level_counts.h"
#include "worker/check/tile_change.h"

namespace tilemend {

class CoarserLevels {
 public:
  // `reported`: of all tiles of the output, the coarsest level first.
  explicit CoarserLevels(std::vector<LevelCounts> reported);

  // Takes the levels of one tile, the coarsest first and the finest last. Missing triangles count if `is_cleared`.
  void Add(CellId cell, const std::vector<TileChange>& levels, bool is_cleared);

  struct Fault {
    CellId cell;
    std::string note;
  };
  // The levels that got no triangle in a tile whose finest level got some, where the report says of the level that more
  // triangles were added than it has. A level may get none: its holes may be closed, or stay open with a warning.
  std::vector<Fault> Unfilled() const;
  // The levels that lack more triangles in cleared tiles than the report says.
  std::vector<Fault> Cleared() const;

 private:
  struct Sum {
    int64_t added = 0, missing = 0;
    std::vector<CellId> without;  // cells whose finest level alone got triangles
  };

  const std::vector<LevelCounts> reported_;
  std::vector<Sum> found_;
};

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_COARSER_LEVELS_H_
