// The map of a job's cells as JSON, one letter a cell.
#ifndef TILEMEND_COORDINATOR_WEB_CELL_MAP_H_
#define TILEMEND_COORDINATOR_WEB_CELL_MAP_H_

#include <string>

#include "absl/status/statusor.h"
#include "coordinator/api/jobs_handler.h"
#include "coordinator/report/scene_sight.h"

namespace tilemend {

// Squares of the rectangle around all cells: kResourceExhausted (TOO_LARGE) beyond.
inline constexpr int64_t kMostMapSquares = 4'000'000;

// The schema Cells of /v1/openapi.json. Without `sight` the map has the cells that had a task. Of a job that was over
// before this process of the coordinator began, nothing is remembered: all cells count as written if it was done or
// partial, else as not known. Of a job that is done, no task failed for good.
// Cost: O(squares).
absl::StatusOr<std::string> CellMapJson(const JobCells& job, const SceneSight* sight);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_WEB_CELL_MAP_H_
