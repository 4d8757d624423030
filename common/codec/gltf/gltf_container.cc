#include "common/codec/gltf/gltf_container.h"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "absl/strings/str_cat.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF is little-endian, and numbers are copied as they lie");

constexpr std::string_view kGlbMagic = "glTF";
constexpr std::string_view kB3dmMagic = "b3dm";
constexpr size_t kGlbHeaderBytes = 12;
constexpr size_t kChunkHeaderBytes = 8;
constexpr size_t kB3dmHeaderBytes = 28;
constexpr uint32_t kJsonChunk = 0x4E4F534A;
constexpr uint32_t kBinChunk = 0x004E4942;
constexpr size_t kMaxJsonBytes = size_t{32} << 20;

absl::Status ByteError(const std::string& name, size_t offset, std::string_view what) {
  return absl::InvalidArgumentError(absl::StrCat(name, ": byte ", offset, ": ", std::string(what)));
}

// Precondition: the bytes are there.
uint32_t NumberAt(std::string_view bytes, size_t offset) {
  uint32_t value = 0;
  std::memcpy(&value, bytes.data() + offset, sizeof(value));
  return value;
}

void AppendNumber(uint32_t value, std::string& out) {
  out.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

struct Chunk {
  uint32_t type = 0;
  size_t offset = 0;  // of the content in the file
  std::string_view content;
};

// The chunk at `offset` of the file.
absl::StatusOr<Chunk> ChunkAt(std::string_view bytes, size_t offset, const std::string& name) {
  if (bytes.size() - offset < kChunkHeaderBytes) return ByteError(name, offset, "expected a chunk of the glb");
  const uint32_t size = NumberAt(bytes, offset);
  const size_t content = offset + kChunkHeaderBytes;
  if (size > bytes.size() - content) {
    return ByteError(name, offset,
                     absl::StrCat("a chunk of ", size, " bytes, but ", bytes.size() - content, " are left"));
  }
  return Chunk{NumberAt(bytes, offset + 4), content, bytes.substr(content, size)};
}

// Reads the glb from `begin` to the end of the bytes.
absl::Status ParseGlb(std::string_view bytes, size_t begin, const std::string& name, GltfContainer& container) {
  const std::string_view glb = bytes.substr(begin);
  if (glb.size() < kGlbHeaderBytes || glb.substr(0, kGlbMagic.size()) != kGlbMagic) {
    return ByteError(name, begin, "expected a glb, which begins with glTF");
  }
  const uint32_t version = NumberAt(glb, 4), length = NumberAt(glb, 8);
  if (version != 2) return ByteError(name, begin + 4, absl::StrCat("glTF ", version, ".0 is not read; expected 2.0"));
  if (length > glb.size() || length < kGlbHeaderBytes) {
    return ByteError(name, begin + 8, absl::StrCat("the glb has ", length, " bytes, but ", glb.size(), " are there"));
  }
  const std::string_view file = bytes.substr(0, begin + length);
  TILEMEND_ASSIGN_OR_RETURN(const Chunk json, ChunkAt(file, begin + kGlbHeaderBytes, name));
  if (json.type != kJsonChunk) return ByteError(name, json.offset - 4, "expected the JSON chunk");
  if (json.content.size() > kMaxJsonBytes) return ByteError(name, json.offset, "the JSON chunk is over 32 MiB");
  TILEMEND_ASSIGN_OR_RETURN(container.json, ParseOrderedJson(json.content, json.offset, name));
  if (!container.json.is_object()) return ByteError(name, json.offset, "expected a JSON object");
  size_t end = json.offset + json.content.size();
  if (file.size() - end >= kChunkHeaderBytes) {
    TILEMEND_ASSIGN_OR_RETURN(const Chunk bin, ChunkAt(file, end, name));
    if (bin.type == kBinChunk) {
      container.has_bin = true;
      container.bin_offset = bin.offset;
      container.bin = bin.content;
      end = bin.offset + bin.content.size();
    }
  }
  container.trailing = file.substr(end);
  while (end < file.size()) {
    TILEMEND_ASSIGN_OR_RETURN(const Chunk other, ChunkAt(file, end, name));
    end = other.offset + other.content.size();
  }
  return absl::OkStatus();
}

// RTC_CENTER stands in the feature table itself, or in its binary part as three float32.
absl::StatusOr<Point3> RtcCenter(std::string_view bytes, size_t json_bytes, size_t binary_bytes,
                                 const std::string& name) {
  if (json_bytes == 0) return Point3(0, 0, 0);
  if (json_bytes > kMaxJsonBytes) return ByteError(name, 12, "the feature table is over 32 MiB");
  TILEMEND_ASSIGN_OR_RETURN(const OrderedJson table,
                            ParseOrderedJson(bytes.substr(kB3dmHeaderBytes, json_bytes), kB3dmHeaderBytes, name));
  const JsonView view(table, name);
  const std::optional<JsonView> center = view.Find("RTC_CENTER");
  if (!center) return Point3(0, 0, 0);
  if (!center->value().is_object()) {
    TILEMEND_ASSIGN_OR_RETURN(const std::vector<double> numbers, center->AsNumbers(3));
    return Point3(numbers[0], numbers[1], numbers[2]);
  }
  std::array<float, 3> numbers;
  if (binary_bytes < sizeof(numbers)) return center->Error("the feature table has no room for it");
  TILEMEND_ASSIGN_OR_RETURN(
      const int64_t offset,
      center->Integer("byteOffset", 0, static_cast<int64_t>(binary_bytes) - static_cast<int64_t>(sizeof(numbers))));
  std::memcpy(numbers.data(), bytes.data() + kB3dmHeaderBytes + json_bytes + offset, sizeof(numbers));
  const Point3 point(numbers[0], numbers[1], numbers[2]);
  if (!point.allFinite()) return center->Error("expected finite numbers");
  return point;
}

absl::Status ParseB3dm(std::string_view bytes, const std::string& name, GltfContainer& container) {
  if (bytes.size() < kB3dmHeaderBytes) return ByteError(name, bytes.size(), "expected a header of 28 bytes");
  const uint32_t version = NumberAt(bytes, 4), length = NumberAt(bytes, 8);
  if (version != 1) return ByteError(name, 4, absl::StrCat("b3dm version ", version, " is not read; expected 1"));
  if (length > bytes.size()) {
    return ByteError(name, 8, absl::StrCat("the b3dm has ", length, " bytes, but ", bytes.size(), " are there"));
  }
  uint64_t begin = kB3dmHeaderBytes;
  for (size_t at = 12; at < kB3dmHeaderBytes; at += 4) {
    begin += NumberAt(bytes, at);
    if (begin > length) return ByteError(name, at, "the table ends behind the file");
  }
  container.is_b3dm = true;
  container.head = bytes.substr(0, begin);
  TILEMEND_ASSIGN_OR_RETURN(container.origin, RtcCenter(bytes, NumberAt(bytes, 12), NumberAt(bytes, 16), name));
  return ParseGlb(bytes.substr(0, length), begin, name, container);
}

}  // namespace

