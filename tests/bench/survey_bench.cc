// Times the survey of one tile on one thread, reading included, beside plain sorting of all its edges.
//
//   survey_bench [TILE] [--shuffle] [--rounds N] [--json]
//
// Without TILE a tile of a million triangles with small holes is made in the temporary folder; --shuffle puts its
// vertices and triangles in random order, the worst case for caches. Both ways start from the file (in the page cache)
// and share its reading. Prints the first round, which finds no memory of earlier ones to use again, the best and the
// median.
#include <stdlib.h>  // mkdtemp, of POSIX

#include <algorithm>
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

class Timings {
 public:
  // Seconds that `body` takes, kept under `name`.
  template <class Body>
  auto Measure(const std::string& name, Body body) {
    const auto start = std::chrono::steady_clock::now();
    auto result = body();
    Add(name, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    return result;
  }
  void Add(const std::string& name, double seconds) { seconds_[name].push_back(seconds); }
  double Last(const std::string& name) const { return seconds_.at(name).back(); }
  double First(const std::string& name) const { return seconds_.at(name).front(); }
  double Best(const std::string& name) const {
    return *std::min_element(seconds_.at(name).begin(), seconds_.at(name).end());
  }
  double Median(const std::string& name) const {
    std::vector<double> sorted = seconds_.at(name);
    std::sort(sorted.begin(), sorted.end());
    return sorted[sorted.size() / 2];
  }

 private:
  std::map<std::string, std::vector<double>> seconds_;
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
  record =
      timings.Measure("survey", [&file] { return SurveyTile(file.mesh, file.number_type == NumberType::kFloat32); });
  alone = timings.Measure("sorting", [&file] { return CountBoundaryEdgesBySorting(file.mesh); });
  const double reading = timings.Last("read") + timings.Last("parse");
  timings.Add("survey, reading included", reading + timings.Last("survey"));
  timings.Add("sorting, reading included", reading + timings.Last("sorting"));
  return absl::OkStatus();
}

void PrintTable(const Timings& timings, const MeshFile& file, const SurveyRecord& record, size_t alone, int rounds) {
  std::printf("%zu triangles, %zu vertices, %.1f MB; boundary edges: %zu by survey, %zu by sorting; %d rounds\n",
              file.mesh.triangles.size(), file.mesh.points.size(), static_cast<double>(file.file_bytes) / 1e6,
              record.edges.size(), alone, rounds);
  std::printf("%-28s %9s %9s %9s\n", "", "first", "best", "median");
  for (const char* name :
       {"read", "parse", "survey", "sorting", "survey, reading included", "sorting, reading included"}) {
    std::printf("%-28s %7.4f s %7.4f s %7.4f s\n", name, timings.First(name), timings.Best(name), timings.Median(name));
  }
  std::printf("sorting takes %.2f times as long as the survey, %.2f times with reading (medians)\n",
              timings.Median("sorting") / timings.Median("survey"),
              timings.Median("sorting, reading included") / timings.Median("survey, reading included"));
}

void PrintJson(const Timings& timings, const MeshFile& file, const SurveyRecord& record, int rounds) {
  std::printf("{\"triangles\": %zu, \"bytes\": %lld, \"boundary_edges\": %zu, \"rounds\": %d",
              file.mesh.triangles.size(), static_cast<long long>(file.file_bytes), record.edges.size(), rounds);
  for (const char* name :
       {"read", "parse", "survey", "sorting", "survey, reading included", "sorting, reading included"}) {
    std::printf(", \"%s\": {\"first\": %.6f, \"best\": %.6f, \"median\": %.6f}", name, timings.First(name),
                timings.Best(name), timings.Median(name));
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
