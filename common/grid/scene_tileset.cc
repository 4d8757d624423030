#include <cmath>
#include <filesystem>
#include <utility>

#include "absl/strings/str_format.h"
#include "common/grid/scene_sources.h"
#include "common/util/status_macros.h"

namespace tilemend {

absl::StatusOr<Scene> FindTilesetScene(const std::string& root, const BoundsReader& read_bounds) {
  TILEMEND_ASSIGN_OR_RETURN(const Box bounds, read_bounds((std::filesystem::path(root) / kTilesetFile).string()));
  Scene scene;
  scene.root = root;
  scene.found_by_name = true;
  scene.cols = scene.rows = 1;
  scene.tiles.push_back({{0, 0}, kTilesetFile});
  for (int k = 0; k < 2; ++k) {
    scene.grid.corner[k] = std::floor(bounds.lo[k]);
    scene.grid.cell_size[k] = std::fmax(1, std::ceil(bounds.hi[k]) - scene.grid.corner[k]);
  }
  scene.warnings.push_back(absl::StrFormat("%s: the tileset is one cell of %.10g x %.10g m", root,
                                           scene.grid.cell_size.x(), scene.grid.cell_size.y()));
  return scene;
}

}  // namespace tilemend
