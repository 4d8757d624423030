// The value of --area.
#ifndef TILEMEND_COORDINATOR_REPORT_AREA_CHOICE_H_
#define TILEMEND_COORDINATOR_REPORT_AREA_CHOICE_H_

#include <stop_token>
#include <string>

#include "absl/status/statusor.h"
#include "common/grid/scene.h"

namespace tilemend {

// Warns of a CRS that nobody knows. What is filled does not depend on it, but files for a GIS name it.
void CheckCrs(Scene& scene, const std::stop_token& stop = {});

// Gives the scene the area of the file `value` (common/gis/area_file.h); with "" the one that scene.json names, if any.
// Returns the SHA-256 of the file and what belongs to it, hex; "" if none was read. Errors of ReadAreaFile,
// ParseAreaFile and CoverArea, with the file in their text.
absl::StatusOr<std::string> ApplyAreaChoice(const std::string& value, Scene& scene, const std::stop_token& stop = {});

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_REPORT_AREA_CHOICE_H_
