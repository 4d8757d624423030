#include "client/acceptance_input.h"

#include "absl/strings/str_cat.h"
#include "client/unfinished.h"
#include "common/grid/cell_choice.h"
#include "common/grid/delivery_paths.h"
#include "common/grid/scene_place.h"
#include "common/util/files.h"
#include "common/util/real_path.h"
#include "common/util/status_macros.h"
#include "common/util/tile_files.h"
#include "coordinator/report/area_choice.h"
#include "coordinator/report/json_access.h"
#include "coordinator/report/shallow_json.h"
#include "coordinator/report/tile_checks.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

// Where the finest level of detail alone was written.
void KeepFinest(std::vector<LevelCounts>& levels) {
  if (levels.empty()) return;
  LevelCounts finest = levels.back();
  // Where a coarser level has no finer one, its triangles are the finest.
  finest.removed = 0;
  for (const LevelCounts& level : levels) finest.removed += level.removed;
  levels = {finest};
}

// That the output is of another scene, which may also be the same one under another path.
void WarnOfOtherScene(const std::string& in, const std::string& report_path, const std::string& reported,
                      std::vector<std::string>& warnings) {
  if (reported.empty() || ScenePlaceOf(reported) == ScenePlaceOf(in)) return;
  const auto id = IdOf(in);
  if (id && id == IdOf(reported)) return;
  warnings.push_back(absl::StrCat(report_path, ": the output was made from the scene ", reported,
                                  ", and is compared with ", in, "; if that is another scene, give the first"));
}

}  // namespace

absl::StatusOr<AcceptanceInput> ReadAcceptanceInput(const std::string& in, const std::string& out,
                                                    std::vector<std::string>& warnings) {
  const std::string report_path = absl::StrCat(out, "/report.json");
  TILEMEND_RETURN_IF_ERROR(CheckHasReport(out, in));
  TILEMEND_ASSIGN_OR_RETURN(const std::string text, ReadFile(report_path));
  AcceptanceInput input;
  input.out = out;
  input.report = ParseShallow(text);
  if (!input.report.is_object() || !input.report.contains("cells")) {
    return absl::InvalidArgumentError(absl::StrCat(report_path, ": not a report (expected an object with cells)"));
  }
  WarnOfOtherScene(in, report_path, Text(Member(input.report, "scene")), warnings);
  TILEMEND_ASSIGN_OR_RETURN(input.scene, LoadScene(in, ReadTileHull, ReadTilesets));
  const Json& options = Member(input.report, "options");
  const absl::Status area = ApplyAreaChoice(Text(Member(options, "area")), input.scene).status();
  input.has_area = area.ok();
  if (!area.ok()) warnings.push_back(absl::StrCat(std::string(area.message()), ": checked without the area"));
  // After the area, which may add cells.
  TILEMEND_RETURN_IF_ERROR(SetDeliveryPaths(Text(Member(options, "output-format")), input.scene));
  if (IsDelivered(input.scene)) input.format = Text(Member(options, "output-format"));
  TILEMEND_ASSIGN_OR_RETURN(input.chosen, ChooseCells(Text(Member(options, "cells")), input.scene));
  return input;
}

ReportedOutput ReportedOf(const AcceptanceInput& input) {
  ReportedOutput reported = ReadReported(input.report);
  if (!input.format.empty() && !HasLevelsOfDetail(input.format)) KeepFinest(reported.levels);
  const auto text = ReadFile(absl::StrCat(input.out, "/holes.geojson"));
  if (text.ok()) AddRims(ParseShallow(*text), input.scene.origin.head<2>(), reported);
  return reported;
}

}  // namespace tilemend
