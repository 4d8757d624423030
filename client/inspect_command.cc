// `tilemend inspect`: what a scene or a mesh holds, without writing anything.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "absl/strings/str_join.h"
#include "client/border_table.h"
#include "client/commands.h"
#include "client/crs_text.h"
#include "client/holes_file.h"
#include "client/holes_table.h"
#include "client/inspection.h"
#include "client/job_flags.h"
#include "client/left_table.h"
#include "client/mesh/single_mesh.h"
#include "client/output.h"
#include "client/output_file.h"
#include "client/progress_display.h"
#include "client/water_proposal.h"
#include "client/water_table.h"
#include "common/gis/area_file.h"
#include "common/util/files.h"
#include "common/util/folders.h"
#include "common/util/object_store.h"
#include "common/util/standard_streams.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"
#include "coordinator/plan/rim/area_proposal.h"
#include "coordinator/report/area_choice.h"
#include "coordinator/report/cleared_report.h"
#include "coordinator/report/json_access.h"
#include "coordinator/report/outline_holes.h"
#include "coordinator/report/plan_warnings.h"
#include "coordinator/report/scene_geojson.h"
#include "coordinator/report/scene_report.h"
#include "coordinator/report/tile_checks.h"
#include "coordinator/report/water_choice.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

// What is to be known before the plan: of the scene, of the files that options name, and of those of the tiles.
std::vector<std::string> WarningsBeforePlan(const Inspection& inspection) {
  std::vector<std::string> warnings = inspection.waves->scene().warnings;
  warnings.insert(warnings.end(), inspection.warnings.begin(), inspection.warnings.end());
  return warnings;
}

// The part of the report that the plan alone tells.
Json PlanJson(const Inspection& inspection, int64_t cells) {
  SceneReportInput input;
  input.plan = &inspection.waves->plan();
  input.warnings = WarningsBeforePlan(inspection);
  input.cells = cells;
  Json json = Json::parse(SceneReport(input));
  for (const char* field : {"date", "scene", "options", "filled", "quality", "tension", "seconds", "peak_rss_bytes"})
    json.erase(field);
  for (Json& row : json["per_hole"]) {
    row.erase("outcome");
  }
  return json;
}

Json RecordJson(const SurveyRecord& record) {
  Json json = {{"vertices", record.vertex_count},
               {"triangles", record.triangle_count},
               {"boundary_edges", record.edges.size()},
               {"doubled_vertices", record.doubled_vertices},
               {"degenerate_triangles", record.degenerate_triangles},
               {"nonmanifold_edges", record.nonmanifold_edges},
               {"number_type", record.float32 ? "float32" : "float64"}};
  json["low"] = {record.lo.x(), record.lo.y(), record.lo.z()};
  json["high"] = {record.hi.x(), record.hi.y(), record.hi.z()};
  return json;
}

// "closed 3", "I C 2": the counts that are not zero.
void AddCounts(const Json& counts, const std::string& name, std::vector<std::string>& parts) {
  for (const auto& [key, value] : counts.items()) {
    const std::string full = name.empty() ? key : absl::StrCat(name, " ", key);
    if (value.is_object()) {
      AddCounts(value, full, parts);
    } else if (value.is_number_integer() && value != 0) {
      parts.push_back(absl::StrCat(full, " ", value.get<int64_t>()));
    }
  }
}

std::string CountsText(const Json& counts) {
  std::vector<std::string> parts;
  AddCounts(counts, "", parts);
  return parts.empty() ? "none" : absl::StrJoin(parts, ", ");
}

std::string HolesLine(const Json& plan) {
  return absl::StrFormat("holes: %s\nclusters: %d, layers: %d, continuous: %d\n", CountsText(plan["holes"]),
                         plan["clusters"].get<int>(), plan["layers"].get<int>(), plan["continuous"].get<int>());
}

