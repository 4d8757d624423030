#include "coordinator/state/cell_board.h"

#include <algorithm>
#include <string_view>

namespace tilemend {
namespace {

bool IsAheadOf(CellProgress a, CellProgress b) {
  constexpr std::string_view kOrder = ".spfFwx";
  return kOrder.find(static_cast<char>(a)) > kOrder.find(static_cast<char>(b));
}

}  // namespace

void CellBoard::RaiseTo(CellId cell, CellProgress progress) {
  CellProgress& known = cells_.try_emplace(cell, CellProgress::kWaiting).first->second;
  if (IsAheadOf(progress, known)) known = progress;
}

void CellBoard::TaskAdded(CellId cell, Stage stage) {
  planned_ |= stage != Stage::kMeasure && stage != Stage::kSurvey && stage != Stage::kGround;
  RaiseTo(cell, stage == Stage::kFill ? CellProgress::kFilling : CellProgress::kWaiting);
}

void CellBoard::TaskSettled(CellId cell, Stage stage, const absl::Status& status) {
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

std::map<CellId, CellProgress> CellBoard::Cells() const {
  std::map<CellId, CellProgress> cells = cells_;
  if (!planned_) return cells;
  for (auto& [cell, progress] : cells) {
    if (progress == CellProgress::kSurveyed) progress = CellProgress::kPlanned;
  }
  return cells;
}

}  // namespace tilemend
