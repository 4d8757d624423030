#include "common/store/tile_stamp.h"

#include <vector>

#include "absl/strings/str_cat.h"
#include "common/store/digest.h"
#include "common/store/file_stamp.h"
#include "common/store/fingerprint.h"
#include "common/util/status_macros.h"

namespace tilemend {

std::string StampOfTile(const std::string& path, absl::Time now) {
  if (!IsTileTree(path)) return StampOf(path, now);
  const auto names = FilesOfTile(path);
  std::string stamps;
  for (const std::string& name : names.value_or(std::vector<std::string>{})) {
    const std::string stamp = StampOf(FileBesideTile(path, name), now);
    if (stamp.empty()) return "";
    absl::StrAppend(&stamps, name, "\n", stamp, "\n");
  }
  return stamps.empty() ? "" : FileDigest(stamps);
}

bool TileHasStamp(const std::string& path, const std::string& stamp) {
  if (!IsTileTree(path)) return HasStamp(path, stamp);
  return !stamp.empty() && StampOfTile(path, absl::InfiniteFuture()) == stamp;
}

absl::StatusOr<bool> TileHasDigest(const std::string& path, std::string_view digest, const TileFrame& frame) {
  if (!IsTileTree(path)) return FileHasDigest(path, digest);
  TILEMEND_ASSIGN_OR_RETURN(const std::string bytes, ReadTileBytes(path, frame));
  return HasFileDigest(bytes, digest);
}

}  // namespace tilemend
