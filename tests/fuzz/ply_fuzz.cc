#include <string_view>

#include "tests/fuzz/append_property.h"
#include "tests/fuzz/fuzz_target.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  tilemend::CheckAppendProperty(tilemend::MeshFormat::kPly, {reinterpret_cast<const char*>(data), size});
  return 0;
}

namespace tilemend {

std::vector<std::string> FuzzSeeds() {
  using std::string_literals::operator""s;
  FilePatch tetrahedron;
  tetrahedron.new_points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  tetrahedron.like.assign(4, -1);
  tetrahedron.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  const std::string ascii_body =
      "0 0 0 10 1 7\n1 0 0 20 0\n0 1 0 30 2 5 6\n4 0 1 2 0 2 0.5 0.5 7\n3 0 1 2 0 8\n0 1\n1 2\n";
  const std::string elements =
      "comment seed\nelement vertex 3\nproperty double x\nproperty float y\nproperty float z\nproperty uchar red\n"
      "property list uchar short extra\nelement face 2\nproperty list uchar uchar vertex_index\n"
      "property list int float texcoord\nproperty ushort flags\nelement edge 2\nproperty int vertex1\nproperty int "
      "vertex2\n"
      "end_header\n";
  const std::string big_endian =
      "ply\r\nformat binary_big_endian 1.0\r\nobj_info seed\r\nelement vertex 3\r\nproperty float z\r\nproperty float "
      "x\r\n"
      "property float y\r\nelement face 1\r\nproperty uchar kind\r\nproperty list uchar int "
      "vertex_indices\r\nend_header\r\n"
      "\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x3f\x80\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x3f\x80\0\0\x07\x03\0\0\0\0\0\0\0\x01\0\0\0\x02"s;
  return {
      NewPlyFile(tetrahedron, NumberType::kFloat32), NewPlyFile(tetrahedron, NumberType::kFloat64), big_endian,
      "ply\nformat ascii 1.0\n" + elements + ascii_body,
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
      "property list uchar int vertex_indices\nproperty uchar tilemend_filled\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 "
      "2 0"};
}

}  // namespace tilemend
