// Which scene a GeoJSON file of holes is of.
#ifndef TILEMEND_COORDINATOR_REPORT_SCENE_MEMBER_H_
#define TILEMEND_COORDINATOR_REPORT_SCENE_MEMBER_H_

#include <nlohmann/json.hpp>
#include <string>

#include "absl/status/statusor.h"
#include "common/grid/scene.h"

namespace tilemend {

// The member of a FeatureCollection that names its scene. holes.geojson has it, and so have the files of decisions that
// the pages and the Python package make of that.
inline constexpr char kSceneMember[] = "tilemend_scene";

// Its value for `scene`:
//   name         of the scene's folder, without the folders above it
//   crs          as the scene gives it; may be empty
//   grid_corner  [x, y], metres in the CRS
//   cell_size    [x, y], metres
nlohmann::ordered_json SceneMemberOf(const Scene& scene);

// kInvalidArgument, naming both scenes and what differs, if the file with these bytes has the member, and its CRS or
// its grid is not that of the scene. The same, with the line, if the member is neither an object nor null. A warning if
// the name of the folder alone differs, as where it was renamed or mounted in a container. Else empty, also if the file
// is no JSON or does not have the member. `file` names it. Cost O(bytes); no list of the file is kept in memory.
absl::StatusOr<std::string> CheckSceneMember(const std::string& bytes, const std::string& file, const Scene& scene);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_REPORT_SCENE_MEMBER_H_
