// Faces of a file as triangles of a mesh.
#ifndef TILEMEND_COMMON_CODEC_POLYGONS_H_
#define TILEMEND_COMMON_CODEC_POLYGONS_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "common/codec/mesh_file.h"

namespace tilemend {

// A stretch of a file's bytes.
struct TextRange {
  size_t begin = 0;
  size_t end = 0;
};

// Hears of each face that adds triangles to the mesh: the number of the first, and where its corners are said.
using FaceVisitor = std::function<void(size_t first_triangle, std::span<const TextRange> corners)>;

// Adds a face as a fan around its first corner. A face with fewer than three corners or with a repeated vertex bounds
// no surface: it adds no triangle (the file keeps it). Corners are indices of vertices.
void AddPolygon(const std::vector<int32_t>& corners, MeshFile& file);
// The same, and tells `visit`, if there is one, of a face that adds triangles.
void AddPolygon(const std::vector<int32_t>& corners, std::span<const TextRange> places, const FaceVisitor& visit,
                MeshFile& file);

// Checks a patch against the number of vertices of the file that it is for: `like` has an entry per new point, indices
// are in range, coordinates valid, and all vertices together can be indexed.
absl::Status CheckPatch(const FilePatch& patch, size_t vertex_count, const std::string& name);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_POLYGONS_H_
