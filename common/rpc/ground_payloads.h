// Ground rasters, and ground at rims, to payload messages and back.
#ifndef TILEMEND_COMMON_RPC_GROUND_PAYLOADS_H_
#define TILEMEND_COMMON_RPC_GROUND_PAYLOADS_H_

#include "absl/status/statusor.h"
#include "common/records/ground_raster.h"
#include "common/records/rim_ground.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {

// Heights are rounded to a step: 2^-6 m, or the finest coarser power of two of which the raster's range has at most
// 65,504.
v1::GroundRasterBlob ToProto(const GroundRaster& raster);

// kInvalidArgument for a message that ToProto did not make.
absl::StatusOr<GroundRaster> FromProto(const v1::GroundRasterBlob& proto);

v1::GroundOutput ToProto(const RimGround& rim);

// kInvalidArgument for a message that ToProto did not make of so many vertices.
absl::StatusOr<RimGround> FromProto(const v1::GroundOutput& proto, int vertices);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RPC_GROUND_PAYLOADS_H_
