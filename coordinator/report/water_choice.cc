#include "coordinator/report/water_choice.h"

#include "common/grid/water_areas.h"
#include "common/store/digest.h"
#include "common/util/files.h"
#include "common/util/status_macros.h"

namespace tilemend {

absl::StatusOr<WaterChoice> ReadWaterChoice(const std::string& value, double tolerance) {
  WaterChoice choice;
  choice.options.tolerance = tolerance;
  choice.options.find = value != kNoWater;
  if (value == kFindWater || value == kNoWater) return choice;
  TILEMEND_ASSIGN_OR_RETURN(const std::string text, ReadFile(value));
  TILEMEND_ASSIGN_OR_RETURN(choice.options.areas, ParseWaterAreas(text, value));
  choice.digest = Sha256Hex(text);
  return choice;
}

}  // namespace tilemend
