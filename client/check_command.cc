// `tilemend check`: what is wrong with a mesh, the tiles of a scene, or an output.
#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "client/commands.h"
#include "client/inspection.h"
#include "client/job_flags.h"
#include "client/mesh/single_mesh.h"
#include "client/output.h"
#include "client/output_tiles.h"
#include "client/progress_display.h"
#include "client/unfinished.h"
#include "common/codec/mesh_file.h"
#include "common/grid/cell_choice.h"
#include "common/grid/delivery_paths.h"
#include "common/util/exit_codes.h"
#include "common/util/files.h"
#include "common/util/folders.h"
#include "common/util/object_store.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"
#include "coordinator/report/area_choice.h"
#include "coordinator/report/json_access.h"
#include "coordinator/report/shallow_json.h"
#include "coordinator/report/tile_checks.h"
#include "worker/check/mesh_defects.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

constexpr size_t kMostPlaces = 10;  // of a kind over all tiles
constexpr size_t kCountColumn = 9;  // characters of the column of counts in the table

struct DefectText {
  Defect defect;
  const char *name, *one, *many;  // for programs; for people, of one and of several
};
constexpr DefectText kNames[] = {
    {Defect::kNonManifoldEdge, "nonmanifold_edges", "nonmanifold edge", "nonmanifold edges"},
    {Defect::kNonManifoldVertex, "nonmanifold_vertices", "nonmanifold vertex", "nonmanifold vertices"},
    {Defect::kTurnedEdge, "turned_edges", "turned edge", "turned edges"},
    {Defect::kSelfIntersection, "self_intersections", "self intersection", "self intersections"},
    {Defect::kCreasedEdge, "creased_edges", "creased edge", "creased edges"},
    {Defect::kSpike, "spikes", "spike", "spikes"},
    {Defect::kSmallComponent, "small_components", "small component", "small components"},
    {Defect::kDuplicateTriangle, "duplicate_triangles", "duplicate triangle", "duplicate triangles"},
    {Defect::kFlatTriangle, "flat_triangles", "flat triangle", "flat triangles"}};
constexpr std::pair<SingleType, const char*> kKinds[] = {{SingleType::kCrack, "crack"},
                                                         {SingleType::kDislocation, "dislocation"},
                                                         {SingleType::kAnnular, "annular"},
                                                         {SingleType::kIsland, "island"},
                                                         {SingleType::kSimple, "simple"}};

struct Limits {
  CheckLimits mesh;
  int64_t small_hole_edges = 12;
};

absl::StatusOr<Limits> LimitsFromFlags(const Args& args) {
  Limits limits;
  TILEMEND_ASSIGN_OR_RETURN(limits.mesh.crease_degrees, args.Number("crease-angle", 1, 179));
  TILEMEND_ASSIGN_OR_RETURN(limits.mesh.spike_degrees, args.Number("spike-angle", 1, 359));
  TILEMEND_ASSIGN_OR_RETURN(limits.mesh.component_edges, args.Number("small-component", 0, 1e9));
  TILEMEND_ASSIGN_OR_RETURN(const double edges, args.Number("small-hole", 0, 1e9));
  limits.small_hole_edges = static_cast<int64_t>(edges);
  return limits;
}

// What was found in all tiles together.
struct Findings {
  std::map<Defect, DefectFinding> defects;
  int64_t triangles = 0;
  std::vector<std::string> longer;  // files with bytes after the end of their mesh
  OutputTiles tiles;                // of an output
};

absl::Status CheckFile(const std::string& path, const TileFrame& frame, const CheckLimits& limits, Findings& all) {
  TILEMEND_ASSIGN_OR_RETURN(const MeshFile file, ReadMeshFile(path, frame));
  all.triangles += std::ssize(file.mesh.triangles);
  if (file.bytes_after_end > 0) all.longer.push_back(path);
  for (const auto& [defect, finding] : FindDefects(file.mesh, limits)) {
    DefectFinding& sum = all.defects[defect];
    sum.count += finding.count;
    for (const Point3& p : finding.places) {
      if (sum.places.size() < kMostPlaces) sum.places.push_back(p);
    }
  }
  return absl::OkStatus();
}

struct CheckedScene {
  Scene scene;
  OutputTiles tiles;  // of an output whose scene is there
};

// The cells that the job of this report was to write; empty: all.
std::set<CellId> ChosenCells(const Json& report, const Scene& scene) {
  const auto chosen = ChooseCells(Text(Member(Member(report, "options"), "cells")), scene);
  return chosen.ok() ? *chosen : std::set<CellId>();
}

