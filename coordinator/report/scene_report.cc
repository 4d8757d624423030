#include "coordinator/report/scene_report.h"

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "absl/strings/str_join.h"
#include "common/records/filler.h"
#include "common/util/text.h"
#include "common/util/version.h"
#include "coordinator/report/cleared_report.h"
#include "coordinator/report/hole_evidence.h"
#include "coordinator/report/left_open.h"
#include "coordinator/report/look_at.h"
#include "coordinator/report/plan_warnings.h"
#include "coordinator/report/review_queue.h"
#include "coordinator/report/rim_heights.h"
#include "coordinator/report/rounded.h"
#include "coordinator/report/water_rows.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

constexpr size_t kMostNamed = 10;  // holes in a warning
constexpr std::array<const char*, 4> kTypes = {"A", "B", "C", "D"};

const char* SingleName(SingleType type) {
  switch (type) {
    case SingleType::kCrack:
      return "crack";
    case SingleType::kDislocation:
      return "dislocation";
    case SingleType::kAnnular:
      return "annular";
    case SingleType::kIsland:
      return "island";
    case SingleType::kSimple:
      return "simple";
    default:
      return nullptr;
  }
}

Json EmptyCounts() {
  Json types;
  for (const char* t : kTypes) types[t] = 0;
  return {{"closed", 0}, {"I", types}, {"II", types}};
}

void Count(const PlannedHole& hole, Json& counts) {
  if (hole.kind == HoleKind::kClosed) {
    counts["closed"] = counts["closed"].get<int>() + 1;
  } else if (const char* type = TypeName(hole.type)) {
    Json& n = counts[KindName(hole.kind)][type];
    n = n.get<int>() + 1;
  }
}

Json CellJson(CellId cell) { return Json::array({cell.col, cell.row}); }

// Where a hole is, and how large: to the millimetre, or if it is small to a thousandth of its perimeter.
void AddMeasures(const Plan& plan, const PlannedHole& hole, Json& row) {
  const double power = hole.perimeter > 0 ? -std::floor(std::log10(hole.perimeter)) : 0;
  const int smaller = static_cast<int>(std::clamp(power, 0.0, 100.0)), digits = 3 + smaller;  // scales stay finite
  row["centre"] = {Rounded(hole.centre.x(), digits), Rounded(hole.centre.y(), digits)};
  if (!plan.upright && !hole.segments.empty()) row["centre"].push_back(Rounded(RimHeight(plan, hole), digits));
  row["area_m2"] = IsAreaKnown(hole) ? Json(Rounded(hole.area, digits + smaller)) : Json();
  row["perimeter_m"] = Rounded(hole.perimeter, digits);
}

Json HoleRow(const SceneReportInput& input, int32_t h, const std::vector<ReviewedGroup>& groups) {
  const PlannedHole& hole = input.plan->holes[h];
  const std::string failure = FailureOf(input, h);
  Json row = {{"id", h}, {"cell", CellJson(hole.cell)}, {"kind", KindName(hole.kind)}};
  if (const char* type = TypeName(hole.type)) row["type"] = type;
  if (const char* single = SingleName(hole.single)) row["single"] = single;
  if (hole.continuous) row["continuous"] = true;
  if (hole.kind != HoleKind::kClosed) {
    row["cluster"] = hole.cluster;
    row["layer"] = hole.layer;
  }
  AddMeasures(*input.plan, hole, row);
  row["boundary_vertices"] = hole.boundary_vertices;
  if (hole.water >= 0) row["level_m"] = LevelJson(input.plan->water[hole.water]);
  if (hole.evidence >= 0) row["water"] = HoleEvidenceJson(input.plan->evidence[hole.evidence]);
  if (hole.evidence >= 0) row["doubt_m3"] = Rounded(groups[hole.evidence].doubt * hole.area, 3);
  if (const char* decision = DecisionOn(*input.plan, h)) row["decision"] = decision;
  row["outcome"] = OutcomeOf(failure);
  if (!failure.empty()) row["reason"] = failure;
  if (!failure.empty() && input.plan->upright && !hole.segments.empty()) {
    row["rim_height_m"] = Rounded(RimHeight(*input.plan, hole), kMillimetres);
  }
  if (failure.empty() && input.plan->upright) row["rim_heights_m"] = RimHeightsJson(*input.plan, hole);
  if (const auto size = input.outcome.sizes.find(h); size != input.outcome.sizes.end() && failure.empty()) {
    row["method"] = MethodOf(*input.plan, hole, size->second.way);
    if (hole.water >= 0 && size->second.way == FillWay::kFoldsCut) row["folds_cut"] = true;
    if (size->second.loop_cuts > 0) row["loop_cuts"] = size->second.loop_cuts;
    if (size->second.creases > 0) row["creases"] = size->second.creases;
    if (size->second.rim_is_crossed) row["rim_crossed"] = true;
    if (size->second.crossings > 0) row["crossings"] = size->second.crossings;
    row["new_vertices"] = size->second.new_vertices;
    row["triangles"] = size->second.triangles;
    if (!input.plan->colours.empty()) {
      const FillColour& colour = input.plan->colours[static_cast<size_t>(h)];
      row["colour"] = ColourText(colour.colour);
      row["material"] = MaterialName(colour);
    }
  }
  return row;
}

