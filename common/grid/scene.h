// Scenes: all tiles, the grid, the reconstruction area.
#ifndef TILEMEND_COMMON_GRID_SCENE_H_
#define TILEMEND_COMMON_GRID_SCENE_H_

#include <compare>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/mesh/plane_polygon.h"
#include "common/util/tile_files.h"

namespace tilemend {

// Column (x, east) and row (y, north) of a cell. Also names the squares outside the area, which have no cell.
struct CellId {
  int32_t col = 0;
  int32_t row = 0;
  auto operator<=>(const CellId&) const = default;
};

// "+003_+001", as in tile names.
std::string ToString(CellId id);

// The regular grid. Cell (c, r) is [c, c+1) x [r, r+1) times cell_size, from corner, in metres relative to the origin.
struct Grid {
  Point2 corner{0, 0};
  Point2 cell_size{0, 0};  // both > 0
};

struct SceneTile {
  CellId cell;
  std::string path;            // relative to the scene's folder; empty: the cell has no surface
  std::string output = {};     // of a cell without surface, the file that it gets; empty: one by its number
  std::string delivered = {};  // where it is written in another format (delivery_paths.h); empty: in its own
  bool added = false;          // of a cell without surface: only the area makes it a part of the scene
  TileFrame frame = {};        // of a tileset
};

struct Scene {
  std::string root;  // folder that tile paths are relative to
  std::string crs;   // as given, may be empty
  Point3 origin{0, 0, 0};
  Grid grid;
  int32_t cols = 0, rows = 0;
  bool area_known = false;       // false: found by file names only, so the rim of the area stays open
  PlanePolygon area;             // what is to be covered, inside cells too; empty: the cells
  std::string area_file;         // path of a file with the area, which is not read yet (area_choice.h); or empty
  bool found_by_name = false;    // there was no scene.json
  std::string tileset = {};      // path of the tileset that names those of the tiles; empty: none
  std::vector<SceneTile> tiles;  // every cell of the area once, sorted by (row, col)
  std::vector<std::string> warnings;
};

// Where the surface of a cell is written, relative to the output's folder: the tile's own path. For a cell without
// surface it is SceneTile::output, else tiles/Tile_+CCC_+RRR.ply; in another format SceneTile::delivered. No two cells
// of a scene that LoadScene returns have the same.
std::string OutputPath(const SceneTile& tile);

// An axis-aligned box; lo <= hi in every coordinate.
struct Box {
  Point3 lo{0, 0, 0};
  Point3 hi{0, 0, 0};
};

// The convex hull of a mesh seen from above, counter-clockwise, metres.
using ConvexHull = std::vector<Point2>;

// That of the tile at `path` (root and tile path joined) in its frame; not empty. Injected, so that the grid does not
// depend on the mesh readers. An error is passed on by LoadScene as it is and must name the file.
using HullReader = std::function<absl::StatusOr<ConvexHull>(const std::string& path, const TileFrame& frame)>;

// The tilesets in a folder of 3D Tiles that are tiles of a scene, in the order of their paths.
struct TilesetTiles {
  struct Tile {
    std::string path;  // relative to the folder
    TileFrame frame;
  };
  std::string crs;          // of the scene's plane; empty: not known
  double height = 0;        // of its origin above the ellipsoid, metres
  std::vector<Tile> tiles;  // one that is the entry itself if the entry does not name others
  std::string warning;      // why it is the entry itself, though it names others; or empty
};

// Reads the tileset `entry` of a folder. The frames of its tiles have axes that are turned by `turn` against those that
// it has by itself, radians counter-clockwise. Injected as HullReader is; an error names the file.
using TilesetReader =
    std::function<absl::StatusOr<TilesetTiles>(const std::string& folder, const std::string& entry, double turn)>;

// Reads `path`: a folder with scene.json (or the scene.json itself), or a folder of tiles found by name:
//   *_+CCC_+RRR.ply|obj (sign and digits) directly or under tiles/, or the photogrammetry layout
//   Data/Tile_+CCC_+RRR/Tile_+CCC_+RRR.obj|ply (or the only .obj or .ply in that folder) with metadata.xml (SRS,
//   SRSOrigin) beside Data.
//   a tileset of 3D Tiles (tileset.json, or the only .json file that is one): its tilesets Tile_+CCC_+RRR, or
//   Tile_pCCC_pRRR with p and m for the signs, or tilesets that lie in a grid; else the whole tileset is one cell.
// scene.json has
//   cell_size    number or [x, y]
//   cols, rows   1 to 100000
//   tiles        [{`col`, `row`, `path`: file or null}]
//   crs          optional, as are all below
//   origin       [x, y, z]
//   grid_corner  [x, y]
//   area_known   default true
//   area         a GeoJSON Polygon or MultiPolygon in scene coordinates, or a file name
// Other fields are ignored.
//
// For a scene found by name the grid is worked out from the indices and hulls of the tiles that TilesToLookAt names. A
// warning says what was found, area_known is false, and the numbering is shifted if an index is negative. If a tileset
// was cut along other axes than its own, such as those of a map, the scene has the axes of the cut: those of which the
// bounds of neighbours fit together better. `read_hull` is called for these tiles only, for each tile of a tileset
// whose names have no numbers, and for none of a scene with scene.json; then it may be empty. Errors (kNotFound,
// kInvalidArgument) name the file and the place. Faults are bad JSON, cell_size <= 0 or beyond kMostMetres, a tile
// listed twice or two tiles for one cell. Also a path that leaves the folder, a missing tile file, a format that is not
// read, a file name that is not UTF-8.
absl::StatusOr<Scene> LoadScene(const std::string& path, const HullReader& read_hull,
                                const TilesetReader& read_tileset = nullptr);

// As LoadScene of a folder whose tiles are found by their names, without reading any of them: the grid is not known,
// its cell size is 0. kNotFound if there are no such tiles, or a tileset. O(files of the folder).
absl::StatusOr<Scene> FindSceneWithoutGrid(const std::string& root);

// scene.json text for `scene`; LoadScene reads it back (all but the warnings and the root).
std::string SceneJson(const Scene& scene);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_GRID_SCENE_H_
