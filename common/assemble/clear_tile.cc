#include "common/assemble/clear_tile.h"

#include <utility>

#include "common/assemble/tree_levels.h"
#include "common/codec/drop_faces.h"
#include "common/codec/face_edits.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

// Keeps faces whole: a triangle stays if another one of its face does.
void KeepWholeFaces(const std::vector<int32_t>& face_of, std::vector<int32_t>& cleared_by) {
  for (size_t first = 0; first < face_of.size();) {
    size_t last = first + 1;
    bool stays = cleared_by[first] < 0;
    for (; last < face_of.size() && face_of[last] == face_of[first]; ++last) stays = stays || cleared_by[last] < 0;
    for (size_t t = first; stays && t < last; ++t) cleared_by[t] = -1;
    first = last;
  }
}

}  // namespace

absl::StatusOr<ClearedTile> ClearTile(MeshFormat format, std::string_view bytes, std::span<const ClearArea> areas,
                                      const std::string& name) {
  if (format == MeshFormat::kTileTree) return ClearTreeLevels(bytes, areas, name);
  TILEMEND_ASSIGN_OR_RETURN(FileFaces faces, ParseFaces(format, bytes, name));
  std::vector<int32_t> cleared_by = AreasThatClear(faces.file.mesh, areas);
  KeepWholeFaces(faces.face_of, cleared_by);
  ClearedTile cleared{{}, std::move(faces.file), std::vector<int64_t>(areas.size(), 0)};
  std::vector<bool> drop;
  std::vector<Triangle> kept;
  for (size_t t = 0; t < cleared_by.size(); ++t) {
    drop.push_back(cleared_by[t] >= 0);
    if (cleared_by[t] < 0) {
      kept.push_back(cleared.file.mesh.triangles[t]);
    } else {
      ++cleared.triangles[static_cast<size_t>(cleared_by[t])];
    }
  }
  if (kept.size() == drop.size()) {
    cleared.bytes = bytes;
    return cleared;
  }
  cleared.file.mesh.triangles = std::move(kept);
  TILEMEND_ASSIGN_OR_RETURN(cleared.bytes, DropFaces(format, bytes, drop, name));
  return cleared;
}

}  // namespace tilemend
