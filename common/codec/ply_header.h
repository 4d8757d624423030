// The header of a PLY file: what its elements are, and where in the text they are said.
#ifndef TILEMEND_COMMON_CODEC_PLY_HEADER_H_
#define TILEMEND_COMMON_CODEC_PLY_HEADER_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"

namespace tilemend {

inline constexpr std::string_view kFilledProperty = "tilemend_filled";

enum class PlyEncoding { kAscii, kLittleEndian, kBigEndian };
enum class PlyType : uint8_t { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat32, kFloat64 };

// Bytes of a value in a binary file.
constexpr size_t SizeOf(PlyType type) {
  constexpr std::array<size_t, 8> kSizes = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<size_t>(type)];
}
constexpr bool IsFloat(PlyType type) { return type == PlyType::kFloat32 || type == PlyType::kFloat64; }

struct PlyProperty {
  std::string name;
  bool is_list = false;
  PlyType count_type = PlyType::kUint8;  // of a list
  PlyType type = PlyType::kFloat32;      // of a value, or of a list's entries
  size_t type_begin = 0;                 // the text of `type` in the header
  size_t type_end = 0;
};

struct PlyElement {
  std::string name;
  int64_t count = 0;
  std::vector<PlyProperty> properties;
  size_t count_begin = 0;  // the text of `count` in the header
  size_t count_end = 0;
  size_t end = 0;  // just after the element's last property line, where a further property can be said

  // Bytes of a record whose lists are empty.
  size_t LeastRecordBytes() const;
  bool HasLists() const;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::kAscii;
  std::vector<PlyElement> elements;
  std::string_view eol;  // of the header's lines
  size_t body_begin = 0;
  // Indices into `elements`, and into their properties.
  size_t vertex = 0;
  size_t face = 0;
  std::array<size_t, 3> xyz = {};  // float or double
  size_t corners = 0;              // the list of vertex indices, of an integer type
};

// The properties red, green, blue of an element, where it has all three as uchar.
std::optional<std::array<size_t, 3>> ColourProperties(const PlyElement& element);

// Reads and checks a header. It must have one vertex element with scalar float or double x, y, z, and one face element
// with vertex_indices (or vertex_index). There must be at least one vertex, and no counts that the bytes after the
// header cannot hold.
absl::StatusOr<PlyHeader> ParsePlyHeader(std::string_view bytes, const std::string& name);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_PLY_HEADER_H_
