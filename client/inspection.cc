#include "client/inspection.h"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <functional>
#include <iterator>
#include <mutex>
#include <optional>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>
#include <variant>

#include "absl/strings/str_cat.h"
#include "common/assemble/clear_tile.h"
#include "common/mesh/height_tallies.h"
#include "common/util/heap.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"
#include "common/util/tile_files.h"
#include "coordinator/report/plan_warnings.h"
#include "coordinator/report/tile_checks.h"
#include "coordinator/report/water_choice.h"
#include "worker/ground/lowest_surface.h"
#include "worker/ground/rim_objects.h"
#include "worker/materials/survey_look.h"
#include "worker/survey/survey.h"

namespace tilemend {
namespace {

constexpr size_t kMostFileWarnings = 20;  // as the report of a job has them

// What comes of a piece of work on one tile.
struct Looked {
  std::vector<HeightTally> tallies;  // of MeasureWork
  SurveyRecord record;               // of SurveyWork, as the others
  std::vector<int64_t> cleared;
  std::vector<std::string> warnings;
};

// The tile's file; of a single mesh the scene has no folder.
std::string PathOf(const Scene& scene, const SceneTile& tile) {
  return scene.root.empty() ? tile.path : absl::StrCat(scene.root, "/", tile.path);
}

absl::StatusOr<Looked> Look(const Scene& scene, const MeasureWork& work) {
  TILEMEND_ASSIGN_OR_RETURN(const MeshFile file, ReadMeshFile(PathOf(scene, *work.tile), work.tile->frame));
  Looked looked;
  looked.tallies = TallyHeightsIn(file.mesh, work.polygons);
  return looked;
}

// The record of the mesh that a tile has. A single mesh has no grid, and no raster of its ground.
absl::StatusOr<SurveyRecord> RecordOf(const MeshFile& file, const Scene& scene, const SceneTile& tile) {
  const Point2& cell = scene.grid.cell_size;
  if (cell.minCoeff() <= 0) return SurveyOf(file);
  SurveyRecord record = SurveyTile(file.mesh, file.number_type == NumberType::kFloat32, PieceAreas::kNo);
  record.lowest = LowestSurface(file.mesh, RasterSquareFor(cell.x(), cell.y()));
  TILEMEND_RETURN_IF_ERROR(CheckInsideCell(record, scene, tile));
  return record;
}

absl::StatusOr<Looked> Look(const Scene& scene, const SurveyWork& work) {
  const std::string path = PathOf(scene, *work.tile);
  TILEMEND_ASSIGN_OR_RETURN(const MeshFormat format, MeshFormatOf(path));
  TILEMEND_ASSIGN_OR_RETURN(std::string bytes, ReadTileBytes(path, work.tile->frame));
  Looked looked;
  if (!work.clear.empty()) {
    TILEMEND_ASSIGN_OR_RETURN(ClearedTile cleared, ClearTile(format, bytes, work.clear, path));
    looked.cleared = std::move(cleared.triangles);
    bytes = std::move(cleared.bytes);
  }
  const NoFaces no_faces = work.clear.empty() ? NoFaces::kRefuse : NoFaces::kAccept;
  MeshWithWarnings mesh;
  if (scene.root.empty()) {  // a single mesh: nothing looks at its materials
    TILEMEND_ASSIGN_OR_RETURN(mesh.file, ParseMesh(format, bytes, path, no_faces));
  } else {
    TILEMEND_ASSIGN_OR_RETURN(mesh, ParseWithWarnings(scene.root, work.tile->path, bytes, format, no_faces));
  }
  looked.warnings = std::move(mesh.warnings);
  TILEMEND_ASSIGN_OR_RETURN(looked.record, RecordOf(mesh.file, scene, *work.tile));
  return looked;
}

unsigned Cores() { return std::max(1U, std::thread::hardware_concurrency()); }

// Calls `use` with each number below `count`, one for each tile, on as many threads as there are cores.
void ForEachOnAllCores(std::string_view step, size_t count, const StepWatcher& watcher,
                       const std::function<void(size_t)>& use) {
  std::atomic<size_t> next{0};
  std::mutex mutex;
  size_t done = 0;
  if (watcher && count > 0) watcher(step, 0, count, "tile");
  const auto work = [&] {
    for (size_t i = next++; i < count; i = next++) {
      use(i);
      const std::lock_guard lock(mutex);
      if (watcher) watcher(step, ++done, count, "tile");
    }
  };
  std::vector<std::thread> threads;
  for (unsigned t = 1; t < Cores(); ++t) threads.emplace_back(work);
  work();
  for (std::thread& t : threads) t.join();
}

// What comes of the work, in order.
template <typename Work>
std::vector<absl::StatusOr<Looked>> LookAtAll(std::string_view step, const Scene& scene, const std::vector<Work>& tiles,
                                              const StepWatcher& watcher) {
  std::vector<absl::StatusOr<Looked>> results(tiles.size());
  ForEachOnAllCores(step, tiles.size(), watcher, [&](size_t i) { results[i] = Look(scene, tiles[i]); });
  return results;
}

// All that the waves give out now, which is all of one kind.
template <typename Work>
std::vector<Work> AllWork(SceneWaves& waves, std::optional<SceneWork>& next) {
  std::vector<Work> all;
  for (; next && std::holds_alternative<Work>(*next); next = waves.Next()) all.push_back(std::get<Work>(*next));
  return all;
}

absl::Status Take(CellId cell, Looked looked, SceneWaves& waves) {
  if (!looked.tallies.empty()) return waves.Take(TileLevels{cell, std::move(looked.tallies)});
  return waves.Take(SurveyInMemory(cell, std::move(looked.record), std::move(looked.cleared)));
}

template <typename Work>
void DoAll(std::string_view step, const std::vector<Work>& tiles, const StepWatcher& watcher, Inspection& inspection) {
  auto results = LookAtAll(step, inspection.waves->scene(), tiles, watcher);
  for (size_t i = 0; i < tiles.size(); ++i) {
    absl::Status status = results[i].status();
    if (status.ok()) std::ranges::move(results[i]->warnings, std::back_inserter(inspection.warnings));
    if (status.ok()) status = Take(tiles[i].tile->cell, *std::move(results[i]), *inspection.waves);
    if (!status.ok()) inspection.errors.push_back(status);
  }
  KeepFirst(kMostFileWarnings, "warnings on material files, images and levels of detail", inspection.warnings);
}

// Tells ground from objects in all cells, and plans; as many threads as cores.
void TellGround(const StepWatcher& watcher, SceneWaves& waves) {
  std::vector<GroundWork> works;
  while (std::optional<SceneWork> work = waves.Next()) works.push_back(std::get<GroundWork>(*std::move(work)));
  std::vector<RimGround> ground(works.size());
  ForEachOnAllCores("tell ground from objects", works.size(), watcher, [&](size_t i) {
    std::vector<Point3> vertices;
    for (const BoundaryVertex& v : works[i].record.Outline()->vertices) vertices.push_back(v.position);
    std::vector<GroundRaster> rasters;
    for (const CellId cell : works[i].around) rasters.push_back(waves.survey().records().at(cell).Outline()->lowest);
    ground[i] = GroundAtRim(vertices, rasters);
  });
  for (size_t i = 0; i < works.size(); ++i) {
    // As many values as the vertices: nothing is wrong with them.
    waves.Take(CellGround{works[i].cell, std::move(ground[i])}).IgnoreError();
  }
  waves.Next();
}

}  // namespace

Inspection InspectScene(Scene scene, const PlanOptions& options, const StepWatcher& watcher) {
  KeepHeap(static_cast<int>(Cores()));
  WaveOptions wave_options;
  wave_options.plan = options;
  wave_options.single_mesh = scene.grid.cell_size.minCoeff() <= 0;
  wave_options.plan_only = true;
  Inspection inspection;
  inspection.waves = std::make_unique<SceneWaves>(std::move(scene), std::move(wave_options));
  SceneWaves& waves = *inspection.waves;
  std::optional<SceneWork> next = waves.Next();
  DoAll("measure the heights in the polygons", AllWork<MeasureWork>(waves, next), watcher, inspection);
  if (!inspection.errors.empty()) return inspection;
  if (!next) next = waves.Next();
  DoAll("look at the tiles", AllWork<SurveyWork>(waves, next), watcher, inspection);
  if (inspection.errors.empty()) {
    absl::Status levels = CheckLevels(options.water.areas, waves.survey().records());
    if (!levels.ok()) inspection.errors.push_back(std::move(levels));
  }
  if (inspection.errors.empty()) TellGround(watcher, waves);
  if (inspection.errors.empty()) {
    absl::Status areas = CheckAreas(waves.plan());
    if (!areas.ok()) inspection.errors.push_back(std::move(areas));
  }
  return inspection;
}

bool IsSingleMesh(const std::string& path) {
  std::error_code error;
  const std::filesystem::path p(path);
  return std::filesystem::is_regular_file(p, error) && p.extension() != ".json";
}

SurveyRecord SurveyOf(const MeshFile& file) { return SurveyTile(file.mesh, file.number_type == NumberType::kFloat32); }

}  // namespace tilemend