std::string PlanText(const Json& plan) {
  const size_t columns = ColumnsOfTerminal(STDOUT_FILENO);
  return absl::StrCat(PlannedHolesText(plan, columns), WaterText(plan, "to fill flat as water", columns),
                      LookAtText(plan, columns), LeftText(plan, "left open", columns));
}

std::string SceneText(const Inspection& inspection, const Json& plan) {
  const Scene& scene = inspection.waves->scene();
  const std::map<CellId, StoredRecord>& records = inspection.waves->survey().records();
  int64_t triangles = 0;
  std::vector<std::vector<std::string>> rows;
  for (const auto& [cell, stored] : records) {
    if (stored == nullptr) continue;
    const auto record = stored.Outline();
    const SurveyRecord& r = *record;
    triangles += r.triangle_count;
    rows.push_back({ToString(cell), absl::StrCat(r.vertex_count), absl::StrCat(r.triangle_count),
                    absl::StrCat(r.edges.size()), absl::StrCat(r.nonmanifold_edges),
                    absl::StrFormat("%.1f to %.1f", r.lo.z(), r.hi.z())});
  }
  std::string text = absl::StrFormat(
      "scene %s\ngrid: %d x %d cells of %g x %g m from (%g, %g), %d in the area, %d with a tile\nCRS: %s, origin "
      "(%.3f, %.3f, %.3f)\n"
      "triangles: %d\n%s",
      Printable(scene.root), scene.cols, scene.rows, scene.grid.cell_size.x(), scene.grid.cell_size.y(),
      scene.grid.corner.x(), scene.grid.corner.y(), scene.tiles.size(), rows.size(),
      scene.crs.empty() ? "not given" : CrsText(scene.crs), scene.origin.x(), scene.origin.y(), scene.origin.z(),
      triangles, HolesLine(plan));
  if (!scene.area_known) absl::StrAppend(&text, "area: not given; holes that reach its rim are left\n");
  const size_t tiles = rows.size();
  rows.resize(std::min(tiles, kMostListedRows));
  absl::StrAppend(&text, "\n",
                  Table({"tile", "vertices", "triangles", "boundary edges", "non-manifold", "heights, m"}, rows),
                  MoreText(tiles, "-o json lists all"), BordersText(plan), PlanText(plan));
  return text;
}

constexpr const char* kOnlyForScenes[] = {"area", "decisions", "propose-area", "propose-water"};

// What is to be looked at, and how.
struct Request {
  std::string path;
  std::string area, propose_area, propose_water, holes;  // values of the flags of these names
  bool overwrite = false;
  std::string water, clear, decisions;
  WaterProfile water_profile;
  OutputFormat format = OutputFormat::kTable;
};

absl::StatusOr<PlanOptions> PlanOptionsOf(const Request& request, Scene& scene) {
  TILEMEND_ASSIGN_OR_RETURN(WaterChoice water, ReadWaterChoice(request.water, FrameOf(scene)));
  TILEMEND_RETURN_IF_ERROR(AddClearFile(request.clear, FrameOf(scene), water));
  TILEMEND_RETURN_IF_ERROR(KeepClearInside(scene.area, water));
  TILEMEND_RETURN_IF_ERROR(AddDecisions(request.decisions, scene, water));
  for (std::string& warning : water.warnings) scene.warnings.push_back(std::move(warning));
  PlanOptions options;
  options.water = std::move(water.options);
  options.water.profile = request.water_profile;
  return options;
}

absl::StatusOr<Inspection> InspectSceneOf(const Request& request, Scene scene) {
  CheckCrs(scene);
  TILEMEND_RETURN_IF_ERROR(ApplyAreaChoice(request.area, scene).status());
  TILEMEND_ASSIGN_OR_RETURN(const PlanOptions options, PlanOptionsOf(request, scene));
  StepDisplay display;
  return InspectScene(std::move(scene), options, display.Watcher());
}

