#include "common/codec/ply_colours.h"

#include <algorithm>
#include <array>
#include <optional>

#include "common/codec/ply.h"
#include "common/codec/ply_header.h"
#include "common/codec/ply_source.h"
#include "common/codec/text.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

// Reads colours out of single records, which have been checked before.
class ColourReader {
 public:
  ColourReader(std::string_view bytes, const PlyHeader& header, const PlyElement& element,
               const std::array<size_t, 3>& channels)
      : bytes_(bytes), header_(header), element_(element), channels_(channels), swap_(NeedsSwap(header.encoding)) {}

  Rgb At(size_t record) const {
    std::array<uint8_t, 3> colour{};
    size_t at = record;
    for (size_t i = 0; i < element_.properties.size(); ++i) {
      const size_t channel = static_cast<size_t>(std::find(channels_.begin(), channels_.end(), i) - channels_.begin());
      const auto [value, end] = Next(element_.properties[i], at);
      if (channel < channels_.size()) colour[channel] = value;
      at = end;
    }
    return {colour[0], colour[1], colour[2]};
  }

 private:
  struct Value {
    uint8_t value;  // of a scalar uchar
    size_t end;
  };

  Value Next(const PlyProperty& property, size_t at) const {
    return header_.encoding == PlyEncoding::kAscii ? NextInText(property, at) : NextInBinary(property, at);
  }

  Value NextInBinary(const PlyProperty& property, size_t at) const {
    if (!property.is_list) return {static_cast<uint8_t>(bytes_[at]), at + SizeOf(property.type)};
    const auto count = WithPlyType(property.count_type, [&](auto sample) {
      return static_cast<size_t>(LoadValue<decltype(sample)>(bytes_.data() + at, swap_));
    });
    return {0, at + SizeOf(property.count_type) + count * SizeOf(property.type)};
  }

  Value NextInText(const PlyProperty& property, size_t at) const {
    int64_t value = TakeNumber(at);
    if (!property.is_list) return {static_cast<uint8_t>(std::clamp<int64_t>(value, 0, 255)), at};
    for (; value > 0; --value) TakeNumber(at);
    return {0, at};
  }

  // The next word as an integer (0 if it is none); moves `at` behind it.
  int64_t TakeNumber(size_t& at) const {
    while (at < bytes_.size() && IsSpace(bytes_[at])) ++at;
    const int64_t value = ParseIntegerAt(bytes_.data() + at, bytes_.data() + bytes_.size()).value;
    while (at < bytes_.size() && !IsSpace(bytes_[at])) ++at;
    return value;
  }

  const std::string_view bytes_;
  const PlyHeader& header_;
  const PlyElement& element_;
  const std::array<size_t, 3> channels_;
  const bool swap_;
};

}  // namespace

absl::StatusOr<std::vector<Rgb>> PlyVertexColours(std::string_view bytes, const std::vector<int32_t>& vertices,
                                                  const std::string& name) {
  TILEMEND_ASSIGN_OR_RETURN(const PlyHeader header, ParsePlyHeader(bytes, name));
  const PlyElement& vertex = header.elements[header.vertex];
  const std::optional<std::array<size_t, 3>> channels = ColourProperties(vertex);
  std::vector<Rgb> colours;
  if (!channels) return colours;
  PlyRecords records;
  const bool fixed = header.encoding != PlyEncoding::kAscii && !vertex.HasLists();
  if (!fixed || header.vertex > 0) {
    TILEMEND_RETURN_IF_ERROR(ReadPlyBody(bytes, header, name, &records).status());
  }
  const size_t begin = header.vertex == 0 ? header.body_begin : records.element_ends[header.vertex - 1];
  const auto record = [&](size_t k) {
    if (fixed) return begin + k * vertex.LeastRecordBytes();
    return k == 0 ? begin : records.vertex_ends[k - 1];
  };
  const ColourReader reader(bytes, header, vertex, *channels);
  colours.reserve(vertices.size());
  for (const int32_t v : vertices) colours.push_back(reader.At(record(static_cast<size_t>(v))));
  return colours;
}

absl::StatusOr<std::vector<Rgb>> PlyFaceColours(std::string_view bytes, const std::string& name) {
  TILEMEND_ASSIGN_OR_RETURN(const PlyHeader header, ParsePlyHeader(bytes, name));
  const PlyElement& face = header.elements[header.face];
  const std::optional<std::array<size_t, 3>> channels = ColourProperties(face);
  std::vector<Rgb> colours;
  if (!channels) return colours;
  PlyRecords records;
  TILEMEND_RETURN_IF_ERROR(ReadPlyBody(bytes, header, name, &records).status());
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<size_t> begins, PlyFaceBegins(bytes, header, records, name));
  const ColourReader reader(bytes, header, face, *channels);
  colours.reserve(begins.size());
  for (const size_t begin : begins) colours.push_back(reader.At(begin));
  return colours;
}

std::vector<std::string> PlyTextureNames(std::string_view bytes) {
  constexpr std::string_view kTexture = "comment TextureFile ";
  std::vector<std::string> names;
  while (!bytes.empty()) {
    const size_t end = std::min(bytes.find_first_of("\r\n"), bytes.size());
    std::string_view line = bytes.substr(0, end);
    if (line.starts_with("end_header")) break;
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
    if (!line.starts_with(kTexture)) continue;
    line.remove_prefix(kTexture.size());
    while (!line.empty() && IsSpace(line.front())) line.remove_prefix(1);
    while (!line.empty() && IsSpace(line.back())) line.remove_suffix(1);
    if (!line.empty() && std::find(names.begin(), names.end(), line) == names.end()) names.emplace_back(line);
  }
  return names;
}

}  // namespace tilemend