// The tensions that were put to a test.
Json Tensions(const SceneReportInput& input) {
  Json rows = Json::array();
  const auto add = [&](const char* what, const std::map<int32_t, HoldOut>& choices) {
    for (const auto& [id, choice] : choices) {
      if (choice.blocks == 0 && !choice.walls.is_told()) continue;
      Json row = {{what, id}, {"tension", Rounded(choice.tension, 9)}, {"blocks", choice.blocks}};
      if (choice.blocks > 0) {
        row["hold_out_error_m"] = Rounded(choice.error, 4);
        row["hold_out_error_at_start_m"] = Rounded(choice.error_at_start, 4);
      }
      if (choice.walls.is_told()) row["steepness"] = Rounded(choice.walls.steepness, 3);
      rows.push_back(std::move(row));
    }
  };
  add("cluster", input.outcome.of_clusters);
  add("hole", input.outcome.of_holes);
  return rows;
}

Json GapJson(const SurfaceGap& gap) {
  return {{"median", Rounded(gap.median, 4)},
          {"ninth_decile", Rounded(gap.ninth_decile, 4)},
          {"percentile_99", Rounded(gap.percentile_99, 4)},
          {"places", gap.places}};
}

Json Borders(const Plan& plan, const SceneOutcome& outcome) {
  std::map<std::string, int64_t> counts;
  Json rows = Json::array();
  for (const BorderAudit& border : plan.borders) {
    ++counts[BorderName(border.kind)];
    if (border.kind == BorderKind::kExact || border.kind == BorderKind::kOpen) continue;
    Json row = {{"cells", {CellJson(border.a), CellJson(border.b)}},
                {"kind", BorderName(border.kind)},
                {"offset_m", Rounded(border.offset, 6)},
                {"margins_m", {Rounded(border.margins[0], 6), Rounded(border.margins[1], 6)}}};
    if (border.apart.places > 0) row["apart_m"] = GapJson(border.apart);
    const auto fill = outcome.fill_gaps.find({border.a, border.b});
    if (fill != outcome.fill_gaps.end()) row["fill_apart_m"] = GapJson(fill->second);
    rows.push_back(std::move(row));
  }
  Json result;
  for (const char* kind : {"exact", "near", "overlap", "gap", "open"}) result[kind] = counts[kind];
  result["inexact"] = rows;
  if (plan.remarks.piece_reach > 0) result["pieces_m"] = Rounded(plan.remarks.piece_reach, 4);
  return result;
}

Json QualityJson(const QualityTally& quality) {
  Json json = {{"triangles", quality.triangles}};
  if (quality.triangles > 0) {
    json["least"] = Rounded(quality.least, 4);
    json["mean"] = Rounded(quality.Mean(), 4);
    json["fifth_percentile"] = Rounded(quality.Quantile(0.05), 4);
  }
  json["poor"] = quality.poor;
  json["poor_forced_by_rim"] = quality.poor_forced;
  return json;
}

// What is told of the holes: how many of each kind, and one row for each.
struct HoleTables {
  Json found = EmptyCounts();
  Json filled = EmptyCounts();
  Json single;
  Json rows = Json::array();
};

HoleTables TablesOf(const SceneReportInput& input) {
  HoleTables tables;
  for (const char* name : {"crack", "dislocation", "annular", "island", "simple"}) tables.single[name] = 0;
  const std::vector<PlannedHole>& holes = input.plan->holes;
  const std::vector<ReviewedGroup> groups = ReviewedGroups(input);
  for (size_t h = 0; h < holes.size(); ++h) {
    const auto id = static_cast<int32_t>(h);
    Count(holes[h], tables.found);
    if (FailureOf(input, id).empty()) Count(holes[h], tables.filled);
    if (const char* name = SingleName(holes[h].single)) tables.single[name] = tables.single[name].get<int>() + 1;
    tables.rows.push_back(HoleRow(input, id, groups));
  }
  return tables;
}