absl::Status WriteProposal(const Request& request, const SceneWaves& waves) {
  const std::string& path = request.propose_area;
  if (path.empty()) return absl::OkStatus();
  const PlanePolygon area = ProposeArea(waves.scene().grid, waves.survey().records());
  if (area.empty()) return absl::FailedPreconditionError(absl::StrCat(path, ": too little surface to propose an area"));
  TILEMEND_RETURN_IF_ERROR(CheckOutputFile(path, request.overwrite, "--propose-area"));
  TILEMEND_RETURN_IF_ERROR(WriteFileAtomically(path, AreaGeoJson(area, waves.scene())));
  const std::string shown = Printable(path);
  std::fprintf(stderr, "%s: the outline of the surface; a guess: look at it, then: --area %s\n", shown.c_str(),
               shown.c_str());
  return absl::OkStatus();
}

absl::Status ProposeWater(const Request& request, const SceneWaves& waves) {
  const std::string& path = request.propose_water;
  if (path.empty()) return absl::OkStatus();
  TILEMEND_ASSIGN_OR_RETURN(const Json proposed, WriteWaterProposal(path, request.overwrite, waves));
  std::vector<std::vector<std::string>> rows;
  for (const Json& p : proposed) {
    if (rows.size() == kMostListedRows) break;
    rows.push_back(
        {p["name"], LevelText(p["proposed_level_m"]), LevelText(p["sigma_m"]), AreaText(p["area_m2"]), p["reason"]});
  }
  const std::string table = rows.empty() ? "" : Table({"polygon", "level, m", "sigma, m", "area, m2", "because"}, rows);
  std::fputs(absl::StrCat(table, MoreText(proposed.size(), path), path, ": ", Counted(proposed.size(), "polygon"),
                          "; a guess: delete what is no water, then: --water ", path, "\n")
                 .c_str(),
             stderr);
  return absl::OkStatus();
}

std::vector<std::string> OutputsOf(const Request& request) {
  std::vector<std::string> files = {request.holes, request.propose_area, request.propose_water};
  std::erase(files, "");
  return files;
}

// Absolute, links followed as far as the path exists.
std::filesystem::path Resolved(const std::string& path) {
  std::error_code error;
  const std::filesystem::path absolute = std::filesystem::absolute(path, error);
  std::filesystem::path resolved = std::filesystem::weakly_canonical(absolute, error);
  return error ? absolute : resolved;
}

// The files that are read: those of the scene and those that flags name. Some need not exist.
std::vector<std::string> InputsOf(const Request& request, const Scene& scene) {
  std::vector<std::string> files = {request.area, request.water, request.clear, request.decisions, scene.area_file};
  const std::string folder = scene.root.empty() ? "" : absl::StrCat(scene.root, "/");  // none of a single mesh
  for (const SceneTile& tile : scene.tiles) files.push_back(absl::StrCat(folder, tile.path));
  if (folder.empty()) return files;
  for (const char* name : {"scene.json", "tileset.json", "metadata.xml"}) files.push_back(absl::StrCat(folder, name));
  return files;
}

// Files that are replaced are none that is read, and none that only a slip can name, as the scene.json of any scene.
absl::Status CheckReplaced(const Request& request, const Scene& scene) {
  std::error_code error;
  const std::vector<std::string> inputs = InputsOf(request, scene);
  for (const std::string& output : OutputsOf(request)) {
    if (!std::filesystem::exists(output, error)) continue;
    for (const std::string& input : inputs) {
      if (!std::filesystem::equivalent(input, output, error)) continue;
      return absl::InvalidArgumentError(
          absl::StrCat(output, ": is read as input, so it is not replaced; choose another name for the output"));
    }
    if (HoldsPolygons(output)) continue;
    return absl::InvalidArgumentError(absl::StrCat(
        output,
        ": holds no polygons in GeoJSON or a GeoPackage, so it is not replaced; choose another name for the "
        "output"));
  }
  return absl::OkStatus();
}

// A new folder would hide a slip in its name.
absl::Status CheckFolderIsThere(const char* flag, const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  if (path.empty() || folder.empty() || IsObjectPath(path) || KindOf(folder) != PathKind::kNothing)
    return absl::OkStatus();
  return absl::NotFoundError(absl::StrCat(folder, ": no such folder; make it first, or choose another ", flag));
}

