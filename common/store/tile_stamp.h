// Whether the files of a tile have changed (common/util/tile_files.h).
#ifndef TILEMEND_COMMON_STORE_TILE_STAMP_H_
#define TILEMEND_COMMON_STORE_TILE_STAMP_H_

#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "common/util/tile_files.h"

namespace tilemend {

// StampOf and HasStamp (file_stamp.h) of all files of a tile together: another file in a tree's folder is a change.
std::string StampOfTile(const std::string& path, absl::Time now);
bool TileHasStamp(const std::string& path, const std::string& stamp);

// HasFileDigest of ReadTileBytes. Errors of it.
absl::StatusOr<bool> TileHasDigest(const std::string& path, std::string_view digest, const TileFrame& frame = {});

}  // namespace tilemend

#endif  // TILEMEND_COMMON_STORE_TILE_STAMP_H_