Json LeftRows(const std::vector<LeftOpen>& left) {
  Json rows = Json::array();
  for (const LeftOpen& l : left) {
    if (!l.is_hole) continue;
    Json row = {{"cell", CellJson(l.cell)}, {"reason", l.reason}};
    if (l.hole >= 0) row["hole"] = l.hole;
    row["open_edges"] = l.edges;
    if (l.at) row["at"] = {l.at->x(), l.at->y(), l.at->z()};
    rows.push_back(row);
  }
  return rows;
}

// What stays open by right, by what it is.
Json NotHoles(const std::vector<LeftOpen>& left) {
  std::map<std::string, std::pair<int64_t, int64_t>> kinds;  // number, edges
  for (const LeftOpen& l : left) {
    if (l.is_hole) continue;
    ++kinds[l.reason].first;
    kinds[l.reason].second += l.edges;
  }
  Json rows = Json::array();
  for (const auto& [what, counts] : kinds) {
    rows.push_back({{"what", what}, {"count", counts.first}, {"open_edges", counts.second}});
  }
  return rows;
}

Json WeldJson(const WeldRecord& weld) {
  Json json = {{"welded", Json::array()}, {"split", Json::array()}, {"refused", Json::array()}};
  for (const WeldedVertex& v : weld.welded) {
    json["welded"].push_back({{"vertices", {v.vertex, v.into}}, {"distance", v.distance}});
  }
  for (const SplitEdge& s : weld.split) {
    json["split"].push_back({{"vertex", s.vertex}, {"edge", s.edge}, {"distance", s.distance}});
  }
  for (const RefusedWeld& r : weld.refused) {
    json["refused"].push_back({{"vertices", r.vertices}, {"distance", r.distance}, {"reason", r.reason}});
  }
  return json;
}

Json TasksJson(const SceneReportInput& input) {
  return {
      {"all", input.tasks}, {"taken_over", input.taken_over}, {"tiles", input.tiles}, {"tiles_kept", input.tiles_kept}};
}

Json Levels(const SceneReportInput& input) {
  Json rows = Json::array();
  for (const LevelCounts& level : input.levels) {
    rows.push_back({{"level", rows.size()},
                    {"nodes", level.nodes},
                    {"filled", level.filled},
                    {"added", level.added},
                    {"removed", level.removed}});
  }
  return rows;
}

Json Options(const SceneReportInput& input) {
  Json options = Json::object();
  for (const ReportedOption& option : input.options) {
    std::visit([&](const auto& value) { options[option.name] = value; }, option.value);
  }
  return options;
}

int64_t PeakRssBytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<int64_t>(usage.ru_maxrss) * 1024;
}

// Of cells that are filled, though less well than with all results.
std::vector<std::string> ImpairedWarnings(const SceneOutcome& outcome) {
  std::vector<std::string> warnings;
  for (const auto& [cell, what] : outcome.impaired) {
    warnings.push_back(absl::StrCat("cell ", ToString(cell), ": ", what));
  }
  std::ranges::sort(warnings);
  KeepFirst(kMostNamed, "cells whose ground or seams lack a result", warnings);
  return warnings;
}

}  // namespace

const char* TypeName(HoleType type) { return type == HoleType::kNone ? nullptr : kTypes[static_cast<int>(type) - 1]; }

const char* MethodOf(const Plan& plan, const PlannedHole& hole, FillWay way) {
  if (hole.water >= 0) return plan.water[hole.water].kind == BodyKind::kWater ? "water" : "level ground";
  switch (way) {
    case FillWay::kNone:
    case FillWay::kWater:
      break;
    case FillWay::kGround:
      return "over the ground";
    case FillWay::kOwnPlane:
      return "over its own plane";
    case FillWay::kFacingPlane:
      return "over the plane it faces";
    case FillWay::kCreases:
      return "along creases";
    case FillWay::kUnrolled:
      return "unrolled";
    case FillWay::kSpace:
      return "in space";
    case FillWay::kFoldsCut:
      return hole.kind == HoleKind::kClosed ? "folds cut off" : "over the ground, folds cut off";
    case FillWay::kBare:
      return "bare triangles";
    case FillWay::kAdvancingFrontNormal:
      return FillerName(Filler::kAdvancingFrontNormal);
    case FillWay::kAdvancingFrontCurvature:
      return FillerName(Filler::kAdvancingFrontCurvature);
    case FillWay::kAdvancingFrontPoisson:
      return FillerName(Filler::kAdvancingFrontPoisson);
    case FillWay::kSvmLaplacian:
      return FillerName(Filler::kSvmLaplacian);
    case FillWay::kMinimumArea:
      return FillerName(Filler::kMinimumArea);
  }
  return "unknown";
}

