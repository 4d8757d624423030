// Stanford PLY: ascii, binary little-endian and binary big-endian. See mesh_file.h for what is promised.
#ifndef TILEMEND_COMMON_CODEC_PLY_H_
#define TILEMEND_COMMON_CODEC_PLY_H_

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/codec/mesh_file.h"
#include "common/codec/ply_header.h"
#include "common/codec/polygons.h"

namespace tilemend {

// Where the records of a PLY body lie: what is needed to copy them.
struct PlyRecords {
  std::vector<size_t> element_ends;  // per element: just after its last record
  std::vector<size_t> vertex_ends;   // per vertex: just after it; empty if all records have the same number of bytes
  size_t face_bytes = 0;             // of each face, where all are known to have the same number; else 0 and
  std::vector<size_t> face_ends;     // per face: just after it
};

// Reads the positions and faces; every further property and element may be anything that the header can say. A file
// whose faces stand before its vertices is read twice.
absl::StatusOr<MeshFile> ParsePly(std::string_view bytes, const std::string& name, const FaceVisitor& visit = {});

// The same with a header that was read already. With `records` these are filled, and everything is checked, but the
// mesh is not kept: it comes back empty or in part.
absl::StatusOr<MeshFile> ReadPlyBody(std::string_view bytes, const PlyHeader& header, const std::string& name,
                                     PlyRecords* records, const FaceVisitor& visit = {});

// Where the record of each triangle's face begins. `records` are those of the file. Errors of ParsePly. Linear.
absl::StatusOr<std::vector<size_t>> PlyFaceBegins(std::string_view bytes, const PlyHeader& header,
                                                  const PlyRecords& records, const std::string& name);

// `bytes` with the patch: see mesh_file.h. Indices that the file's type for them cannot hold (a ushort list, 70,000
// vertices) widen that type to int in the output.
absl::StatusOr<std::string> AppendToPly(std::string_view bytes, const FilePatch& patch, const std::string& name);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_PLY_H_
