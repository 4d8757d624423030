// The value of --cells: some cells of a scene.
#ifndef TILEMEND_COMMON_GRID_CELL_CHOICE_H_
#define TILEMEND_COMMON_GRID_CELL_CHOICE_H_

#include <set>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/grid/scene.h"

namespace tilemend {

// All cells from `low` to `high`, both included.
struct CellRange {
  CellId low, high;
  bool operator==(const CellRange&) const = default;
};

// Cells "3,4" (column, row) and ranges "0,0-5,9" from corner to corner, parted by blanks; numbers may be negative.
// kInvalidArgument naming what is neither.
absl::StatusOr<std::vector<CellRange>> ParseCells(const std::string& text);

// The scene's cells in the ranges of `text`; none for "". kInvalidArgument naming a range without any.
absl::StatusOr<std::set<CellId>> ChooseCells(const std::string& text, const Scene& scene);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_GRID_CELL_CHOICE_H_
