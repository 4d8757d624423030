#include "coordinator/state/cell_board.h"

#include <string_view>

#include "coordinator/state/job.h"

namespace tilemend {
namespace {

// How far a letter is; that of no cell is before all.
size_t StepOf(char letter) { return std::string_view(" .spfFwx").find(letter); }

}  // namespace

void CellBoard::RaiseTo(CellId cell, CellProgress progress) {
  char& known = cells_.Reference(cell);
  if (StepOf(static_cast<char>(progress)) > StepOf(known)) known = static_cast<char>(progress);
}

void CellBoard::TaskAdded(CellId cell, Stage stage) {
  if (IsBackground(stage)) return;  // of files of several cells
  planned_ |= stage != Stage::kMeasure && stage != Stage::kSurvey && stage != Stage::kGround;
  RaiseTo(cell, stage == Stage::kFill ? CellProgress::kFilling : CellProgress::kWaiting);
}

void CellBoard::TaskSettled(CellId cell, Stage stage, const absl::Status& status) {
  if (IsBackground(stage)) return;
  if (!status.ok()) {
    RaiseTo(cell, CellProgress::kFailed);
    if (failures_.size() < kMostCellFailures) failures_.push_back({cell, stage, std::string(status.message())});
    return;
  }
  switch (stage) {
    case Stage::kSurvey:
      return RaiseTo(cell, CellProgress::kSurveyed);
    case Stage::kFill:
      return RaiseTo(cell, CellProgress::kFilled);
    case Stage::kAssemble:
      return RaiseTo(cell, CellProgress::kWritten);
    default:
      return RaiseTo(cell, CellProgress::kWaiting);
  }
}

CellLetters CellBoard::Cells() const {
  CellLetters cells = cells_;
  if (planned_) cells.Replace(static_cast<char>(CellProgress::kSurveyed), static_cast<char>(CellProgress::kPlanned));
  return cells;
}

}  // namespace tilemend