absl::Status CheckOutputs(const Request& request) {
  TILEMEND_RETURN_IF_ERROR(CheckFolderIsThere("--holes", request.holes));
  TILEMEND_RETURN_IF_ERROR(CheckFolderIsThere("--propose-area", request.propose_area));
  TILEMEND_RETURN_IF_ERROR(CheckFolderIsThere("--propose-water", request.propose_water));
  std::set<std::filesystem::path> files;
  for (const std::string& file : OutputsOf(request)) files.insert(Resolved(file));
  if (files.size() < OutputsOf(request).size()) {
    return absl::InvalidArgumentError("--holes, --propose-area and --propose-water: give each a file of its own");
  }
  const std::string ending = absl::AsciiStrToLower(std::filesystem::path(request.holes).extension().string());
  if (!request.holes.empty() && ending != ".geojson" && ending != ".json") {
    return absl::InvalidArgumentError(
        absl::StrCat(request.holes, ": holes are written as GeoJSON; choose a name that ends in .geojson"));
  }
  if (!request.holes.empty()) {
    TILEMEND_RETURN_IF_ERROR(CheckOutputFile(request.holes, request.overwrite, "--holes"));
  }
  if (!request.propose_area.empty()) {
    TILEMEND_RETURN_IF_ERROR(CheckOutputFile(request.propose_area, request.overwrite, "--propose-area"));
  }
  return request.propose_water.empty() ? absl::OkStatus()
                                       : CheckWaterProposal(request.propose_water, request.overwrite);
}

int InspectSceneAt(const Request& request) {
  if (const absl::Status status = CheckOutputs(request); !status.ok()) return PrintError(status);
  auto scene = LoadScene(request.path, ReadTileHull, ReadTilesets);
  if (!scene.ok()) return PrintError(scene.status());
  if (const absl::Status status = CheckReplaced(request, *scene); !status.ok()) return PrintUsageError(status);
  const auto inspection = InspectSceneOf(request, *std::move(scene));
  if (!inspection.ok()) return PrintError(inspection.status());
  const SceneWaves& waves = *inspection->waves;
  PrintWarnings(WarningsBeforePlan(*inspection));
  ExitCode code = kExitDone;
  for (const absl::Status& error : inspection->errors) code = PrintError(error);
  if (!inspection->errors.empty()) return code;
  if (const absl::Status status = WriteProposal(request, waves); !status.ok()) return PrintError(status);
  if (const absl::Status status = ProposeWater(request, waves); !status.ok()) return PrintError(status);
  if (const absl::Status status = WriteHoles(request.holes, waves); !status.ok()) return PrintError(status);
  PrintWarnings(PlanWarnings(waves.plan()));
  PrintWarnings(ClearedWarnings(waves.outcome().cleared));
  Json plan = PlanJson(*inspection, static_cast<int64_t>(waves.scene().tiles.size()));
  if (request.format == OutputFormat::kTable) {
    std::fputs(SceneText(*inspection, plan).c_str(), stdout);
    return kExitDone;
  }
  Json tiles = Json::array();
  for (const SceneTile& tile : waves.scene().tiles) {
    Json row = {{"cell", {tile.cell.col, tile.cell.row}}, {"path", tile.path.empty() ? Json() : Json(tile.path)}};
    const auto it = waves.survey().records().find(tile.cell);
    if (it != waves.survey().records().end() && it->second != nullptr) row.update(RecordJson(*it->second.Outline()));
    tiles.push_back(row);
  }
  plan["tiles"] = tiles;
  std::fputs((plan.dump(1, ' ', false, Json::error_handler_t::replace) + "\n").c_str(), stdout);
  return kExitDone;
}

