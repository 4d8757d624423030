// How far each cell of a job is: one letter a cell, for maps.
#ifndef TILEMEND_COORDINATOR_STATE_CELL_BOARD_H_
#define TILEMEND_COORDINATOR_STATE_CELL_BOARD_H_

#include <cstdint>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "common/grid/cell_letters.h"
#include "common/grid/scene.h"
#include "common/util/stage.h"

namespace tilemend {

// In the order in which a cell goes through them. kFailed is final.
enum class CellProgress : char {
  kWaiting = '.',   // nothing of it is known
  kSurveyed = 's',  // its holes are known
  kPlanned = 'p',   // the plan is made; it waits to be filled or written
  kFilling = 'f',   // its fill is given out
  kFilled = 'F',    // it is filled and waits to be written
  kWritten = 'w',   // its tile is written
  kFailed = 'x',    // a task of it failed for good
};

// Why a task of a cell failed.
struct CellFailure {
  CellId cell;
  Stage stage = Stage::kSurvey;
  std::string reason;
};

// Beyond these failures are marked on the map alone.
inline constexpr size_t kMostCellFailures = 200;

// Holds a letter for each cell that had a task. Pure; grows with what it is told.
class CellBoard {
 public:
  // A task of the cell is to be done.
  void TaskAdded(CellId cell, Stage stage);
  // It was done, or failed for good.
  void TaskSettled(CellId cell, Stage stage, const absl::Status& status);

  // The CellProgress of each; kPlanned in place of kSurveyed once anything was added that follows the plan.
  CellLetters Cells() const;
  const std::vector<CellFailure>& failures() const { return failures_; }

 private:
  void RaiseTo(CellId cell, CellProgress progress);

  CellLetters cells_;
  std::vector<CellFailure> failures_;
  bool planned_ = false;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_STATE_CELL_BOARD_H_
