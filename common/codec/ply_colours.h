// What a PLY file says of the look of its surface.
#ifndef TILEMEND_COMMON_CODEC_PLY_COLOURS_H_
#define TILEMEND_COMMON_CODEC_PLY_COLOURS_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/util/colour.h"

namespace tilemend {

// The colours (red, green, blue of type uchar) of these vertices of a file that ParsePly reads; empty if it has none.
// Precondition: the vertices are in the file. Cost: linear in `vertices` for binary files whose first element is the
// vertices, else that of reading the file.
absl::StatusOr<std::vector<Rgb>> PlyVertexColours(std::string_view bytes, const std::vector<int32_t>& vertices,
                                                  const std::string& name);

// The colour of each triangle's face (the same properties of the faces), in the order of ParsePly; empty if faces have
// none. Errors of ParsePly. Linear.
absl::StatusOr<std::vector<Rgb>> PlyFaceColours(std::string_view bytes, const std::string& name);

// The images that the header names ("comment TextureFile NAME"), each once.
std::vector<std::string> PlyTextureNames(std::string_view bytes);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_PLY_COLOURS_H_
