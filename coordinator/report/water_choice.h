// The value of --water.
#ifndef TILEMEND_COORDINATOR_REPORT_WATER_CHOICE_H_
#define TILEMEND_COORDINATOR_REPORT_WATER_CHOICE_H_

#include <string>

#include "absl/status/statusor.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// Values that are no file.
inline constexpr char kFindWater[] = "auto";
inline constexpr char kNoWater[] = "off";

struct WaterChoice {
  WaterOptions options;
  std::string digest;  // SHA-256 of the file, hex; empty without one
};

// kFindWater, kNoWater, or a GeoJSON file (water_areas.h) of exceptions from kFindWater. Errors of ReadFile and
// ParseWaterAreas, with the file in their text.
absl::StatusOr<WaterChoice> ReadWaterChoice(const std::string& value, double tolerance);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_REPORT_WATER_CHOICE_H_
