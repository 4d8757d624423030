#include "client/compared_tile.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "client/converted_tile.h"
#include "common/grid/delivery_paths.h"
#include "common/util/folders.h"
#include "common/util/object_store.h"
#include "common/util/status_macros.h"

namespace tilemend {

absl::StatusOr<ComparedTile> ReadComparedTile(const Scene& scene, const SceneTile& tile, const std::string& out) {
  const std::string path = OutputPath(tile);
  ComparedTile pair;
  ExactPositions exact;
  if (!tile.path.empty() && tile.delivered.empty()) {
    TILEMEND_ASSIGN_OR_RETURN(pair.before, ReadCheckedTile(scene.root, tile.path, tile.frame));
  } else if (!tile.path.empty()) {
    TILEMEND_ASSIGN_OR_RETURN(ConvertedTile converted, ConvertTile(scene, tile, out));
    pair.before = std::move(converted.tile);
    pair.beside = std::move(converted.beside);
    exact = std::move(converted.exact);
    Restore(exact, pair.before);
  }
  if (KindOf(absl::StrCat(out, "/", path)) != PathKind::kFile) return pair;
  auto after = ReadCheckedTile(out, path, OutputFrame(tile));
  if (IsStoreError(out, after.status())) return after.status();
  if (!after.ok()) {
    pair.damage = std::string(after.status().message());
    return pair;
  }
  Restore(exact, *after);
  pair.after = *std::move(after);
  return pair;
}

}  // namespace tilemend
