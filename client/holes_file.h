// The file of `tilemend inspect --holes`.
#ifndef TILEMEND_CLIENT_HOLES_FILE_H_
#define TILEMEND_CLIENT_HOLES_FILE_H_

#include <string>

#include "absl/status/status.h"
#include "coordinator/waves/scene_waves.h"

namespace tilemend {

// The holes of a plan as HolesGeoJson has them (coordinator/report/scene_geojson.h). The `outcome` is "to fill" or
// "left", with the reason; filling may find some more that stay open. There is no `method` yet.
std::string PlannedHolesGeoJson(const SceneWaves& waves);

// Writes that to `path`, and says on stderr how many would be filled; "" writes nothing. Errors of WriteFileAtomically.
absl::Status WriteHoles(const std::string& path, const SceneWaves& waves);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_HOLES_FILE_H_
