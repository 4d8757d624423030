// What `tilemend inspect --propose-water` writes.
#ifndef TILEMEND_CLIENT_WATER_PROPOSAL_H_
#define TILEMEND_CLIENT_WATER_PROPOSAL_H_

#include <nlohmann/json.hpp>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "coordinator/waves/scene_waves.h"

namespace tilemend {

// Whether a file can be written there. Returns kInvalidArgument for a name that ends neither in .gpkg nor in .geojson.
// Else as CheckOutputFile (output_file.h).
absl::Status CheckWaterProposal(const std::string& path, bool overwrite);

// Writes polygons for --water: the waters that the plan fills, and surface that looks like water (water_surfaces.h).
// Returns the properties of each. Precondition: the waves are planned. Errors of CheckWaterProposal, AskGdal and
// WriteFileAtomically.
absl::StatusOr<nlohmann::ordered_json> WriteWaterProposal(const std::string& path, bool overwrite,
                                                          const SceneWaves& waves);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_WATER_PROPOSAL_H_
