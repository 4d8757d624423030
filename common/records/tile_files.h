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

// What led to the files of a tile and to its colours, beside the tile itself: while all of it holds, they are the same.
struct FileWitness {
  // A name in one of the files, looked for in `folder`, led to `path`; nowhere if that is empty, because of `problem`.
  struct Lookup {
    std::string folder, name, path, problem;
  };
  // A file that was read for what it says, and its FileDigest; empty: it could not be read.
  struct Read {
    std::string path, digest;
  };
  std::vector<Lookup> lookups;
  std::vector<Read> reads;
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RECORDS_TILE_FILES_H_
