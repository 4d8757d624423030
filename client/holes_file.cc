#include "client/holes_file.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "absl/strings/str_cat.h"
#include "client/output.h"
#include "common/util/files.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"
#include "coordinator/report/scene_geojson.h"

namespace tilemend {
namespace {

constexpr char kToFill[] = "to fill";

}  // namespace

std::string PlannedHolesGeoJson(const SceneWaves& waves) {
  SceneReportInput input;
  input.plan = &waves.plan();
  auto json = nlohmann::ordered_json::parse(HolesGeoJson(input, waves.scene()));
  for (auto& feature : json["features"]) {
    auto& properties = feature["properties"];
    properties.erase("method");
    if (properties["outcome"] == "filled") properties["outcome"] = kToFill;
  }
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

absl::Status WriteHoles(const std::string& path, const SceneWaves& waves) {
  if (path.empty()) return absl::OkStatus();
  TILEMEND_RETURN_IF_ERROR(WriteFileAtomically(path, PlannedHolesGeoJson(waves)));
  size_t to_fill = 0;
  for (const PlannedHole& hole : waves.plan().holes) to_fill += hole.failure.empty() ? 1 : 0;
  std::fprintf(stderr, "%s: %s to fill, %zu that stay open\n", Printable(path).c_str(),
               Counted(to_fill, "hole").c_str(), waves.plan().holes.size() - to_fill);
  return absl::OkStatus();
}

}  // namespace tilemend
