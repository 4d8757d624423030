// Options of one mesh: of the table of options to what FillMesh takes.
#ifndef TILEMEND_CLIENT_MESH_MESH_OPTIONS_H_
#define TILEMEND_CLIENT_MESH_MESH_OPTIONS_H_

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "client/mesh/mesh_filler.h"
#include "common/options/job_options.h"
#include "tilemend/v1/job_spec.pb.h"

namespace tilemend {

// The default of `water` for one mesh: most are no terrain.
inline constexpr char kMeshWater[] = "off";

// CheckOptions of `fill`, and what only one mesh asks of options. kInvalidArgument (INVALID_SPEC) names the field.
absl::Status CheckMeshOptions(const v1::JobSpec& spec, const IsGiven& is_given);

// Reads the files of `water` and `clear`. Errors of ReadWaterChoice. `library` and `show` are the caller's.
// Precondition: CheckMeshOptions takes the spec.
absl::StatusOr<MeshFillOptions> MeshOptionsOf(const v1::JobSpec& spec);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_MESH_MESH_OPTIONS_H_
