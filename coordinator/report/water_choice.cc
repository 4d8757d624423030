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

}  // namespace tilemend
