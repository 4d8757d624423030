// Surface that is taken out of tiles, to payload messages and back, and the tiles without it.
#ifndef TILEMEND_COMMON_RPC_CLEAR_PAYLOADS_H_
#define TILEMEND_COMMON_RPC_CLEAR_PAYLOADS_H_

#include <string_view>

#include "absl/status/statusor.h"
#include "common/assemble/clear_tile.h"
#include "common/mesh/clear_area.h"
#include "common/mesh/height_tally.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {

// Decoding gives kInvalidArgument for rings of fewer than three points or with other counts than there are points, for
// segments without both ends, and for positions that are no numbers.
v1::ClearArea ToProto(const ClearArea& area);
absl::StatusOr<ClearArea> FromProto(const v1::ClearArea& proto);

// Decoding gives kInvalidArgument for columns of unequal length, bins that do not rise and areas that are not positive.
v1::HeightTally ToProto(const HeightTally& tally);
absl::StatusOr<HeightTally> FromProto(const v1::HeightTally& proto);

// The tile whose file is `bytes`, without what its TileRef says is taken out; the `triangles` are those of each of
// TileRef.clear. Errors as the other ClearTile; kInvalidArgument for areas that cannot be decoded.
absl::StatusOr<ClearedTile> ClearTile(const v1::TileRef& tile, std::string_view bytes);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RPC_CLEAR_PAYLOADS_H_
