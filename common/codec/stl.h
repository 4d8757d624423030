// STL, binary and text: triangles without shared vertices. See mesh_file.h for what is promised.
#ifndef TILEMEND_COMMON_CODEC_STL_H_
#define TILEMEND_COMMON_CODEC_STL_H_

#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "common/codec/mesh_file.h"
#include "common/codec/polygons.h"

namespace tilemend {

// Corner k of triangle t is vertex 3 t + k. A file is binary if it has the length that the count at byte 80 says, else
// text if it begins with `solid`. The normals of facets are not looked at. Binary positions are float32. Linear.
absl::StatusOr<MeshFile> ParseStl(std::string_view bytes, const std::string& name, const FaceVisitor& visit = {});

// `bytes` with further facets, with normals: behind the last one, in text before the last `endsolid`. Materials,
// colours and `like` have no place in STL. Precondition: ParseStl takes `bytes`.
absl::StatusOr<std::string> AppendToStl(std::string_view bytes, const FilePatch& patch, const std::string& name);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_STL_H_
