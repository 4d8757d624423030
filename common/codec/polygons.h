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

// Called for each face that adds triangles to the mesh. It gets the number of the first, where the corners stand in the
// text, and the triangles by places in these.
using FaceVisitor =
    std::function<void(size_t first_triangle, std::span<const TextRange> corners, std::span<const Triangle> triangles)>;

// Of a face with three corners.
inline constexpr Triangle kWhole[] = {{0, 1, 2}};

// Adds a face, cut into triangles (cut_polygon.h). Corners that repeat the one before do not count. A face with fewer
// than three others, or that comes by a vertex again, bounds no surface: it adds no triangle (the file keeps it).
// Corners are indices of vertices. `cut` gets the triangles by places of the face's corners. `all` has the vertices
// that the file will have, for a face that stands before its own; empty: those that `file` has.
void AddPolygon(const std::vector<int32_t>& corners, MeshFile& file, std::vector<Triangle>& cut,
                std::span<const Point3> all = {});
// The same, and tells `visit`, if there is one, of a face that adds triangles.
void AddPolygon(const std::vector<int32_t>& corners, std::span<const TextRange> places, const FaceVisitor& visit,
                MeshFile& file, std::vector<Triangle>& cut, std::span<const Point3> all = {});

// Checks a patch against the number of vertices of its file. There must be an entry of `like` per new point, indices
// must be in range and coordinates valid. It must be possible to index all vertices together.
absl::Status CheckPatch(const FilePatch& patch, size_t vertex_count, const std::string& name);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_POLYGONS_H_
