#include "coordinator/report/water_choice.h"

#include <utility>

#include "common/gis/area_file.h"
#include "common/store/digest.h"
#include "common/util/status_macros.h"

namespace tilemend {

absl::StatusOr<WaterChoice> ReadWaterChoice(const std::string& value, const SceneFrame& frame) {
  WaterChoice choice;
  choice.options.find = value != kNoWater;
  if (value == kFindWater || value == kNoWater) return choice;
  TILEMEND_ASSIGN_OR_RETURN(const VectorBytes bytes, ReadAreaFile(value));
  TILEMEND_ASSIGN_OR_RETURN(WaterFile file, ParseWaterFile(bytes, value, frame));
  choice.options.areas = std::move(file.areas);
  choice.coordinates = std::move(file.coordinates);
  choice.warnings = std::move(file.warnings);
  choice.digest = Sha256Hex(ContentOf(bytes));
  return choice;
}

absl::Status AddClearFile(const std::string& value, const SceneFrame& frame, WaterChoice& choice) {
  if (value.empty()) return absl::OkStatus();
  TILEMEND_ASSIGN_OR_RETURN(const VectorBytes bytes, ReadAreaFile(value));
  TILEMEND_ASSIGN_OR_RETURN(WaterFile file, ParseWaterFile(bytes, value, frame));
  for (WaterArea& area : file.areas) {
    if (!area.clear) TILEMEND_RETURN_IF_ERROR(CheckClear(value, area, file.warnings));
    area.clear = true;
    choice.options.areas.push_back(std::move(area));
  }
  for (std::string& warning : file.warnings) choice.warnings.push_back(std::move(warning));
  choice.clear_digest = Sha256Hex(ContentOf(bytes));
  return absl::OkStatus();
}

}  // namespace tilemend
