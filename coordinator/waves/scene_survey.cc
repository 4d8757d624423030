#include "coordinator/waves/scene_survey.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "coordinator/waves/ground_reach.h"

namespace tilemend {
namespace {

// A cell that a mesh lies in the middle of.
Grid GridAround(const SurveySummary& record) {
  const Point2 extent = (record.hi - record.lo).head<2>().cwiseMax(Point2(1, 1));
  return {record.lo.head<2>() - extent, 3 * extent};
}

std::vector<CellId> CellsOf(const Scene& scene) {
  std::vector<CellId> cells;
  for (const SceneTile& tile : scene.tiles) cells.push_back(tile.cell);
  return cells;
}

}  // namespace

SceneSurvey::SceneSurvey(Scene scene, const std::vector<WaterArea>& areas)
    : scene_(std::move(scene)), areas_(areas), clearing_(areas_, scene_.grid, CellsOf(scene_), scene_.area) {
  for (const SceneTile& tile : scene_.tiles) tiles_[tile.cell] = &tile;
}

std::vector<CellId> SceneSurvey::ToMeasure() const {
  std::vector<CellId> cells = ToSurvey();
  std::erase_if(cells, [&](CellId cell) { return !clearing_.IsMeasured(cell); });
  return cells;
}

std::vector<CellId> SceneSurvey::ToSurvey() const {
  std::vector<CellId> cells;
  for (const SceneTile& tile : scene_.tiles) {
    if (!tile.path.empty()) cells.push_back(tile.cell);
  }
  return cells;
}

std::vector<CellId> SceneSurvey::ToTellGround(const WaveOptions& options) const {
  std::vector<CellId> cells;
  if (!options.find_objects || options.single_mesh || !IsGroundTold(scene_.grid)) return cells;
  for (const auto& [cell, record] : records()) {
    if (record != nullptr && record->triangle_count > 0) cells.push_back(cell);
  }
  return cells;
}

absl::Status SceneSurvey::Take(TileSurvey result) {
  if (absl::Status status = clearing_.TakeCounts(result.cell, result.cleared); !status.ok()) return status;
  input_.cells[result.cell] = std::move(result.record);
  return absl::OkStatus();
}

absl::Status SceneSurvey::Take(CellGround result) {
  const auto record = records().find(result.cell);
  if (record == records().end() || record->second == nullptr) {
    return absl::InvalidArgumentError(absl::StrCat("cell ", ToString(result.cell), " has no tile"));
  }
  const size_t vertices = record->second.Outline()->vertices.size();
  if (result.rim.on_object.size() != vertices || result.rim.ground.size() != vertices) {
    return absl::InvalidArgumentError("not a value for each boundary vertex");
  }
  input_.rim_ground[result.cell] = std::move(result.rim);
  return absl::OkStatus();
}

PlanOptions SceneSurvey::Complete(const WaveOptions& options) {
  input_.has_grid = !options.single_mesh;
  input_.area_known = scene_.area_known;
  input_.area = scene_.area;
  input_.grid = options.single_mesh ? GridAround(*records().begin()->second) : scene_.grid;
  for (const auto& [cell, tile] : tiles_) {
    input_.cells.try_emplace(cell);
    if (tile->added) input_.added.insert(cell);
  }
  PlanOptions plan = options.plan;
  plan.water.areas = areas_;
  clearing_.TellCells(plan.water.areas);
  return plan;
}

}  // namespace tilemend
