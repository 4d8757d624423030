#include "client/inspection.h"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>
#include <variant>

#include "absl/strings/str_cat.h"
#include "common/util/status_macros.h"
#include "coordinator/report/tile_checks.h"
#include "worker/ground/lowest_surface.h"
#include "worker/ground/rim_objects.h"
#include "worker/survey/survey.h"

namespace tilemend {
namespace {

absl::StatusOr<SurveyRecord> SurveyFile(const Scene& scene, const SceneTile& tile) {
  TILEMEND_ASSIGN_OR_RETURN(const MeshFile file, ReadMeshFile(absl::StrCat(scene.root, "/", tile.path)));
  SurveyRecord record = SurveyOf(file);
  const Point2& cell = scene.grid.cell_size;
  record.lowest = LowestSurface(file.mesh, RasterSquareFor(cell.x(), cell.y()));
  TILEMEND_RETURN_IF_ERROR(CheckInsideCell(record, scene, tile));
  return record;
}

// Calls `use` with each number below `count`, on as many threads as there are cores.
void ForEachOnAllCores(size_t count, const std::function<void(size_t)>& use) {
  std::atomic<size_t> next{0};
  const auto work = [&] {
    for (size_t i = next++; i < count; i = next++) use(i);
  };
  std::vector<std::thread> threads;
  for (unsigned t = 1; t < std::max(1U, std::thread::hardware_concurrency()); ++t) threads.emplace_back(work);
  work();
  for (std::thread& t : threads) t.join();
}

// The records of the tiles, in order.
std::vector<absl::StatusOr<SurveyRecord>> SurveyAll(const Scene& scene, const std::vector<const SceneTile*>& tiles) {
  std::vector<absl::StatusOr<SurveyRecord>> results(tiles.size());
  ForEachOnAllCores(tiles.size(), [&](size_t i) { results[i] = SurveyFile(scene, *tiles[i]); });
  return results;
}

// Tells ground from objects in all cells, and plans; as many threads as cores.
void TellGround(SceneWaves& waves) {
  std::vector<GroundWork> works;
  while (std::optional<SceneWork> work = waves.Next()) works.push_back(std::get<GroundWork>(*std::move(work)));
  std::vector<RimGround> ground(works.size());
  ForEachOnAllCores(works.size(), [&](size_t i) {
    std::vector<Point3> vertices;
    for (const BoundaryVertex& v : works[i].record.Outline()->vertices) vertices.push_back(v.position);
    std::vector<GroundRaster> rasters;
    for (const CellId cell : works[i].around) rasters.push_back(waves.records().at(cell).Outline()->lowest);
    ground[i] = GroundAtRim(vertices, rasters);
  });
  for (size_t i = 0; i < works.size(); ++i) {
    // As many values as the vertices: nothing is wrong with them.
    waves.TakeGround(works[i].cell, std::move(ground[i])).IgnoreError();
  }
  waves.Next();
}

}  // namespace

Inspection InspectScene(Scene scene, const PlanOptions& options) {
  WaveOptions wave_options;
  wave_options.plan = options;
  wave_options.plan_only = true;
  Inspection inspection;
  inspection.waves = std::make_unique<SceneWaves>(std::move(scene), std::move(wave_options));
  SceneWaves& waves = *inspection.waves;
  std::vector<const SceneTile*> tiles;
  while (const std::optional<SceneWork> work = waves.Next()) tiles.push_back(std::get<SurveyWork>(*work).tile);
  auto results = SurveyAll(waves.scene(), tiles);
  for (size_t i = 0; i < tiles.size(); ++i) {
    if (results[i].ok()) {
      waves.TakeSurvey(tiles[i]->cell, *std::move(results[i]));
    } else {
      inspection.errors.push_back(results[i].status());
    }
  }
  if (inspection.errors.empty()) TellGround(waves);
  return inspection;
}

bool IsSingleMesh(const std::string& path) {
  std::error_code error;
  const std::filesystem::path p(path);
  return std::filesystem::is_regular_file(p, error) && p.extension() != ".json";
}

Scene SceneOfMesh(const std::string& path) {
  Scene scene;
  scene.cols = scene.rows = 1;
  scene.tiles = {{{0, 0}, path}};
  return scene;
}

SurveyRecord SurveyOf(const MeshFile& file) { return SurveyTile(file.mesh, file.number_type == NumberType::kFloat32); }

}  // namespace tilemend
