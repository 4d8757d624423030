#include "coordinator/jobs/checked_files.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "common/store/fingerprint.h"
#include "common/store/tile_stamp.h"
#include "common/util/folders.h"
#include "common/util/tile_files.h"

namespace tilemend {

std::string TilePath(const v1::TileRef& tile) { return absl::StrCat(tile.root(), "/", tile.path()); }

absl::StatusOr<int64_t> TileSize(const v1::TileRef& tile) {
  const auto size = SizeOfTile(TilePath(tile), {tile.frame().begin(), tile.frame().end()});
  return size.ok() ? size : absl::StatusOr<int64_t>(absl::UnavailableError(size.status().message()));
}

absl::StatusOr<std::string> BytesOf(const v1::TileRef& tile) {
  auto bytes = ReadTileBytes(TilePath(tile), {tile.frame().begin(), tile.frame().end()});
  return bytes.ok() ? std::move(bytes) : absl::StatusOr<std::string>(absl::UnavailableError(bytes.status().message()));
}

absl::Status CheckTileFile(const v1::TileRef& tile, const std::string& digest, const absl::Status& otherwise) {
  const auto same = TileHasDigest(TilePath(tile), digest, {tile.frame().begin(), tile.frame().end()});
  if (!same.ok()) return absl::UnavailableError(same.status().message());
  return *same ? absl::OkStatus() : otherwise;
}

absl::StatusOr<int64_t> SizeOfFile(const std::string& path) {
  const auto look = LookAt(path);
  if (!look.ok()) return absl::UnavailableError(look.status().message());
  return look->size;
}

absl::Status CheckFile(const std::string& path, const std::string& digest, const absl::Status& otherwise) {
  const auto same = FileHasDigest(path, digest);
  if (!same.ok()) return absl::UnavailableError(same.status().message());
  return *same ? absl::OkStatus() : otherwise;
}

absl::Status Changed(const std::string& path) {
  return absl::UnavailableError(absl::StrCat(path, ": has just been changed, or the worker has another file there"));
}

}  // namespace tilemend
