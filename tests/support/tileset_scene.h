// A made scene of 3D Tiles with levels of detail, for tests.
#ifndef TILEMEND_TESTS_SUPPORT_TILESET_SCENE_H_
#define TILEMEND_TESTS_SUPPORT_TILESET_SCENE_H_

#include <Eigen/Core>
#include <map>
#include <string>

namespace tilemend {

// The ground of OsgbScene (osgb_scene.h): a round pond over the border of two cells of 64 m. Each has three levels of 4
// m, 2 m and 1 m, the finest in four models. Cells with tilesets of their own overlap. Models are glb files with the
// texture `image`.
struct TilesetScene {
  enum class Pond { kHole, kNoise };
  enum class Files {
    kOne,      // tileset.json has all tiles
    kOfTiles,  // it names a tileset for each cell, as Data/Tile_p000_p000/Tile_p000_p000.json
  };
  enum class Place {
    kLocal,         // the root has no transform
    kOnEarth,       // the root's transform puts the scene onto the Earth
    kEarthCentred,  // the models' tiles have Earth-centred transforms of their own
  };

  Pond pond = Pond::kHole;
  Files files = Files::kOne;
  Place place = Place::kLocal;
  std::string image = "";  // a PNG; empty: one of a white pixel
  double turn = 0;         // radians by which the cells are turned about the vertical, by their tilesets' transforms

  // The files by their paths in the scene.
  std::map<std::string, std::string> All() const;
  // The files as the program reads them if the tileset is one tile.
  std::string Pack() const;
  // The files of one cell below its folder, by their names there (Files::kOfTiles).
  std::map<std::string, std::string> OfTile(int col) const;

  static std::string TileName(int col) { return col == 0 ? "Tile_p000_p000" : "Tile_p001_p000"; }
  // From the scene's frame, with x to the east, y to the north and z up, to that of the Earth. It is at 8 degrees east
  // and 50 degrees north.
  static Eigen::Matrix4d ToEarth();
};

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_TILESET_SCENE_H_
