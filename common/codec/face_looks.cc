#include "common/codec/face_looks.h"

#include <algorithm>
#include <array>
#include <bit>

#include "absl/hash/hash.h"
#include "common/codec/ply.h"
#include "common/codec/ply_header.h"
#include "common/codec/text.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

// Records of a PLY body by their numbers.
class PlyRecordFinder {
 public:
  PlyRecordFinder(std::string_view bytes, const PlyHeader& header, const PlyRecords& records)
      : bytes_(bytes), header_(header), records_(records) {}

  std::string_view Vertex(int32_t v) const {
    const auto k = static_cast<size_t>(v);
    const size_t begin = BeginOf(header_.vertex);
    if (records_.vertex_ends.empty()) {
      const size_t length = header_.elements[header_.vertex].LeastRecordBytes();
      return bytes_.substr(begin + k * length, length);
    }
    const size_t from = k == 0 ? begin : records_.vertex_ends[k - 1];
    return Trimmed({from, records_.vertex_ends[k]});
  }

  // The record of the face that has something at `place`.
  TextRange FaceAt(size_t place) const {
    const size_t begin = BeginOf(header_.face);
    if (records_.face_bytes > 0) {
      const size_t from = place - (place - begin) % records_.face_bytes;
      return {from, from + records_.face_bytes};
    }
    const auto end = std::upper_bound(records_.face_ends.begin(), records_.face_ends.end(), place);
    return {end == records_.face_ends.begin() ? begin : *(end - 1), *end};
  }

  // Without the white space around it in a text, which AppendPatch may change.
  std::string_view Trimmed(TextRange range) const {
    if (header_.encoding == PlyEncoding::kAscii) {
      while (range.begin < range.end && IsSpace(bytes_[range.begin])) ++range.begin;
      while (range.begin < range.end && IsSpace(bytes_[range.end - 1])) --range.end;
    }
    return bytes_.substr(range.begin, range.end - range.begin);
  }

  // `tail`, the end of a face's record, without the property tilemend_filled where that is the last one.
  std::string_view WithoutMark(std::string_view tail) const {
    const PlyProperty& last = header_.elements[header_.face].properties.back();
    if (last.is_list || last.name != kFilledProperty) return tail;
    if (header_.encoding != PlyEncoding::kAscii) return tail.substr(0, tail.size() - SizeOf(last.type));
    while (!tail.empty() && !IsSpace(tail.back())) tail.remove_suffix(1);
    while (!tail.empty() && IsSpace(tail.back())) tail.remove_suffix(1);
    return tail;
  }

 private:
  size_t BeginOf(size_t element) const {
    return element == 0 ? header_.body_begin : records_.element_ends[element - 1];
  }

  std::string_view bytes_;
  const PlyHeader& header_;
  const PlyRecords& records_;
};

}  // namespace

std::vector<uint64_t> ObjFaceLooks(const ObjTextures& textures, std::span<const Triangle> triangles) {
  std::vector<uint64_t> looks;
  looks.reserve(triangles.size());
  size_t run = 0;
  const std::string none;
  const std::string* material = &none;
  for (size_t t = 0; t < triangles.size(); ++t) {
    for (; run < textures.runs.size() && static_cast<size_t>(textures.runs[run].first) <= t; ++run) {
      material = &textures.materials[static_cast<size_t>(textures.runs[run].material)];
    }
    std::array<uint32_t, 6> bits{};
    std::array<uint64_t, 3> columns{};
    for (size_t k = 0; k < 3; ++k) {
      const auto vertex = static_cast<size_t>(triangles[t][k]);
      if (vertex < textures.vertex_columns.size()) columns[k] = textures.vertex_columns[vertex];
      const int32_t corner = textures.corners[t][k];
      if (corner < 0) continue;
      const std::array<float, 2>& uv = textures.coordinates[static_cast<size_t>(corner)];
      bits[2 * k] = std::bit_cast<uint32_t>(uv[0]);
      bits[2 * k + 1] = std::bit_cast<uint32_t>(uv[1]);
    }
    looks.push_back(absl::HashOf(bits, columns, *material));
  }
  return looks;
}

absl::StatusOr<std::vector<uint64_t>> PlyFaceLooks(std::string_view bytes, const std::string& name) {
  TILEMEND_ASSIGN_OR_RETURN(const PlyHeader header, ParsePlyHeader(bytes, name));
  PlyRecords records;
  TILEMEND_RETURN_IF_ERROR(ReadPlyBody(bytes, header, name, &records).status());
  const PlyRecordFinder finder(bytes, header, records);
  std::vector<uint64_t> faces;  // of each triangle, what its face has
  const FaceVisitor visit = [&](size_t, std::span<const TextRange> corners, std::span<const Triangle> triangles) {
    const TextRange record = finder.FaceAt(corners.front().begin);
    const std::string_view tail = finder.WithoutMark(finder.Trimmed({corners.back().end, record.end}));
    const uint64_t look = absl::HashOf(finder.Trimmed({record.begin, corners.front().begin}), tail);
    faces.insert(faces.end(), triangles.size(), look);
  };
  TILEMEND_ASSIGN_OR_RETURN(const MeshFile file, ReadPlyBody(bytes, header, name, nullptr, visit));
  for (size_t t = 0; t < faces.size(); ++t) {
    const Triangle& corners = file.mesh.triangles[t];
    faces[t] = absl::HashOf(faces[t], finder.Vertex(corners[0]), finder.Vertex(corners[1]), finder.Vertex(corners[2]));
  }
  return faces;
}

std::vector<uint64_t> TreeFaceLooks(const TileTree& tile, const TreeLevel& level) {
  std::vector<uint64_t> looks;
  for (const TreeLevel::Part& part : level.parts) {
    const int32_t f = tile.pieces[part.piece].file;
    const TreeFile& file = tile.files[f];
    for (const int32_t g : part.geometries) {
      const TreeGeometry& geometry = file.geometries[g];
      std::string_view image;
      if (geometry.texture >= 0) {
        const TreeImage& of_file = file.images[geometry.texture];
        image = tile.packed[f].bytes.substr(of_file.offset, of_file.size);
      }
      const Rgb& c = geometry.colour;
      const size_t look = absl::HashOf(image, geometry.has_colour, c.r, c.g, c.b);
      for (int32_t t = 0; t < geometry.triangle_count; ++t) {
        std::array<uint32_t, 6> bits{};
        for (size_t k = 0; k < 3; ++k) {
          const std::array<float, 2>& uv = file.uv[file.triangles[geometry.first_triangle + t][k]];
          bits[2 * k] = std::bit_cast<uint32_t>(uv[0]);
          bits[2 * k + 1] = std::bit_cast<uint32_t>(uv[1]);
        }
        looks.push_back(absl::HashOf(bits, look));
      }
    }
  }
  return looks;
}

}  // namespace tilemend