// Gives the scene the area that is filled. Where its file cannot be read any more, that is a warning.
void ApplyArea(const std::string& area, Scene& scene) {
  const absl::Status status = ApplyAreaChoice(area, scene).status();
  if (status.ok()) return;
  PrintWarnings({absl::StrCat(std::string(status.message()),
                              ": checked without the area; what it leaves out may count as holes")});
}

// The output in `folder` with this report, of a scene.
CheckedScene OutputOf(Scene scene, const Json& report, const std::string& folder) {
  const std::set<CellId> chosen = ChosenCells(report, scene);
  CheckedScene checked{{}, LookForTiles(folder, report, scene, chosen)};
  scene.root = folder;
  for (SceneTile& tile : scene.tiles) {
    std::string output = OutputPath(tile);
    tile.path = KindOf(absl::StrCat(folder, "/", output)) == PathKind::kNothing ? "" : std::move(output);
    tile.frame = OutputFrame(tile);
    tile.added = tile.added && tile.path.empty();
  }
  // Cells without a tile that the job was not to write are no holes.
  std::erase_if(scene.tiles,
                [&](const SceneTile& t) { return t.path.empty() && !chosen.empty() && !chosen.contains(t.cell); });
  checked.scene = std::move(scene);
  return checked;
}

absl::StatusOr<CheckedScene> SceneWithItsArea(const std::string& path) {
  TILEMEND_ASSIGN_OR_RETURN(Scene scene, LoadScene(path, ReadTileHull, ReadTilesets));
  ApplyArea("", scene);
  return CheckedScene{std::move(scene), {}};
}

// The tiles of an output in the cells of the scene that it was made from, as long as that is there; or of any scene.
absl::StatusOr<CheckedScene> SceneAt(const std::string& path) {
  const std::string report_path = absl::StrCat(path, "/report.json");
  if (KindOf(report_path) != PathKind::kFile) {
    if (IsOutput(path)) return absl::InvalidArgumentError(absl::StrCat(report_path, ": not a file"));
    return SceneWithItsArea(path);
  }
  TILEMEND_ASSIGN_OR_RETURN(const std::string text, ReadFile(report_path));
  const Json report = ParseShallow(text);
  if (IsOutput(path) && !(report.is_object() && report.contains("cells"))) {
    return absl::InvalidArgumentError(absl::StrCat(report_path, ": not a report; run the same job again"));
  }
  const std::string source = Text(Member(report, "scene"));
  auto scene = LoadScene(source.empty() ? path : source, ReadTileHull, ReadTilesets);
  if (!scene.ok()) {
    PrintWarnings(
        {absl::StrCat(std::string(scene.status().message()),
                      ": checked without the scene that it was made from; tiles that are missing are not named")});
    return SceneWithItsArea(path);
  }
  const Json& options = Member(report, "options");
  ApplyArea(Text(Member(options, "area")), *scene);
  // After the area, which may add cells.
  TILEMEND_RETURN_IF_ERROR(SetDeliveryPaths(Text(Member(options, "output-format")), *scene));
  return OutputOf(*std::move(scene), report, path);
}

Json PlaceJson(const Point3& p) { return {p.x(), p.y(), p.z()}; }

Json DefectsJson(const Findings& all) {
  Json json = Json::object();
  for (const auto& [defect, name, one, many] : kNames) {
    const auto found = all.defects.find(defect);
    const DefectFinding finding = found == all.defects.end() ? DefectFinding() : found->second;
    Json at = Json::array();
    for (const Point3& p : finding.places) at.push_back(PlaceJson(p));
    json[name] = {{"count", finding.count}, {"at", at}};
  }
  return json;
}

// How many files, and the first of them.
Json FilesJson(const std::vector<std::string>& files) {
  const auto shown = static_cast<ptrdiff_t>(std::min(files.size(), kMostPlaces));
  return {{"count", files.size()}, {"files", std::vector<std::string>(files.begin(), files.begin() + shown)}};
}

