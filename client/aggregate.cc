#include "client/aggregate.h"

#include <sys/resource.h>

#include <array>
#include <new>
#include <unordered_map>

#include "absl/strings/str_cat.h"
#include "common/codec/mesh_file.h"
#include "common/util/files.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

struct PositionHash {
  size_t operator()(const std::array<double, 3>& p) const {
    size_t hash = 0;
    for (const double x : p) hash = hash * 0x9e3779b97f4a7c15 + std::hash<double>()(x);
    return hash;
  }
};

// What has been done when memory runs out.
struct Progress {
  const char* step = "joining";
  size_t tiles = 0, all = 0;
  size_t triangles = 0;
};

absl::Status LimitMemory(int64_t bytes) {
  if (bytes <= 0) return absl::OkStatus();
  const rlimit limit{static_cast<rlim_t>(bytes), static_cast<rlim_t>(bytes)};
  if (setrlimit(RLIMIT_AS, &limit) == 0) return absl::OkStatus();
  return absl::InvalidArgumentError("--memory: more than the process may take");
}

absl::StatusOr<FilePatch> Join(const Scene& scene, const StepWatcher& watcher, Progress& progress) {
  FilePatch joined;
  std::unordered_map<std::array<double, 3>, int32_t, PositionHash> number;
  for (const SceneTile& tile : scene.tiles) progress.all += tile.path.empty() ? 0 : 1;
  for (const SceneTile& tile : scene.tiles) {
    if (tile.path.empty()) continue;
    watcher("join the tiles", progress.tiles, progress.all, "tile");
    TILEMEND_ASSIGN_OR_RETURN(const MeshFile file, ReadMeshFile(absl::StrCat(scene.root, "/", tile.path), tile.frame));
    std::vector<int32_t> of_point;
    for (const Point3& p : file.mesh.points) {
      const auto [it, is_new] =
          number.try_emplace({p.x(), p.y(), p.z()}, static_cast<int32_t>(joined.new_points.size()));
      if (is_new) joined.new_points.push_back(p);
      of_point.push_back(it->second);
    }
    for (const Triangle& t : file.mesh.triangles) {
      joined.triangles.push_back({of_point[t[0]], of_point[t[1]], of_point[t[2]]});
    }
    ++progress.tiles;
    progress.triangles = joined.triangles.size();
  }
  joined.like.assign(joined.new_points.size(), -1);
  return joined;
}

absl::StatusOr<FilledMesh> JoinAndFill(const Scene& scene, const AggregateOptions& options, Progress& progress) {
  {
    TILEMEND_ASSIGN_OR_RETURN(const FilePatch joined, Join(scene, options.watcher, progress));
    progress.step = "writing the joined mesh";
    options.watcher("write the joined mesh", 0, 0, "tile");
    TILEMEND_RETURN_IF_ERROR(
        WriteFileAtomically(options.joined, NewPlyFile(joined, NumberType::kFloat64, FaceMark::kNone)));
  }
  progress.step = "filling";
  MeshFillOptions fill;
  fill.fill.filler = Filler::kMinimumArea;
  fill.fill.surface = Surface::kWang;
  fill.fill.wang.longest_loop = options.longest_loop;
  fill.show = [&options](std::string_view step, size_t done, size_t all) { options.watcher(step, done, all, "hole"); };
  return FillMesh(options.joined, fill);
}

}  // namespace

absl::StatusOr<FilledMesh> AggregateAndFill(const Scene& scene, const AggregateOptions& options) {
  TILEMEND_RETURN_IF_ERROR(LimitMemory(options.memory_bytes));
  Progress progress;
  try {
    return JoinAndFill(scene, options, progress);
  } catch (const std::bad_alloc&) {
    return absl::ResourceExhaustedError(absl::StrCat(
        options.memory_bytes > 0 ? "out of the memory that --memory allows, " : "out of memory, ", progress.step, ": ",
        progress.tiles, " of ", progress.all, " tiles joined, ", progress.triangles, " triangles; ",
        options.memory_bytes > 0 ? "allow more, or fill the tiles apart with `tilemend run`"
                                 : "fill the tiles apart with `tilemend run`"));
  }
}

}  // namespace tilemend
