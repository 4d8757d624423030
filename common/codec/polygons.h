// Faces of a file as triangles of a mesh.
#ifndef TILEMEND_COMMON_CODEC_POLYGONS_H_
#define TILEMEND_COMMON_CODEC_POLYGONS_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "common/codec/mesh_file.h"

namespace tilemend {

// Adds a face as a fan around its first corner. A face with fewer than three corners or with a repeated vertex bounds
// no surface: it adds no triangle (the file keeps it). Corners are indices of vertices.
void AddPolygon(const std::vector<int32_t>& corners, MeshFile& file);

// Checks a patch against the number of vertices of the file that it is for: `like` has an entry per new point, indices
// are in range, coordinates valid, and all vertices together can be indexed.
absl::Status CheckPatch(const FilePatch& patch, size_t vertex_count, const std::string& name);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_POLYGONS_H_
