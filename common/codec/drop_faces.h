// Takes faces out of a mesh file, and leaves every other byte as it is.
#ifndef TILEMEND_COMMON_CODEC_DROP_FACES_H_
#define TILEMEND_COMMON_CODEC_DROP_FACES_H_

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/codec/mesh_file.h"

namespace tilemend {

// `bytes` without the faces all of whose triangles are in `drop` (one entry per triangle of ParseMesh). All vertices
// stay, so that indices stay; some may be in no face then.
//   OBJ: the lines of these faces are gone, with comments at their ends.
//   PLY: the records of these faces are gone, and the header's count of faces is lower.
// kInvalidArgument for OFF and STL. Precondition: ParseMesh takes `bytes`. Linear.
absl::StatusOr<std::string> DropFaces(MeshFormat format, std::string_view bytes, const std::vector<bool>& drop,
                                      const std::string& name);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_DROP_FACES_H_
