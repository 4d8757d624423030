// Wavefront OBJ: the geometry is read, everything else is kept as text. See mesh_file.h for what is promised.
#ifndef TILEMEND_COMMON_CODEC_OBJ_H_
#define TILEMEND_COMMON_CODEC_OBJ_H_

#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "common/codec/mesh_file.h"

namespace tilemend {

// Reads `v` and `f` statements; texture and normal indices are checked for form only, further statements are skipped.
// Positive indices may name vertices that come later in the file. Linear in `bytes`.
absl::StatusOr<MeshFile> ParseObj(std::string_view bytes, const std::string& name);

// `bytes` unchanged, then the patch in group and material `tilemend_filled`. New vertices take the further columns
// (weight or colour) of the vertex that they are like.
absl::StatusOr<std::string> AppendToObj(std::string_view bytes, const FilePatch& patch, const std::string& name);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_OBJ_H_
