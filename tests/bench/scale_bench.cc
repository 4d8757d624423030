// What the coordinator keeps in memory of a cell: plans a made scene and gives out all of its work, to workers that
// answer at once.
//
//   scale_bench [--side 1000] [--border 4] [--holes 0.01]
//
// The scene has SIDE x SIDE cells, BORDER edges along each side of a tile, and a closed hole of 12 edges in a share
// HOLES of the cells. Survey records lie on disk, as in a job. Prints bytes for each cell: allocated after the surveys,
// after the plan and at the end, and the most of the process, without what the scene itself takes.
#include <malloc.h>  // of glibc
#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "absl/status/status.h"
#include "absl/strings/numbers.h"
#include "common/util/heap.h"
#include "common/util/status_macros.h"
#include "common/util/stopwatch.h"
#include "coordinator/store/scratch_file.h"
#include "coordinator/waves/scene_waves.h"

namespace tilemend {
namespace {

constexpr double kCell = 250;  // metres
constexpr int kHoleEdges = 12;

struct Command {
  int side = 1000;
  int border = 4;
  double holes = 0.01;
};

int64_t Allocated() {
  const auto heap = mallinfo2();
  return static_cast<int64_t>(heap.uordblks + heap.hblkhd);
}

int64_t MostResident() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return int64_t{1024} * usage.ru_maxrss;
}

void AddVertex(const Point3& position, SurveyRecord& record) {
  record.vertices.push_back({static_cast<int32_t>(record.vertices.size()), position, {0, 0, 1}, 0});
}

// A loop through the vertices from `first` on.
void CloseLoop(size_t first, SurveyRecord& record) {
  const size_t count = record.vertices.size() - first;
  for (size_t i = 0; i < count; ++i) {
    record.edges.push_back({static_cast<int32_t>(first + i), static_cast<int32_t>(first + (i + 1) % count), 0});
  }
}

Point3 OnRing(const Point2& centre, double radius, int i) {
  const double angle = -2 * std::numbers::pi * i / kHoleEdges;
  return {centre.x() + radius * std::cos(angle), centre.y() + radius * std::sin(angle), 0};
}

// The square of the cell, with a hole and two rings of triangles around it if so asked.
SurveyRecord RecordOf(CellId cell, int border, bool with_hole) {
  SurveyRecord record;
  const auto at = [&](int col_step, int row_step) {
    return Point3(kCell * (cell.col * border + col_step) / border, kCell * (cell.row * border + row_step) / border, 0);
  };
  for (int i = 0; i < border; ++i) AddVertex(at(i, 0), record);
  for (int i = 0; i < border; ++i) AddVertex(at(border, i), record);
  for (int i = 0; i < border; ++i) AddVertex(at(border - i, border), record);
  for (int i = 0; i < border; ++i) AddVertex(at(0, border - i), record);
  CloseLoop(0, record);
  record.lo = at(0, 0);
  record.hi = at(border, border);
  const auto first = static_cast<int32_t>(record.vertices.size());
  const Point2 centre = (record.lo + record.hi).head<2>() / 2;
  for (int i = 0; with_hole && i < kHoleEdges; ++i) AddVertex(OnRing(centre, 5, i), record);
  if (with_hole) CloseLoop(static_cast<size_t>(first), record);
  for (const BoundaryVertex& v : record.vertices) record.band.points.push_back(v.position);
  const auto outer = static_cast<int32_t>(record.band.points.size());
  for (int i = 0; with_hole && i < kHoleEdges; ++i) {
    const int32_t next = (i + 1) % kHoleEdges;
    record.band.points.push_back(OnRing(centre, 8, i));
    record.band.triangles.push_back({first + i, first + next, outer + i});
    record.band.triangles.push_back({first + next, outer + next, outer + i});
  }
  record.vertex_count = record.triangle_count = 100'000;
  record.piece_areas = {kCell * kCell};
  return record;
}

Scene SceneOf(int side) {
  Scene scene;
  scene.grid = {{0, 0}, {kCell, kCell}};
  scene.cols = scene.rows = side;
  scene.area_known = true;
  for (int32_t row = 0; row < side; ++row) {
    for (int32_t col = 0; col < side; ++col)
      scene.tiles.push_back({{col, row}, "tiles/" + ToString({col, row}) + ".ply"});
  }
  return scene;
}

class Workers {
 public:
  Workers(const Command& command, SceneWaves& waves, ScratchFile& scratch)
      : command_(command), waves_(waves), scratch_(scratch) {}

