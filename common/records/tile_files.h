// The files that a tile needs beside it, to be shown as it is.
#ifndef TILEMEND_COMMON_RECORDS_TILE_FILES_H_
#define TILEMEND_COMMON_RECORDS_TILE_FILES_H_

#include <string>
#include <vector>

namespace tilemend {

// Paths are relative to the scene's folder and stay inside it, each once.
struct TileFiles {
  std::vector<std::string> libraries;  // material files, in the order in which the tile names them
  std::vector<std::string> images;
  std::vector<std::string> warnings;  // on files that are named but cannot be had
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RECORDS_TILE_FILES_H_