Json HolesJson(const Plan& plan, int64_t small_hole_edges) {
  int64_t open = 0, small = 0, unlinked = 0, continuous = 0;
  std::map<SingleType, int64_t> kinds;
  Json at = Json::array();
  for (const PlannedHole& hole : plan.holes) {
    if (at.size() < kMostPlaces && !hole.segments.empty()) {
      at.push_back(PlaceJson(plan.vertices[static_cast<size_t>(hole.segments.front().from)].position));
    }
    open += hole.kind != HoleKind::kClosed;
    small += hole.kind == HoleKind::kClosed && hole.boundary_vertices <= small_hole_edges;
    continuous += hole.continuous;
    ++kinds[hole.single];
  }
  Json first_unlinked = Json::array();
  for (const LeftOpen& left : plan.left) {
    if (left.hole >= 0 || !left.is_hole) continue;
    unlinked += left.edges;
    if (left.at) first_unlinked.push_back(PlaceJson(*left.at));
  }
  Json single = Json::object();
  for (const auto& [kind, name] : kKinds) single[name] = kinds[kind];
  return {{"all", plan.holes.size()},
          {"small", small},
          {"open", open},
          {"single", single},
          {"continuous", std::max<int64_t>(continuous, plan.continuous)},
          {"at", at},
          {"edges_in_no_loop", unlinked},
          {"edges_in_no_loop_at", first_unlinked}};
}

// How many faults there are: a mesh with none is closed but for its outlines.
int64_t CountFaults(const Json& json) {
  int64_t count = json["holes"]["all"].get<int64_t>() + json["holes"]["edges_in_no_loop"].get<int64_t>();
  for (const auto& [name, finding] : json["defects"].items()) count += finding["count"].get<int64_t>();
  for (const char* files : {"missing_tiles", "longer_files"}) count += json[files]["count"].get<int64_t>();
  return count;
}

// The start of a row of the table: the number at the right of its column, then what is counted.
std::string CountRow(const Json& count, const std::string& one, const std::string& many) {
  const std::string text = Counted(count.get<size_t>(), " " + one, " " + many);
  return std::string(kCountColumn - std::min(kCountColumn, text.find(' ')), ' ') + text;
}

// The files that are not as they should be, one line for each kind that there is.
std::string FilesText(const Json& json) {
  constexpr std::array<const char*, 3> kLines[] = {
      {"missing_tiles", "missing tile", "missing tiles"},
      {"longer_files", "file with bytes after the end of its mesh", "files with bytes after the end of their mesh"},
      {"other_meshes", "other mesh among the tiles (no fault)", "other meshes among the tiles (no fault)"}};
  std::string text;
  for (const auto& [name, one, many] : kLines) {
    const Json& files = json[name];
    if (files["files"].empty()) continue;
    absl::StrAppend(&text, CountRow(files["count"], one, many), ", the first ",
                    Printable(files["files"][0].get<std::string>()), "\n");
  }
  return text;
}

void PrintTable(const Json& json) {
  std::string text = absl::StrCat("checked: ", Printable(json["path"].get<std::string>()), ", ",
                                  Counted(json["triangles"].get<size_t>(), "triangle"), "\n");
  const auto first = [](const Json& at) {
    return at.empty() ? ""
                      : absl::StrFormat(", the first at [%.8g,%.8g,%.8g]", at[0][0].get<double>(),
                                        at[0][1].get<double>(), at[0][2].get<double>());
  };
  for (const auto& [defect, name, one, many] : kNames) {
    const Json& finding = json["defects"][name];
    absl::StrAppend(&text, CountRow(finding["count"], one, many), first(finding["at"]), "\n");
  }
  const Json& holes = json["holes"];
  const int64_t small = holes["small"].get<int64_t>();
  absl::StrAppend(&text, CountRow(holes["all"], "hole", "holes"),
                  small > 0 ? absl::StrCat(", ", small, " of them small") : "", first(holes["at"]), "\n");
  for (const auto& [name, count] : holes["single"].items()) {
    if (count.get<int64_t>() > 0) absl::StrAppend(&text, absl::StrFormat("%9d    %s\n", count.get<int64_t>(), name));
  }
  const int64_t open = holes["open"].get<int64_t>();
  if (open > 0) absl::StrAppend(&text, absl::StrFormat("%9d    over a border between tiles\n", open));
  absl::StrAppend(&text, CountRow(holes["edges_in_no_loop"], "boundary edge in no loop", "boundary edges in no loop"),
                  first(holes["edges_in_no_loop_at"]), "\n",
                  CountRow(json["outlines"], "outline (no fault)", "outlines (no fault)"), "\n", FilesText(json));
  std::fputs(text.c_str(), stdout);
}

