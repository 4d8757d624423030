// Geometry records to payload messages and back.
//
// Decoding checks everything that an index depends on: a payload comes over the network.
#ifndef TILEMEND_COMMON_RPC_STAGE_PAYLOADS_H_
#define TILEMEND_COMMON_RPC_STAGE_PAYLOADS_H_

#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/mesh/quality_tally.h"
#include "common/records/cell_holes.h"
#include "common/records/survey_record.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {

// Band points other than boundary vertices are rounded to the lattice, normals to float32; everything else comes back
// bit for bit. Decoding gives kInvalidArgument for a message that ToProto did not make: columns of unequal length,
// indices out of range, positions that are not finite.
v1::SurveyOutput ToProto(const SurveyRecord& record);
absl::StatusOr<SurveyRecord> FromProto(const v1::SurveyOutput& proto);

v1::CellHolesBlob ToProto(const CellHoles& holes);
absl::StatusOr<CellHoles> FromProto(const v1::CellHolesBlob& proto);

v1::RimVertices ToProto(const std::vector<RimVertex>& vertices);
absl::StatusOr<std::vector<RimVertex>> FromProto(const v1::RimVertices& proto);

// Patches over `vertices`; new points come back bit for bit. `lattice_step` is that of the CellHoles.
v1::FillOutput ToProto(const std::vector<HolePatch>& patches, const std::vector<RimVertex>& vertices,
                       double lattice_step);
absl::StatusOr<std::vector<HolePatch>> FromProto(const v1::FillOutput& proto, size_t vertex_count);

v1::QualityTally ToProto(const QualityTally& tally);
absl::StatusOr<QualityTally> FromProto(const v1::QualityTally& proto);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RPC_STAGE_PAYLOADS_H_
