// PLY files with a bit of everything.
#ifndef TILEMEND_TESTS_COMMON_CODEC_ODD_PLY_H_
#define TILEMEND_TESTS_COMMON_CODEC_ODD_PLY_H_

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/codec/mesh_file.h"

namespace tilemend::testing {

template <class T>
inline std::string Bytes(T value, bool big_endian) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  return big_endian ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

// A file with a property of every kind around what is read, two triangles and a quad, and an element of edges.
struct OddPly {
  bool big_endian = false;
  std::string eol = "\n";
  std::string filled_property = {};
  std::string vertex_count = "4";
  std::string face_count = "3";

  std::string Header() const {
    std::string text = "ply|format binary_" + std::string(big_endian ? "big" : "little") +
                       "_endian 1.0|comment odd one|element vertex " + vertex_count +
                       "|property uchar red|property double x|property double y|property list uchar short spare"
                       "|property double z|obj_info made by hand|element face " +
                       face_count + "|property short kind|property list uint int vertex_index" +
                       "|property list uchar float texcoord|" + filled_property +
                       "element edge 1|property int vertex1|property int vertex2|end_header|";
    std::string out;
    for (const char c : text) c == '|' ? out += eol : out += c;
    return out;
  }
  std::string Vertex(uint8_t red, double x, double y, const std::vector<int16_t>& spare, double z) const {
    std::string out = Bytes(red, big_endian) + Bytes(x, big_endian) + Bytes(y, big_endian);
    out += static_cast<char>(spare.size());
    for (const int16_t value : spare) out += Bytes(value, big_endian);
    return out + Bytes(z, big_endian);
  }
  std::string Face(int16_t kind, const std::vector<int32_t>& corners, const std::vector<float>& texcoord) const {
    std::string out = Bytes(kind, big_endian) + Bytes(static_cast<uint32_t>(corners.size()), big_endian);
    for (const int32_t corner : corners) out += Bytes(corner, big_endian);
    out += static_cast<char>(texcoord.size());
    for (const float value : texcoord) out += Bytes(value, big_endian);
    return out;
  }
  std::vector<std::string> Vertices() const {
    return {Vertex(1, 0.1, 0, {}, -0.0), Vertex(2, 1e-300, 0.3, {7, -8}, 1), Vertex(3, 1, 1, {9}, 1e9),
            Vertex(255, 0, 1.0 / 3, {1, 2, 3}, 2)};
  }
  std::vector<std::string> Faces() const {
    return {Face(-5, {0, 1, 2}, {0, 0.5f, 1, 1, 0, 1}), Face(6, {0, 1, 2, 3}, {}), Face(7, {3, 2, 0}, {0.25f})};
  }
  std::string Edges() const { return Bytes(int32_t{0}, big_endian) + Bytes(int32_t{3}, big_endian); }
};

inline absl::StatusOr<MeshFile> Parse(const std::string& bytes) { return ParseMesh(MeshFormat::kPly, bytes, "a.ply"); }

inline std::string Join(const std::vector<std::string>& parts, const std::string& after = "") {
  std::string out;
  for (const std::string& part : parts) out += part + after;
  return out;
}

inline constexpr char kAsciiHeader[] =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "property uchar red\nelement face 1\nproperty list uchar int vertex_indices\nelement note 1\n"
    "property list int int code\nend_header\n";

}  // namespace tilemend::testing

#endif  // TILEMEND_TESTS_COMMON_CODEC_ODD_PLY_H_