int Finish(const std::string& path, const Limits& limits, const Findings& all, const Plan& plan, OutputFormat format) {
  Json json = {{"path", path},
               {"triangles", all.triangles},
               {"limits",
                {{"crease_degrees", limits.mesh.crease_degrees},
                 {"spike_degrees", limits.mesh.spike_degrees},
                 {"spike_edges", limits.mesh.spike_edges},
                 {"small_component_edges", limits.mesh.component_edges},
                 {"small_hole_edges", limits.small_hole_edges}}},
               {"defects", DefectsJson(all)},
               {"holes", HolesJson(plan, limits.small_hole_edges)},
               {"outlines", plan.outer_rims},
               {"missing_tiles", FilesJson(all.tiles.missing)},
               {"longer_files", FilesJson(all.longer)},
               {"other_meshes", FilesJson(all.tiles.others)}};
  const int64_t faults = CountFaults(json);
  json["faults"] = faults;
  if (format == OutputFormat::kJson) {
    std::fputs((json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n").c_str(), stdout);
  } else {
    PrintTable(json);
  }
  return faults > 0 ? kExitSomeLeft : kExitDone;
}

int CheckMesh(const std::string& path, const Limits& limits, OutputFormat format) {
  Findings all;
  if (const absl::Status status = CheckFile(path, {}, limits.mesh, all); !status.ok()) return PrintError(status);
  const auto file = ReadMeshFile(path);
  if (!file.ok()) return PrintError(file.status());
  WaveOptions options;
  options.single_mesh = options.plan_only = true;
  options.plan.water.find = false;
  SceneWaves waves(SceneOfMesh(path), options);
  while (waves.Next()) waves.Take(SurveyInMemory({0, 0}, SurveyOf(*file))).IgnoreError();  // nothing is cleared
  return Finish(path, limits, all, waves.plan(), format);
}

// The plan of the scene; what is wrong with its tiles goes to `all`.
absl::StatusOr<Inspection> CheckTiles(Scene scene, const CheckLimits& limits, Findings& all) {
  StepDisplay display;
  PlanOptions options;
  options.water.find = false;
  Inspection inspection = InspectScene(std::move(scene), options, display.Watcher());
  if (!inspection.errors.empty()) return inspection.errors.front();
  const std::vector<SceneTile>& tiles = inspection.waves->scene().tiles;
  const auto has_file = [](const SceneTile& tile) { return !tile.path.empty(); };
  const auto count = static_cast<size_t>(std::ranges::count_if(tiles, has_file));
  size_t done = 0;
  for (const SceneTile& tile : tiles) {
    if (!has_file(tile)) continue;
    display.Show("look for faults", done++, count, "tile");
    const std::string file = absl::StrCat(inspection.waves->scene().root, "/", tile.path);
    TILEMEND_RETURN_IF_ERROR(CheckFile(file, tile.frame, limits, all));
  }
  return inspection;
}

int CheckScene(const std::string& path, const Limits& limits, OutputFormat format) {
  if (const auto finished = CheckFinished(path); !finished.ok()) return PrintError(finished);
  auto checked = SceneAt(path);
  if (!checked.ok()) return PrintError(checked.status());
  Findings all;
  all.tiles = std::move(checked->tiles);
  const auto inspection = CheckTiles(std::move(checked->scene), limits.mesh, all);
  if (!inspection.ok()) return PrintError(inspection.status());
  return Finish(path, limits, all, inspection->waves->plan(), format);
}

}  // namespace

int CheckCommand(const Args& args) {
  if (args.arguments().size() == 2) {
    for (const char* const flag : {"crease-angle", "spike-angle", "small-component", "small-hole"}) {
      if (!args.IsGiven(flag)) continue;
      return PrintUsageError(absl::InvalidArgumentError(
          absl::StrCat("check: --", flag, " is for one mesh or scene, not for a scene and its output")));
    }
    return AcceptanceCommand(args);
  }
  for (const char* const flag : {"csv", "page"}) {
    if (!args.IsGiven(flag)) continue;
    return PrintUsageError(absl::InvalidArgumentError(absl::StrCat("check: --", flag, " needs a scene and an output")));
  }
  const auto format = FormatFromFlags(args);
  if (!format.ok()) return PrintUsageError(format.status());
  const auto limits = LimitsFromFlags(args);
  if (!limits.ok()) return PrintUsageError(limits.status());
  const std::string& path = args.arguments().front();
  const auto kind = FindKind(path);
  if (IsStoreError(path, kind.status())) return PrintError(kind.status());
  if (kind.ok() && *kind == PathKind::kNothing)
    return PrintError(absl::NotFoundError(absl::StrCat(path, ": no such file or folder")));
  return IsSingleMesh(path) ? CheckMesh(path, *limits, *format) : CheckScene(path, *limits, *format);
}

}  // namespace tilemend