int InspectMeshAt(const Request& request) {
  if (const absl::Status status = CheckOutputs(request); !status.ok()) return PrintError(status);
  const std::string& path = request.path;
  const auto file = ReadMeshFile(path);
  if (!file.ok()) return PrintError(file.status());
  Scene scene = SceneOfMesh(path);
  if (const absl::Status status = CheckReplaced(request, scene); !status.ok()) return PrintUsageError(status);
  const auto options = PlanOptionsOf(request, scene);
  if (!options.ok()) return PrintError(options.status());
  PrintWarnings(scene.warnings);
  const Inspection inspection = InspectScene(std::move(scene), *options);
  if (!inspection.errors.empty()) return PrintError(inspection.errors.front());
  const SceneWaves& waves = *inspection.waves;
  if (const absl::Status status = WriteHoles(request.holes, waves); !status.ok()) return PrintError(status);
  PrintWarnings(PlanWarnings(waves.plan()));
  const auto record = waves.survey().records().at({0, 0}).Outline();
  const SurveyRecord& r = *record;
  const Json plan = PlanJson(inspection, 1);
  const std::vector<int32_t> outlines = OutlineHoles(waves.plan(), r.lo, r.hi);
  if (request.format == OutputFormat::kJson) {
    Json json = RecordJson(r);
    json["polygons"] = file->polygon_count;
    json.update(plan);
    json["probable_outlines"] = outlines;
    std::fputs((json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n").c_str(), stdout);
    return kExitDone;
  }
  std::fputs(
      absl::StrFormat("mesh %s\nvertices: %d, triangles: %d, faces with more corners: %d\nboundary edges: %d, "
                      "non-manifold edges: %d, "
                      "triangles without area: %d\nholes: %d closed, outlines: %d, continuous: %d\n%s",
                      Printable(path), r.vertex_count, r.triangle_count, file->polygon_count, r.edges.size(),
                      r.nonmanifold_edges, r.degenerate_triangles, waves.plan().holes.size(), waves.plan().outer_rims,
                      waves.plan().continuous, absl::StrCat(PlanText(plan), OutlineHolesText(waves.plan(), outlines)))
          .c_str(),
      stdout);
  return kExitDone;
}

}  // namespace

int InspectCommand(const Args& args) {
  const auto format = FormatFromFlags(args);
  if (!format.ok()) return PrintUsageError(format.status());
  const std::string& path = args.arguments().front();
  if (const auto look = LookAt(path); absl::IsNotFound(look.status()) || (IsObjectPath(path) && !look.ok())) {
    return PrintError(IsObjectPath(path) ? look.status()
                                         : absl::NotFoundError(absl::StrCat(path, ": no such file or folder")));
  }
  auto spec = SpecFromFlags(args, kOfInspect);
  if (!spec.ok()) return PrintUsageError(spec.status());
  const bool mesh = IsSingleMesh(path);
  const auto is_given = [&args](const char* flag) { return args.IsGiven(flag); };
  if (mesh && std::ranges::any_of(kOnlyForScenes, is_given)) {
    return PrintUsageError(
        absl::InvalidArgumentError(absl::StrCat("--", absl::StrJoin(kOnlyForScenes, ", --"), ": only for scenes")));
  }
  if (spec->water().empty()) spec->set_water(kFindWater);
  const absl::Status status = NamedAsFlag(CheckOptions(*spec, kOfInspect, GivenBy(args)));
  if (!status.ok()) return PrintUsageError(status);
  if (mesh && !args.IsGiven("water")) spec->set_water(kNoWater);
  const Request request{.path = path,
                        .area = spec->area(),
                        .propose_area = args.Text("propose-area"),
                        .propose_water = args.Text("propose-water"),
                        .holes = args.Text("holes"),
                        .overwrite = args.Switch("overwrite"),
                        .water = spec->water(),
                        .clear = spec->clear(),
                        .decisions = spec->decisions(),
                        .water_profile = *WaterProfileNamed(spec->water_profile()),
                        .format = *format};
  return mesh ? InspectMeshAt(request) : InspectSceneAt(request);
}

}  // namespace tilemend
