#include "coordinator/web/cell_map.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "absl/strings/str_cat.h"
#include "common/util/error_info.h"
#include "common/util/stage.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

constexpr char kNoCell = CellLetters::kNone;
constexpr char kUnknownCell = '?';  // the job is over, and what became of the cell is not known

// The rectangle around cells.
struct Frame {
  int64_t c0 = std::numeric_limits<int32_t>::max(), c1 = std::numeric_limits<int32_t>::min();
  int64_t r0 = c0, r1 = c1;

  void Add(CellId cell) {
    c0 = std::min<int64_t>(c0, cell.col);
    c1 = std::max<int64_t>(c1, cell.col);
    r0 = std::min<int64_t>(r0, cell.row);
    r1 = std::max<int64_t>(r1, cell.row);
  }
  bool empty() const { return c1 < c0; }
  int64_t columns() const { return empty() ? 0 : c1 - c0 + 1; }
  int64_t rows() const { return empty() ? 0 : r1 - r0 + 1; }
  size_t IndexOf(CellId cell) const { return static_cast<size_t>((cell.row - r0) * columns() + cell.col - c0); }
};

Frame FrameOf(const JobCells& job, const SceneSight* sight) {
  Frame frame;
  const auto add = [&](CellId cell, char) { frame.Add(cell); };
  job.cells.ForEach(add);
  if (sight != nullptr) sight->cells().ForEach(add);
  return frame;
}

// After a restart the cells of a job that was over are not known. No task of one that is done failed for good.
bool IsRemembered(const JobCells& job) {
  return !IsOver(job.state) || job.state == JobState::kDone || !job.cells.empty();
}

// The letter of a cell that has no task.
char WithoutTask(const JobCells& job) {
  if (!IsOver(job.state)) return static_cast<char>(CellProgress::kWaiting);
  if (job.state == JobState::kDone || job.state == JobState::kPartial) return static_cast<char>(CellProgress::kWritten);
  return IsRemembered(job) ? static_cast<char>(CellProgress::kWaiting) : kUnknownCell;
}

std::string LettersOf(const JobCells& job, const SceneSight* sight, const Frame& frame) {
  std::string letters(static_cast<size_t>(frame.columns() * frame.rows()), kNoCell);
  const char without_task = WithoutTask(job);
  if (sight != nullptr) {
    sight->cells().ForEach([&](CellId cell, char letter) {
      letters[frame.IndexOf(cell)] = letter == SceneSight::kWithoutSurface ? letter : without_task;
    });
  }
  job.cells.ForEach([&](CellId cell, char letter) { letters[frame.IndexOf(cell)] = letter; });
  return letters;
}

Json FailuresOf(const JobCells& job) {
  Json rows = Json::array();
  for (const CellFailure& failure : job.failures) {
    rows.push_back({{"cell", {failure.cell.col, failure.cell.row}},
                    {"stage", StageName(failure.stage)},
                    {"reason", failure.reason}});
  }
  return rows;
}

}  // namespace

absl::StatusOr<std::string> CellMapJson(const JobCells& job, const SceneSight* sight) {
  const Frame frame = FrameOf(job, sight);
  if (frame.columns() * frame.rows() > kMostMapSquares) {
    return WithErrorInfo(absl::ResourceExhaustedError(
                             absl::StrCat("a map of ", frame.columns(), " x ", frame.rows(), " cells is too large")),
                         {"TOO_LARGE", {{"limit", absl::StrCat(kMostMapSquares)}}});
  }
  Json map = {{"state", JobStateName(job.state)},
              {"column", frame.empty() ? 0 : frame.c0},
              {"row", frame.empty() ? 0 : frame.r0},
              {"columns", frame.columns()},
              {"rows", frame.rows()}};
  if (sight != nullptr && sight->cell_size().x() > 0)
    map["cellSize"] = {sight->cell_size().x(), sight->cell_size().y()};
  map["hasTiles"] = sight != nullptr;
  map["isRemembered"] = IsRemembered(job);
  map["cells"] = LettersOf(job, sight, frame);
  map["held"] = Json::array();
  for (const CellId cell : job.held) map["held"].push_back({cell.col, cell.row});
  map["failures"] = FailuresOf(job);
  return map.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace tilemend
