#include "client/inspection.h"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>
#include <variant>

#include "absl/strings/str_cat.h"
#include "common/util/status_macros.h"
#include "coordinator/report/tile_checks.h"
#include "worker/survey/survey.h"

namespace tilemend {
namespace {

absl::StatusOr<SurveyRecord> SurveyFile(const Scene& scene, const SceneTile& tile) {
  TILEMEND_ASSIGN_OR_RETURN(const MeshFile file, ReadMeshFile(absl::StrCat(scene.root, "/", tile.path)));
  SurveyRecord record = SurveyOf(file);
  TILEMEND_RETURN_IF_ERROR(CheckInsideCell(record, scene, tile));
  return record;
}

// The records of the tiles, in order; as many threads as cores.
std::vector<absl::StatusOr<SurveyRecord>> SurveyAll(const Scene& scene, const std::vector<const SceneTile*>& tiles) {
  std::vector<absl::StatusOr<SurveyRecord>> results(tiles.size());
  std::atomic<size_t> next{0};
  const auto work = [&] {
    for (size_t i = next++; i < tiles.size(); i = next++) results[i] = SurveyFile(scene, *tiles[i]);
  };
  std::vector<std::thread> threads;
  for (unsigned t = 1; t < std::max(1U, std::thread::hardware_concurrency()); ++t) threads.emplace_back(work);
  work();
  for (std::thread& t : threads) t.join();
  return results;
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
  waves.Next();  // plans, unless a survey is missing
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
