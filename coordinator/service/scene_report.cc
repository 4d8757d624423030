#include "coordinator/service/scene_report.h"

#include <sys/resource.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

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

// To `digits` decimals.
double Rounded(double value, int digits) {
  const double scale = std::pow(10.0, digits);
  return std::round(value * scale) / scale;
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

std::string FailureOf(const SceneReportInput& input, int32_t hole) {
  const auto it = input.failures.find(hole);
  return it != input.failures.end() ? it->second : input.plan->holes[hole].failure;
}

Json HoleRow(const SceneReportInput& input, int32_t h) {
  const PlannedHole& hole = input.plan->holes[h];
  const std::string failure = FailureOf(input, h);
  Json row = {{"id", h}, {"cell", CellJson(hole.cell)}, {"kind", KindName(hole.kind)}};
  if (const char* type = TypeName(hole.type)) row["type"] = type;
  if (const char* single = SingleName(hole.single)) row["single"] = single;
  if (hole.kind != HoleKind::kClosed) {
    row["cluster"] = hole.cluster;
    row["layer"] = hole.layer;
  }
  row["centre"] = {Rounded(hole.centre.x(), 3), Rounded(hole.centre.y(), 3)};
  row["area_m2"] = Rounded(hole.area, 3);
  row["perimeter_m"] = Rounded(hole.perimeter, 3);
  row["boundary_vertices"] = hole.boundary_vertices;
  row["method"] = input.surface;
  row["outcome"] = failure.empty() ? "filled" : "left";
  if (!failure.empty()) row["reason"] = failure;
  if (const auto size = input.sizes.find(h); size != input.sizes.end() && failure.empty()) {
    row["new_vertices"] = size->second.first;
    row["triangles"] = size->second.second;
  }
  return row;
}

Json Borders(const Plan& plan) {
  std::map<std::string, int64_t> counts;
  Json rows = Json::array();
  for (const BorderAudit& border : plan.borders) {
    ++counts[BorderName(border.kind)];
    if (border.kind == BorderKind::kExact || border.kind == BorderKind::kOpen) continue;
    rows.push_back({{"cells", {CellJson(border.a), CellJson(border.b)}},
                    {"kind", BorderName(border.kind)},
                    {"offset_m", Rounded(border.offset, 6)}});
  }
  Json result;
  for (const char* kind : {"exact", "near", "overlap", "gap", "open"}) result[kind] = counts[kind];
  result["inexact"] = rows;
  return result;
}

int64_t PeakRssBytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<int64_t>(usage.ru_maxrss) * 1024;
}

}  // namespace

const char* TypeName(HoleType type) { return type == HoleType::kNone ? nullptr : kTypes[static_cast<int>(type) - 1]; }

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

std::vector<LeftOpen> LeftOf(const SceneReportInput& input) {
  std::vector<LeftOpen> left = input.plan->left;
  for (const auto& [hole, reason] : input.failures) {
    const PlannedHole& planned = input.plan->holes[hole];
    left.push_back({planned.cell, reason, hole, planned.boundary_vertices});
  }
  return left;
}

std::string SceneReport(const SceneReportInput& input) {
  const Plan& plan = *input.plan;
  Json holes = EmptyCounts(), filled = EmptyCounts(), rows = Json::array(), single, left = Json::array();
  for (const char* name : {"crack", "dislocation", "annular", "island", "simple"}) single[name] = 0;
  for (size_t h = 0; h < plan.holes.size(); ++h) {
    const auto id = static_cast<int32_t>(h);
    Count(plan.holes[h], holes);
    if (FailureOf(input, id).empty()) Count(plan.holes[h], filled);
    if (const char* name = SingleName(plan.holes[h].single)) single[name] = single[name].get<int>() + 1;
    rows.push_back(HoleRow(input, id));
  }
  for (const LeftOpen& l : LeftOf(input)) {
    Json row = {{"cell", CellJson(l.cell)}, {"reason", l.reason}};
    if (l.hole >= 0) row["hole"] = l.hole;
    row["open_edges"] = l.edges;
    left.push_back(row);
  }
  Json seconds;
  for (const auto& [stage, value] : input.seconds) seconds[stage] = Rounded(value, 6);
  const Json report = {{"cells", input.cells},
                       {"clusters", plan.clusters},
                       {"layers", plan.layers},
                       {"holes", holes},
                       {"filled", filled},
                       {"single", single},
                       {"continuous", plan.continuous},
                       {"outer_rims", plan.outer_rims},
                       {"left", left},
                       {"borders", Borders(plan)},
                       {"warnings", input.warnings},
                       {"surface", input.surface},
                       {"seconds", seconds},
                       {"peak_rss_bytes", PeakRssBytes()},
                       {"per_hole", rows}};
  return report.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace tilemend
