// The values of --water, --clear and --decisions.
#ifndef TILEMEND_COORDINATOR_REPORT_WATER_CHOICE_H_
#define TILEMEND_COORDINATOR_REPORT_WATER_CHOICE_H_

#include <map>
#include <stop_token>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/gis/vector_file.h"
#include "common/grid/scene.h"
#include "common/records/stored_record.h"
#include "coordinator/plan/types/plan_types.h"

namespace tilemend {

// Values that are no file.
inline constexpr char kFindWater[] = "auto";
inline constexpr char kNoWater[] = "off";

// Metres: no shore is that high, so a level farther from all of the surface is a slip, or of another origin.
inline constexpr double kMostLevelOff = 100;

struct WaterChoice {
  WaterOptions options;
  std::string digest;                 // SHA-256 of the file and what belongs to it, hex; empty without one
  std::string clear_digest = {};      // likewise of the file of AddClearFile
  std::string decisions_digest = {};  // and of AddDecisions
  std::string coordinates;            // what those of the file were taken for; empty without one
  std::vector<std::string> warnings;
};

// kFindWater, kNoWater, or a file of exceptions from kFindWater (common/gis/area_file.h). `frame` says where the
// scene's coordinates lie. Errors of ReadAreaFile and ParseWaterFile, with the file in their text.
absl::StatusOr<WaterChoice> ReadWaterChoice(const std::string& value, const SceneFrame& frame,
                                            const std::stop_token& stop = {});

// The value of --clear: adds the areas of the file, all with `clear`, behind those that are there. "" adds none. Errors
// as above.
absl::Status AddClearFile(const std::string& value, const SceneFrame& frame, WaterChoice& choice,
                          const std::stop_token& stop = {});

// The value of --decisions: adds the decisions of the file behind the areas that are there. "" adds none. Errors of
// ReadAreaFile, CheckSceneMember and ParseDecisionFile, with the file in their text.
absl::Status AddDecisions(const std::string& value, const Scene& scene, WaterChoice& choice,
                          const std::stop_token& stop = {});

// kInvalidArgument, naming the first, if an area has a level more than kMostLevelOff above or below all of the surface:
// what the records of the cells tell of it.
absl::Status CheckLevels(const std::vector<WaterArea>& areas, const std::map<CellId, StoredRecord>& records);

// Takes polygons with `clear` out of the choice, with a warning, if they lie outside the area to be covered. What they
// took out would not be filled again. Returns kInvalidArgument for one that lies across the area's edge. An empty area
// is everywhere.
absl::Status KeepClearInside(const PlanePolygon& area, WaterChoice& choice);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_REPORT_WATER_CHOICE_H_
