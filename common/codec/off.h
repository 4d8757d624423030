// Geomview OFF (text): OFF, COFF, NOFF, STOFF and their combinations. See mesh_file.h for what is promised.
#ifndef TILEMEND_COMMON_CODEC_OFF_H_
#define TILEMEND_COMMON_CODEC_OFF_H_

#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "common/codec/mesh_file.h"
#include "common/codec/polygons.h"

namespace tilemend {

// Reads a file with a vertex and a face a line, as nearly all are. It also reads several on a line, as the format
// allows. Then a vertex has as many columns as the header's keyword says, and faces have no colours. `#` starts a
// comment. Linear in `bytes`.
absl::StatusOr<MeshFile> ParseOff(std::string_view bytes, const std::string& name, const FaceVisitor& visit = {});

// `bytes` with the counts updated, new vertices after the originals, and new faces, without colour, after the last
// face. New vertices have the further columns of the vertex that they are like, or zeros. Precondition: ParseOff takes
// `bytes`; numbers are not read again.
absl::StatusOr<std::string> AppendToOff(std::string_view bytes, const FilePatch& patch, const std::string& name);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_OFF_H_
