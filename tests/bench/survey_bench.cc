// Times the survey of one tile on one thread, reading included, beside plain sorting of all its edges.
//
//   survey_bench [TILE] [--shuffle] [--rounds N] [--json]
//
// Without TILE a tile of a million triangles with small holes is made in the temporary folder; --shuffle puts its
// vertices and triangles in random order, the worst case for caches. Both ways start from the file (in the page cache)
// and share its reading. Prints the first round, which finds no memory of earlier ones to use again, the best and the
// median, and the least CPU time.
#include <stdlib.h>  // mkdtemp, of POSIX
#include <time.h>    // clock_gettime, of POSIX

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <numeric>
#include <random>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "absl/cleanup/cleanup.h"
#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "common/codec/mesh_file.h"
#include "common/util/files.h"
#include "common/util/status_macros.h"
#include "tests/support/scene_maker.h"
#include "worker/survey/survey.h"

namespace tilemend {
namespace {

struct Command {
  std::string tile;
  bool shuffle = false;
  int rounds = 9;
  bool json = false;
};

struct Seconds {
  double wall = 0;
  double cpu = 0;  // of this thread: what other work on the machine disturbs least
};

Seconds operator+(const Seconds& a, const Seconds& b) { return {a.wall + b.wall, a.cpu + b.cpu}; }

Seconds Now() {
  timespec cpu{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &cpu);
  const auto wall = std::chrono::steady_clock::now().time_since_epoch();
  return {std::chrono::duration<double>(wall).count(),
          static_cast<double>(cpu.tv_sec) + 1e-9 * static_cast<double>(cpu.tv_nsec)};
}

class Timings {
 public:
  // Keeps the time that `body` takes under `name`.
  template <class Body>
  auto Measure(const std::string& name, Body body) {
    const Seconds start = Now();
    auto result = body();
    const Seconds end = Now();
    Add(name, {end.wall - start.wall, end.cpu - start.cpu});
    return result;
  }
  void Add(const std::string& name, Seconds seconds) { seconds_[name].push_back(seconds); }
  Seconds Last(const std::string& name) const { return seconds_.at(name).back(); }

  // Wall time of the first round, its least and its median; the least CPU time.
  struct Summary {
    double first, best, median, cpu;
  };
  Summary Of(const std::string& name) const {
    const std::vector<Seconds>& all = seconds_.at(name);
    std::vector<double> wall, cpu;
    for (const Seconds& s : all) {
      wall.push_back(s.wall);
      cpu.push_back(s.cpu);
    }
    std::sort(wall.begin(), wall.end());
    return {all.front().wall, wall.front(), wall[wall.size() / 2], *std::min_element(cpu.begin(), cpu.end())};
  }

