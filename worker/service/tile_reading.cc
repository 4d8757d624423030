#include "worker/service/tile_reading.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "common/rpc/clear_payloads.h"
#include "common/store/digest.h"
#include "common/store/fingerprint.h"
#include "common/store/tile_stamp.h"
#include "common/util/cores.h"
#include "common/util/status_macros.h"
#include "common/util/tile_files.h"

namespace tilemend {

std::string PathOf(const v1::TileRef& tile) { return absl::StrCat(tile.root(), "/", tile.path()); }

absl::StatusOr<std::string> ReadTile(const v1::TileRef& tile) {
  const LentCore lent;
  return ReadTileBytes(PathOf(tile), {tile.frame().begin(), tile.frame().end()});
}

absl::StatusOr<std::string> ReadSurveyed(const v1::TileRef& tile, const std::string& stamp) {
  const std::string path = PathOf(tile);
  TILEMEND_ASSIGN_OR_RETURN(std::string bytes, ReadTile(tile));
  return TileHasStamp(path, stamp) || HasFileDigest(bytes, tile.digest())
             ? absl::StatusOr<std::string>(std::move(bytes))
             : ChangedInJob(path);
}

absl::StatusOr<MeshFile> MeshOf(const v1::TileRef& tile, const std::string& bytes) {
  if (!tile.clear().empty()) {
    TILEMEND_ASSIGN_OR_RETURN(ClearedTile cleared, ClearTile(tile, bytes));
    return std::move(cleared.file);
  }
  const std::string path = PathOf(tile);
  TILEMEND_ASSIGN_OR_RETURN(const MeshFormat format, MeshFormatOf(path));
  return ParseMesh(format, bytes, path);
}

}  // namespace tilemend