const char* KindName(HoleKind kind) {
  switch (kind) {
    case HoleKind::kClosed:
      return "closed";
    case HoleKind::kOpenI:
      return "I";
    default:
      return "II";
  }
}

const char* BorderName(BorderKind kind) {
  switch (kind) {
    case BorderKind::kExact:
      return "exact";
    case BorderKind::kNear:
      return "near";
    case BorderKind::kOverlap:
      return "overlap";
    case BorderKind::kGap:
      return "gap";
    default:
      return "open";
  }
}

// "N <what>: holes A, B and others (field)": holes by number. None if there are no holes.
std::optional<std::string> WarningOfHoles(std::vector<int32_t> holes, const char* one, const char* many,
                                          const char* field) {
  if (holes.empty()) return std::nullopt;
  const size_t all = holes.size();
  holes.resize(std::min(all, kMostNamed));
  return absl::StrCat(all, all == 1 ? one : many, all == 1 ? ": hole " : ": holes ", absl::StrJoin(holes, ", "),
                      all > holes.size() ? " and others (" : " (", field, ")");
}

// What `tilemend check` may find fault with.
void AddCrossingWarnings(const SceneOutcome& outcome, std::vector<std::string>& warnings) {
  std::vector<int32_t> by_rim, others;
  for (const auto& [hole, size] : outcome.sizes) {
    if (size.rim_is_crossed) by_rim.push_back(hole);
    if (size.crossings > 0) others.push_back(hole);
  }
  for (const auto& warning :
       {WarningOfHoles(std::move(by_rim), " patch crosses the surface, which passes through the boundary there",
                       " patches cross the surface, which passes through the boundary there", "rim_crossed"),
        WarningOfHoles(
            std::move(others),
            " patch crosses itself or the surface beside it; `tilemend check` lists where, as faults or crossed_rims",
            " patches cross themselves or the surface beside them; `tilemend check` lists where, as faults or "
            "crossed_rims",
            "crossings")}) {
    if (warning) warnings.push_back(*warning);
  }
}

std::vector<std::string> WarningsOf(const SceneReportInput& input) {
  std::vector<std::string> warnings = input.warnings;
  for (std::string& warning : PlanWarnings(*input.plan)) warnings.push_back(std::move(warning));
  for (std::string& warning : ClearedWarnings(input.outcome.cleared)) warnings.push_back(std::move(warning));
  for (std::string& warning : ImpairedWarnings(input.outcome)) warnings.push_back(std::move(warning));
  int64_t holes = 0, edges = 0;
  for (const auto& [hole, size] : input.outcome.sizes) {
    holes += size.creases > 0 ? 1 : 0;
    edges += size.creases;
  }
  if (holes > 0) {
    const char* fold = holes == 1 ? "patch folds" : "patches fold";
    warnings.push_back(absl::StrFormat("%d %s back, at %d edges (creases)", holes, fold, edges));
  }
  AddCrossingWarnings(input.outcome, warnings);
  return warnings;
}

std::string SceneReport(const SceneReportInput& input) {
  const Plan& plan = *input.plan;
  HoleTables tables = TablesOf(input);
  const std::vector<LeftOpen> left = LeftOf(input);
  Json seconds;
  for (const auto& [stage, value] : input.seconds) seconds[stage] = Rounded(value, 6);
  Json report = {{"version", Version()},
                 {"date", input.date},
                 {"scene", input.scene},
                 {"options", Options(input)},
                 {"files", input.files},
                 {"warnings", WarningsOf(input)},
                 {"cells", input.cells},
                 {"clusters", plan.clusters},
                 {"layers", plan.layers},
                 {"holes", tables.found},
                 {"filled", tables.filled},
                 {"single", tables.single},
                 {"continuous", plan.continuous},
                 {"outer_rims", plan.outer_rims},
                 {"water", WaterRows(input)},
                 {"water_areas", WaterAreaRows(plan)},
                 {"look_at", LookAtJson(input)},
                 {"review", ReviewJson(input)},
                 {"cleared", ClearedJson(input.outcome.cleared, input.outcome.chosen)},
                 {"levels", Levels(input)},
                 {"left", LeftRows(left)},
                 {"not_holes", NotHoles(left)},
                 {"quality", QualityJson(input.outcome.Quality())},
                 {"borders", Borders(plan, input.outcome)},
                 {"tension", Tensions(input)},
                 {"tasks", TasksJson(input)},
                 {"seconds", seconds},
                 {"peak_rss_bytes", PeakRssBytes()}};
  report["per_hole"] = std::move(tables.rows);  // kilobytes a hole, which a list would copy
  if (!input.key.empty()) report["key"] = input.key;
  if (input.weld) report["weld"] = WeldJson(*input.weld);
  return report.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace tilemend