 private:
  std::map<std::string, std::vector<Seconds>> seconds_;
};

// The plain way to find boundary edges: all edges of the tile, sorted; those that stand alone. Returns how many.
size_t CountBoundaryEdgesBySorting(const TriMesh& mesh) {
  std::vector<uint64_t> edges;
  edges.reserve(mesh.triangles.size() * 3);
  for (const Triangle& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      const auto a = static_cast<uint64_t>(t[k]), b = static_cast<uint64_t>(t[(k + 1) % 3]);
      edges.push_back(std::min(a, b) << 32 | std::max(a, b));
    }
  }
  std::sort(edges.begin(), edges.end());
  size_t alone = 0;
  for (size_t i = 0; i < edges.size();) {
    size_t j = i;
    while (j < edges.size() && edges[j] == edges[i]) ++j;
    alone += j - i == 1;
    i = j;
  }
  return alone;
}

// Vertices and triangles in an order drawn with a fixed seed.
TriMesh Shuffled(const TriMesh& mesh) {
  std::mt19937_64 random(1);
  std::vector<int32_t> place(mesh.points.size());
  std::iota(place.begin(), place.end(), 0);
  std::shuffle(place.begin(), place.end(), random);
  TriMesh shuffled = mesh;
  for (size_t v = 0; v < place.size(); ++v) shuffled.points[place[v]] = mesh.points[v];
  for (Triangle& t : shuffled.triangles) t = {place[t[0]], place[t[1]], place[t[2]]};
  std::shuffle(shuffled.triangles.begin(), shuffled.triangles.end(), random);
  return shuffled;
}

// A tile of 1 million triangles: 250 m with a vertex every 0.354 m.
absl::StatusOr<std::string> MakeTile(const std::string& folder, bool shuffle) {
  SceneMakerOptions options;
  options.cols = options.rows = 1;
  options.cell_size = 250;
  options.spacing = 0.35355339;
  options.relief = 20;
  options.noise = 0.05;
  options.small_per_cell = 10;
  const std::string path = folder + "/tile.ply";
  const MadeScene scene = MakeScene(options);
  const TriMesh& mesh = scene.tiles[0].mesh;
  TILEMEND_RETURN_IF_ERROR(WriteFileAtomically(path, PlyBytes(shuffle ? Shuffled(mesh) : mesh), Sync::kNo));
  return path;
}

absl::Status Round(const std::string& path, Timings& timings, MeshFile& file, SurveyRecord& record, size_t& alone) {
  const auto bytes = timings.Measure("read", [&] { return ReadFile(path); });
  TILEMEND_RETURN_IF_ERROR(bytes.status());
  TILEMEND_ASSIGN_OR_RETURN(const MeshFormat format, MeshFormatOf(path));
  auto parsed = timings.Measure("parse", [&] { return ParseMesh(format, *bytes, path); });
  TILEMEND_RETURN_IF_ERROR(parsed.status());
  file = *std::move(parsed);
  record = timings.Measure(
      "survey", [&file] { return SurveyTile(file.mesh, file.number_type == NumberType::kFloat32, PieceAreas::kNo); });
  alone = timings.Measure("sorting", [&file] { return CountBoundaryEdgesBySorting(file.mesh); });
  const Seconds reading = timings.Last("read") + timings.Last("parse");
  timings.Add("survey, reading included", reading + timings.Last("survey"));
  timings.Add("sorting, reading included", reading + timings.Last("sorting"));
  return absl::OkStatus();
}

constexpr std::array<const char*, 6> kRows = {
    "read", "parse", "survey", "sorting", "survey, reading included", "sorting, reading included"};

void PrintTable(const Timings& timings, const MeshFile& file, const SurveyRecord& record, size_t alone, int rounds) {
  std::printf("%zu triangles, %zu vertices, %.1f MB; boundary edges: %zu by survey, %zu by sorting; %d rounds\n",
              file.mesh.triangles.size(), file.mesh.points.size(), static_cast<double>(file.file_bytes) / 1e6,
              record.edges.size(), alone, rounds);
  std::printf("%-28s %9s %9s %9s %9s\n", "", "first", "best", "median", "CPU");
  for (const char* name : kRows) {
    const Timings::Summary s = timings.Of(name);
    std::printf("%-28s %7.4f s %7.4f s %7.4f s %7.4f s\n", name, s.first, s.best, s.median, s.cpu);
  }
  std::printf("sorting takes %.2f times as long as the survey, %.2f times with reading (least CPU time)\n",
              timings.Of("sorting").cpu / timings.Of("survey").cpu,
              timings.Of("sorting, reading included").cpu / timings.Of("survey, reading included").cpu);
}

void PrintJson(const Timings& timings, const MeshFile& file, const SurveyRecord& record, int rounds) {
  std::printf("{\"triangles\": %zu, \"bytes\": %lld, \"boundary_edges\": %zu, \"rounds\": %d",
              file.mesh.triangles.size(), static_cast<long long>(file.file_bytes), record.edges.size(), rounds);
  for (const char* name : kRows) {
    const Timings::Summary s = timings.Of(name);
    std::printf(", \"%s\": {\"first\": %.6f, \"best\": %.6f, \"median\": %.6f, \"cpu\": %.6f}", name, s.first, s.best,
                s.median, s.cpu);
  }
  std::printf("}\n");
}

absl::Status Run(const Command& command) {
  std::string folder = (std::filesystem::temp_directory_path() / "tilemend-bench-XXXXXX").string();
  if (mkdtemp(folder.data()) == nullptr) return absl::PermissionDeniedError(folder + ": cannot be made");
  const auto remove = absl::MakeCleanup([&folder] {
    std::error_code ignored;
    std::filesystem::remove_all(folder, ignored);
  });
  std::string path = command.tile;
  if (path.empty()) {
    TILEMEND_ASSIGN_OR_RETURN(path, MakeTile(folder, command.shuffle));
  }
  Timings timings;
  MeshFile file;
  SurveyRecord record;
  size_t alone = 0;
  for (int i = 0; i < command.rounds; ++i) TILEMEND_RETURN_IF_ERROR(Round(path, timings, file, record, alone));
  if (command.json) {
    PrintJson(timings, file, record, command.rounds);
  } else {
    PrintTable(timings, file, record, alone, command.rounds);
  }
  return absl::OkStatus();
}

int Main(const std::vector<std::string>& arguments) {
  Command command;
  for (size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i] == "--json") {
      command.json = true;
    } else if (arguments[i] == "--shuffle") {
      command.shuffle = true;
    } else if (arguments[i] == "--rounds" && i + 1 < arguments.size() &&
               absl::SimpleAtoi(arguments[i + 1], &command.rounds) && command.rounds > 0) {
      ++i;
    } else if (!arguments[i].starts_with("--") && command.tile.empty()) {
      command.tile = arguments[i];
    } else {
      std::fputs("usage: survey_bench [TILE] [--shuffle] [--rounds N] [--json]\n", stderr);
      return 2;
    }
  }
  const absl::Status status = Run(command);
  if (status.ok()) return 0;
  std::fprintf(stderr, "survey_bench: %s\n", std::string(status.message()).c_str());
  return 6;
}

}  // namespace
}  // namespace tilemend

int main(int argc, char** argv) { return tilemend::Main({argv + 1, argv + argc}); }
