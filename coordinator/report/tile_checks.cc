#include "coordinator/report/tile_checks.h"

#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "common/codec/mesh_file.h"
#include "common/codec/tiles3d/tileset_layout.h"
#include "common/grid/grid_fit.h"
#include "common/grid/tile_hulls.h"
#include "common/util/status_macros.h"

namespace tilemend {
absl::StatusOr<ConvexHull> ReadTileHull(const std::string& path, const TileFrame& frame) {
  TILEMEND_ASSIGN_OR_RETURN(const MeshFile file, ReadMeshFile(path, frame));
  std::vector<Point2> points;
  points.reserve(file.mesh.points.size());
  for (const Point3& p : file.mesh.points) points.emplace_back(p.head<2>());
  return HullOf(std::move(points));
}

absl::StatusOr<TilesetTiles> ReadTilesets(const std::string& folder, const std::string& entry, double turn) {
  TILEMEND_ASSIGN_OR_RETURN(TilesetLayout layout, ReadTilesetLayout(folder, entry, turn));
  TilesetTiles result{std::move(layout.crs), layout.height, {}, std::move(layout.warning)};
  for (TilesetPlace& place : layout.tilesets) result.tiles.push_back({std::move(place.path), std::move(place.frame)});
  return result;
}

Box2 ReachOfCell(const Scene& scene, CellId cell) {
  const Grid& grid = scene.grid;
  const Point2 lo = grid.corner + Point2(cell.col * grid.cell_size.x(), cell.row * grid.cell_size.y());
  const Point2 reach = kReachBeyondCell * grid.cell_size;
  return {lo - reach, lo + grid.cell_size + reach};
}

absl::Status CheckInsideCell(const SurveyRecord& record, const Scene& scene, const SceneTile& tile) {
  const Grid& grid = scene.grid;
  const Point2 lo = grid.corner + Point2(tile.cell.col * grid.cell_size.x(), tile.cell.row * grid.cell_size.y());
  const Point2 hi = lo + grid.cell_size;
  const Box2 reach = ReachOfCell(scene, tile.cell);
  const bool inside = (record.lo.head<2>().array() >= reach.lo.array()).all() &&
                      (record.hi.head<2>().array() <= reach.hi.array()).all();
  if (inside) return absl::OkStatus();
  return absl::InvalidArgumentError(absl::StrFormat(
      "%s/%s: outside its cell %s: the tile spans x %.10g to %.10g, y %.10g to %.10g, the cell x %.10g to %.10g, "
      "y %.10g to %.10g; check grid_corner and cell_size in scene.json",
      scene.root, tile.path, ToString(tile.cell), record.lo.x(), record.hi.x(), record.lo.y(), record.hi.y(), lo.x(),
      hi.x(), lo.y(), hi.y()));
}

}  // namespace tilemend