absl::StatusOr<GltfContainer> ParseGltfContainer(std::string_view bytes, const std::string& name) {
  GltfContainer container;
  if (bytes.substr(0, kB3dmMagic.size()) == kB3dmMagic) {
    TILEMEND_RETURN_IF_ERROR(ParseB3dm(bytes, name, container));
  } else {
    TILEMEND_RETURN_IF_ERROR(ParseGlb(bytes, 0, name, container));
  }
  return container;
}

absl::StatusOr<std::string> WriteGltfContainer(const GltfContainer& container, const OrderedJson& json,
                                               std::string_view added, const std::string& name) {
  std::string text = json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
  text.append((4 - text.size() % 4) % 4, ' ');
  std::string bin(container.bin);
  bin.append((4 - bin.size() % 4) % 4, '\0');
  bin += added;
  bin.append((4 - bin.size() % 4) % 4, '\0');
  const bool has_bin = container.has_bin || !bin.empty();
  size_t fixed = container.head.size() + kGlbHeaderBytes + kChunkHeaderBytes + text.size() +
                 (has_bin ? kChunkHeaderBytes : 0) + container.trailing.size();
  if ((fixed + bin.size()) % 8 == 4) {  // a b3dm ends at a multiple of 8
    text.append(4, ' ');
    fixed += 4;
  }
  const uint64_t size = uint64_t{fixed} + bin.size();
  if (size > UINT32_MAX) return ByteError(name, 0, "the file would be over 4 GiB");
  std::string out(container.head);
  out.reserve(size);
  if (container.is_b3dm) {
    const uint32_t length = static_cast<uint32_t>(size);
    std::memcpy(out.data() + 8, &length, sizeof(length));
  }
  out += kGlbMagic;
  AppendNumber(2, out);
  AppendNumber(static_cast<uint32_t>(size - container.head.size()), out);
  AppendNumber(static_cast<uint32_t>(text.size()), out);
  AppendNumber(kJsonChunk, out);
  out += text;
  if (has_bin) {
    AppendNumber(static_cast<uint32_t>(bin.size()), out);
    AppendNumber(kBinChunk, out);
    out += bin;
  }
  out += container.trailing;
  return out;
}

}  // namespace tilemend
