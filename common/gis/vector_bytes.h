// The bytes of a vector file and of the files beside it that belong to it.
#ifndef TILEMEND_COMMON_GIS_VECTOR_BYTES_H_
#define TILEMEND_COMMON_GIS_VECTOR_BYTES_H_

#include <string>
#include <vector>

#include "absl/status/statusor.h"

namespace tilemend {

struct SideFile {
  std::string name;  // the suffix, in lower case, of a file with the same stem ("dbf"); of a file in a folder its name
  std::string bytes;
};

struct VectorBytes {
  std::string bytes;  // of the file itself; empty for a folder
  std::vector<SideFile> beside = {};
};

// Reads a file for --water or --area, with the files that belong to it. For a shapefile these are the `.dbf`, `.shx`,
// `.prj` and `.cpg`. Likewise the other files of MapInfo, the schema of GML, and all files of a File Geodatabase (a
// folder `*.gdb`). Suffixes may be in capital letters. Errors as ReadFile. kInvalidArgument for a URL and for another
// folder. The same for a GeoPackage with changes that are still in its log (`path`-wal), because another program has it
// open.
absl::StatusOr<VectorBytes> ReadAreaFile(const std::string& path);

// What tells two such files apart: the bytes of a file without others beside it, else all of them with their names.
std::string ContentOf(const VectorBytes& file);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_GIS_VECTOR_BYTES_H_
