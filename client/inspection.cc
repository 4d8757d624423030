#include "client/inspection.h"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <system_error>
#include <thread>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/util/status_macros.h"
#include "coordinator/report/tile_checks.h"
#include "worker/survey/survey.h"

namespace tilemend {
namespace {

absl::StatusOr<SurveyRecord> SurveyFile(const Scene& scene, const SceneTile& tile) {
  const std::string path = absl::StrCat(scene.root, "/", tile.path);
  TILEMEND_ASSIGN_OR_RETURN(const MeshFile file, ReadMeshFile(path));
  SurveyRecord record = SurveyTile(file.mesh, file.number_type == NumberType::kFloat32);
  TILEMEND_RETURN_IF_ERROR(CheckInsideCell(record, scene.grid, tile, path));
  return record;
}

// The records of all tiles, in order; as many threads as cores.
std::vector<absl::StatusOr<SurveyRecord>> SurveyAll(const Scene& scene) {
  std::vector<absl::StatusOr<SurveyRecord>> results(scene.tiles.size());
  std::atomic<size_t> next{0};
  const auto work = [&] {
    for (size_t i = next++; i < scene.tiles.size(); i = next++) {
      if (!scene.tiles[i].path.empty()) results[i] = SurveyFile(scene, scene.tiles[i]);
    }
  };
  std::vector<std::thread> threads;
  for (unsigned t = 1; t < std::max(1U, std::thread::hardware_concurrency()); ++t) threads.emplace_back(work);
  work();
  for (std::thread& t : threads) t.join();
  return results;
}

}  // namespace

bool IsSingleMesh(const std::string& path) {
  std::error_code error;
  const std::filesystem::path p(path);
  return std::filesystem::is_regular_file(p, error) && p.extension() != ".json";
}

absl::StatusOr<Inspection> InspectScene(const std::string& path, const PlanOptions& options) {
  Inspection inspection;
  TILEMEND_ASSIGN_OR_RETURN(inspection.scene, LoadScene(path, ReadTileBounds));
  const Scene& scene = inspection.scene;
  auto results = SurveyAll(scene);
  PlanInput input;
  input.grid = scene.grid;
  input.area_known = scene.area_known;
  for (size_t i = 0; i < scene.tiles.size(); ++i) {
    const SceneTile& tile = scene.tiles[i];
    input.cells[tile.cell] = nullptr;
    if (tile.path.empty()) continue;
    if (!results[i].ok()) {
      inspection.errors.push_back(results[i].status());
      continue;
    }
    inspection.records[tile.cell] = *std::move(results[i]);
    input.cells[tile.cell] = &inspection.records[tile.cell];
  }
  if (inspection.errors.empty()) inspection.plan = MakePlan(input, options);
  return inspection;
}

void InspectMesh(const MeshFile& file, const PlanOptions& options, MeshInspection& inspection) {
  inspection.record = SurveyTile(file.mesh, file.number_type == NumberType::kFloat32);
  const SurveyRecord& record = inspection.record;
  inspection.input.has_grid = false;
  inspection.input.area_known = false;
  const Point2 extent = (record.hi - record.lo).head<2>().cwiseMax(Point2(1, 1));
  inspection.input.grid.corner = record.lo.head<2>() - extent;
  inspection.input.grid.cell_size = 3 * extent;
  inspection.input.cells[CellId{0, 0}] = &record;
  inspection.plan = MakePlan(inspection.input, options);
}

}  // namespace tilemend
