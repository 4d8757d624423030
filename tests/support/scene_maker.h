// Made scenes with holes and a known surface, for tests, benchmarks and the demonstration.
//
// The terrain is a smooth function of x and y; its vertices form a jittered grid. Unless tiles overlap, a vertex
// depends on its index in the whole scene alone. So neighbouring tiles share border vertices bit for bit. A scene of
// one cell with the same spacing has the same vertices off the grid lines. Coordinates are those that float32 holds.
// The same options give the same scene.
#ifndef TILEMEND_TESTS_SUPPORT_SCENE_MAKER_H_
#define TILEMEND_TESTS_SUPPORT_SCENE_MAKER_H_

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "common/grid/scene.h"
#include "common/mesh/tri_mesh.h"

namespace tilemend {

// With kClipped no triangle crosses a grid line. With kRagged each triangle lies whole in the tile of the cell that its
// centroid is in. Tiles then meet along a zigzag of shared vertices. With kOverlap they are as photogrammetry software
// delivers them. Each tile is its cell grown by a margin, with vertices and noise of its own, and shares no vertex with
// another.
enum class Cut { kClipped, kRagged, kOverlap };

inline std::string NameOf(Cut cut) {
  constexpr const char* kNames[] = {"Clipped", "Ragged", "Overlap"};
  return kNames[static_cast<int>(cut)];
}

// Shapes, in metres. With `only_cell` a hole ends dead at the sides of that cell: its neighbours have surface there.
struct EllipseHole {
  Point2 centre{0, 0};
  Point2 radii{1, 1};  // > 0
  std::optional<CellId> only_cell = {};
};

struct BoxHole {
  Point2 lo{0, 0};
  Point2 hi{0, 0};
  std::optional<CellId> only_cell = {};
};

struct StripHole {
  std::vector<Point2> through;  // at least one
  double half_width = 1;        // > 0
  std::optional<CellId> only_cell = {};
};

struct SceneMakerOptions {
  int32_t cols = 4;         // >= 1
  int32_t rows = 4;         // >= 1
  double cell_size = 50;    // > 0; the cells are square
  double spacing = 2.5;     // of the vertices; at most half a cell
  double feature_size = 0;  // width of hills, lakes and river; 0: the cell size
  uint64_t seed = 1;
  Cut cut = Cut::kClipped;
  double margin = 0.1;                                // of kOverlap: >= 0, at most half a cell
  int32_t pieces = 1;                                 // of kOverlap: a tile is pieces x pieces such pieces, >= 1
  double relief = 10;                                 // about the range of heights
  double noise = 0;                                   // peak to peak, of the vertices' heights
  std::function<double(double x, double y)> terrain;  // without noise; empty: hills of `relief`

  bool lakes = false;  // over cells and corners
  double lake_share = 0.12;
  bool islands = false;  // in the lakes
  bool river = false;    // from west to east
  double small_per_cell = 0;
  std::vector<EllipseHole> ellipses;
  std::vector<BoxHole> boxes;
  std::vector<StripHole> strips;
  double bend = 0;                  // by which share of a cell smooth waves bend the outlines of these shapes
  int32_t closed = 0;               // ellipses in one cell each, clear of its sides and of all other holes
  std::vector<CellId> empty;        // cells without any surface
  std::vector<CellId> out_of_area;  // cells that the scene does not have
};

struct MadeTile {
  CellId cell;
  TriMesh mesh;  // without triangles: no file is written, the cell's path is null
};

struct MadeScene {
  Grid grid;
  int32_t cols = 0, rows = 0;
  std::vector<MadeTile> tiles;                         // the cells of the area by (row, col)
  std::vector<Point3> removed;                         // vertices of the surface that the holes took, sorted: the truth
  std::function<double(double x, double y)> height;    // the terrain without noise
  std::function<bool(double x, double y)> is_in_hole;  // a triangle is removed if its centroid is
};

// Precondition: options in the ranges above. Time and memory linear in the vertices.
MadeScene MakeScene(const SceneMakerOptions& options);

// All tiles as one mesh, equal positions welded.
TriMesh MergeTiles(const MadeScene& scene);

// The scene.json of a made scene, with its tiles as tiles/Tile_+CCC_+RRR.ply.
Scene Describe(const MadeScene& made);

// A binary little-endian PLY, float32 positions.
std::string PlyBytes(const TriMesh& mesh);

// Writes folder/scene.json, folder/tiles/*.ply and folder/truth.csv (x,y,z of `removed`).
absl::Status WriteScene(const MadeScene& made, const std::string& folder);

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_SCENE_MAKER_H_