  absl::Status Do(const SceneWork& work) {
    return std::visit([this](const auto& w) { return Answer(w); }, work);
  }

 private:
  absl::Status Answer(const MeasureWork&) { return absl::InternalError("nothing is taken out here"); }
  absl::Status Answer(const SurveyWork& work) {
    const int64_t number = int64_t{work.tile->cell.row} * command_.side + work.tile->cell.col;
    const bool with_hole = std::floor(command_.holes * static_cast<double>(number + 1)) >
                           std::floor(command_.holes * static_cast<double>(number));
    TILEMEND_ASSIGN_OR_RETURN(StoredRecord record,
                              scratch_.Keep(RecordOf(work.tile->cell, command_.border, with_hole)));
    return waves_.Take(TileSurvey{work.tile->cell, std::move(record)});
  }
  absl::Status Answer(const FillWork& work) {
    CellPatches patches;
    for (const CellHole& hole : work.holes.holes) {
      PatchExtent& patch = patches.patches.emplace_back();
      patch.hole = hole.id;
      patch.triangles = kHoleEdges;
    }
    return waves_.Take(CellFill{work.holes.cell, std::move(patches)});
  }
  absl::Status Answer(const AssembleWork&) { return waves_.Take(TileWritten{}); }
  template <class Other>
  absl::Status Answer(const Other&) {
    return absl::InternalError("the scene has closed holes only");
  }

  const Command& command_;
  SceneWaves& waves_;
  ScratchFile& scratch_;
};

absl::Status Measure(const Command& command) {
  ShareHeap();
  Stopwatch watch;
  Scene scene = SceneOf(command.side);
  const int64_t before = Allocated();
  const auto cells = static_cast<double>(scene.tiles.size());
  const auto print = [&](std::string_view step) {
    std::printf("%-10.*s %6.0f bytes a cell, at most %6.0f, %6.1f s\n", static_cast<int>(step.size()), step.data(),
                static_cast<double>(Allocated() - before) / cells, static_cast<double>(MostResident() - before) / cells,
                watch.Lap());
    std::fflush(stdout);
  };
  TILEMEND_ASSIGN_OR_RETURN(const auto scratch, ScratchFile::Create(""));
  WaveOptions options;
  options.find_objects = false;  // there are none, and no rasters to tell them by
  SceneWaves waves(std::move(scene), options, print);
  Workers workers(command, waves, *scratch);
  while (const std::optional<SceneWork> work = waves.Next()) TILEMEND_RETURN_IF_ERROR(workers.Do(*work));
  std::printf("%zu holes, %zu filled\n", waves.plan().holes.size(), waves.outcome().sizes.size());
  return absl::OkStatus();
}

}  // namespace
}  // namespace tilemend

int main(int argc, char** argv) {
  tilemend::Command command;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string flag = argv[i];
    const bool good = (flag == "--side" && absl::SimpleAtoi(argv[i + 1], &command.side)) ||
                      (flag == "--border" && absl::SimpleAtoi(argv[i + 1], &command.border)) ||
                      (flag == "--holes" && absl::SimpleAtod(argv[i + 1], &command.holes));
    if (good) continue;
    std::fprintf(stderr, "%s: no such option, or no number\n", argv[i]);
    return 2;
  }
  const absl::Status status = tilemend::Measure(command);
  if (!status.ok()) std::fprintf(stderr, "%s\n", std::string(status.message()).c_str());
  return status.ok() ? 0 : 1;
}
