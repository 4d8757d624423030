// Checks of single tiles against their scene.
#ifndef TILEMEND_COORDINATOR_REPORT_TILE_CHECKS_H_
#define TILEMEND_COORDINATOR_REPORT_TILE_CHECKS_H_

#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/grid/scene.h"
#include "common/records/survey_record.h"

namespace tilemend {

// The convex hull of a tile seen from above, for LoadScene on folders without scene.json. Errors of ReadMeshFile.
absl::StatusOr<ConvexHull> ReadTileHull(const std::string& path, const TileFrame& frame);

// The tiles of a tileset, for LoadScene on folders of 3D Tiles. Errors of ReadTilesetLayout.
absl::StatusOr<TilesetTiles> ReadTilesets(const std::string& folder, const std::string& entry, double turn);

// Where the tile of a cell may lie: in its cell or at most a quarter cell beyond it.
struct Box2 {
  Point2 lo, hi;
};
Box2 ReachOfCell(const Scene& scene, CellId cell);

// kInvalidArgument, naming the file and both extents, if `tile` of `scene`, with the survey `record`, does not lie
// within the reach of its cell.
absl::Status CheckInsideCell(const SurveyRecord& record, const Scene& scene, const SceneTile& tile);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_REPORT_TILE_CHECKS_H_
