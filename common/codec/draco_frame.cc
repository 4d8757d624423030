#include "common/codec/draco_frame.h"

#include <array>
#include <cstddef>

#include "absl/strings/str_cat.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

constexpr std::string_view kMagic = "TMLM";
constexpr size_t kContentAt = 4;
constexpr size_t kLengthAt = 5;
constexpr size_t kChecksumAt = 13;
constexpr size_t kFrameHeaderBytes = 17;

// [k][b]: what byte b adds to the checksum of the k bytes that follow it.
using CrcTables = std::array<std::array<uint32_t, 256>, 8>;

constexpr CrcTables MakeCrcTables() {
  constexpr uint32_t kCastagnoli = 0x82f63b78;  // reflected
  CrcTables tables = {};
  for (uint32_t i = 0; i < 256; ++i) {
    uint32_t crc = i;
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) != 0 ? kCastagnoli : 0);
    tables[0][i] = crc;
  }
  for (size_t k = 1; k < tables.size(); ++k) {
    for (size_t i = 0; i < 256; ++i) tables[k][i] = (tables[k - 1][i] >> 8) ^ tables[0][tables[k - 1][i] & 0xff];
  }
  return tables;
}

// Eight bytes at a time (Kounavis and Berry 2005).
uint32_t Crc32c(std::string_view bytes) {
  static constexpr CrcTables kTables = MakeCrcTables();
  uint32_t crc = ~uint32_t{0};
  for (; bytes.size() >= 8; bytes.remove_prefix(8)) {
    const uint32_t lower = crc ^ LoadUint32(bytes.data()), upper = LoadUint32(bytes.data() + 4);
    crc = 0;
    for (int k = 0; k < 4; ++k) {
      crc ^= kTables[7 - k][(lower >> 8 * k) & 0xff] ^ kTables[3 - k][(upper >> 8 * k) & 0xff];
    }
  }
  for (const char c : bytes) crc = (crc >> 8) ^ kTables[0][(crc ^ static_cast<unsigned char>(c)) & 0xff];
  return ~crc;
}

// Reads a Draco stream's headers; every read says what it is for, so that a refusal can name it.
class StreamReader {
 public:
  explicit StreamReader(std::string_view stream) : stream_(stream) {}

  size_t remaining() const { return stream_.size() - position_; }

  absl::Status Error(std::string_view expected) const {
    return absl::InvalidArgumentError(
        absl::StrCat("Draco stream: byte ", position_, ": expected ", std::string(expected)));
  }

  absl::Status Expect(std::string_view value, std::string_view what) {
    if (stream_.substr(position_, value.size()) != value) return Error(what);
    position_ += value.size();
    return absl::OkStatus();
  }

  absl::StatusOr<uint8_t> Byte(uint8_t least, uint8_t most, std::string_view what) {
    if (remaining() == 0) return Error(what);
    const uint8_t value = static_cast<uint8_t>(stream_[position_]);
    if (value < least || value > most) return Error(what);
    ++position_;
    return value;
  }

  absl::StatusOr<uint32_t> Varint(std::string_view what) {
    constexpr size_t kMostBytes = 5;
    uint64_t value = 0;
    for (size_t i = 0; i < kMostBytes && i < remaining(); ++i) {
      const uint8_t byte = static_cast<uint8_t>(stream_[position_ + i]);
      value |= uint64_t{byte & 0x7fu} << (7 * i);
      if ((byte & 0x80) != 0) continue;
      if (value > UINT32_MAX) break;
      position_ += i + 1;
      return static_cast<uint32_t>(value);
    }
    return Error(what);
  }

  absl::Status Skip(uint64_t count, std::string_view what) {
    if (count > remaining()) return Error(what);
    position_ += static_cast<size_t>(count);
    return absl::OkStatus();
  }

 private:
  const std::string_view stream_;
  size_t position_ = 0;
};

// Indices are bytes, 16-bit numbers, varints or 32-bit numbers, by the number of points.
absl::Status SkipIndices(const DracoCounts& counts, StreamReader& reader) {
  const uint64_t indices = uint64_t{counts.triangles} * 3;
  if (indices > reader.remaining()) return reader.Error("the indices of the triangles");
  constexpr uint32_t kVarintsFrom = 1 << 16;
  constexpr uint32_t kVarintsTo = 1 << 21;
  if (counts.points < 256) return reader.Skip(indices, "the indices of the triangles");
  if (counts.points < kVarintsFrom) return reader.Skip(2 * indices, "the indices of the triangles");
  if (counts.points >= kVarintsTo) return reader.Skip(4 * indices, "the indices of the triangles");
  for (uint64_t i = 0; i < indices; ++i) TILEMEND_RETURN_IF_ERROR(reader.Varint("a vertex index").status());
  return absl::OkStatus();
}

// One decoder with one attribute: position, int32, three components, not normalized, id 0; integer coding.
absl::Status CheckAttribute(StreamReader& reader) {
  TILEMEND_RETURN_IF_ERROR(reader.Expect({"\1", 1}, "one attribute decoder"));
  TILEMEND_RETURN_IF_ERROR(reader.Expect({"\1", 1}, "one attribute"));
  TILEMEND_RETURN_IF_ERROR(reader.Expect({"\0\5\3\0\0", 5}, "int32 positions of three components"));
  return reader.Expect({"\1", 1}, "integer coding");
}

absl::Status CheckCoding(StreamReader& reader) {
  constexpr std::string_view kDifference("\0\1", 2);  // with wrapping
  constexpr std::string_view kNoPrediction("\xfe", 1);
  if (!reader.Expect(kDifference, "").ok()) {
    TILEMEND_RETURN_IF_ERROR(reader.Expect(kNoPrediction, "difference prediction or none"));
  }
  TILEMEND_RETURN_IF_ERROR(reader.Expect({"\1", 1}, "compressed values"));
  TILEMEND_ASSIGN_OR_RETURN(const uint8_t raw, reader.Byte(0, 1, "tagged or raw symbols"));
  // Tagged: the symbols are bit lengths. Raw: Draco's encoder makes tables of up to 18 bits.
  const uint32_t most_symbols = raw == 1 ? 1 << 18 : 64;
  if (raw == 1) TILEMEND_RETURN_IF_ERROR(reader.Byte(1, 18, "a bit length of symbols in 1 to 18").status());
  TILEMEND_ASSIGN_OR_RETURN(const uint32_t symbols, reader.Varint("the number of symbols"));
  return symbols <= most_symbols ? absl::OkStatus() : reader.Error("fewer symbols");
}

}  // namespace

uint32_t LoadUint32(const char* p) {
  uint32_t value = 0;
  for (int i = 3; i >= 0; --i) value = value << 8 | static_cast<unsigned char>(p[i]);
  return value;
}

void AppendUint32(uint32_t value, std::string& out) {
  for (int shift = 0; shift < 32; shift += 8) out += static_cast<char>(value >> shift & 0xff);
}

std::string WrapFrame(FrameContent content, std::string_view payload) {
  std::string out;
  out.reserve(kFrameHeaderBytes + payload.size());
  out += kMagic;
  out += static_cast<char>(content);
  AppendUint32(static_cast<uint32_t>(payload.size() & UINT32_MAX), out);
  AppendUint32(static_cast<uint32_t>(uint64_t{payload.size()} >> 32), out);
  AppendUint32(Crc32c(payload), out);
  out += payload;
  return out;
}

absl::StatusOr<Frame> UnwrapFrame(std::string_view bytes) {
  if (bytes.size() < kFrameHeaderBytes || bytes.substr(0, kMagic.size()) != kMagic) {
    return absl::InvalidArgumentError("lattice mesh: expected a header that begins with TMLM");
  }
  const uint8_t content = static_cast<uint8_t>(bytes[kContentAt]);
  if (content != static_cast<uint8_t>(FrameContent::kPlain) && content != static_cast<uint8_t>(FrameContent::kDraco)) {
    return absl::InvalidArgumentError(absl::StrCat("lattice mesh: unknown content ", static_cast<int>(content)));
  }
  const std::string_view payload = bytes.substr(kFrameHeaderBytes);
  const uint64_t length = LoadUint32(bytes.data() + kLengthAt) | uint64_t{LoadUint32(bytes.data() + kLengthAt + 4)}
                                                                     << 32;
  if (length != payload.size()) {
    return absl::InvalidArgumentError(
        absl::StrCat("lattice mesh: expected ", length, " bytes after the header, found ", payload.size()));
  }
  if (LoadUint32(bytes.data() + kChecksumAt) != Crc32c(payload)) {
    return absl::InvalidArgumentError("lattice mesh: the checksum does not match");
  }
  return Frame{static_cast<FrameContent>(content), payload};
}

absl::Status CheckCounts(uint64_t points, uint64_t triangles, const DracoLimits& limits) {
  if (points <= static_cast<uint64_t>(limits.max_points) && triangles <= static_cast<uint64_t>(limits.max_triangles)) {
    return absl::OkStatus();
  }
  return absl::ResourceExhaustedError(absl::StrCat("lattice mesh: ", points, " points and ", triangles,
                                                   " triangles are more than ", limits.max_points, " and ",
                                                   limits.max_triangles));
}

absl::StatusOr<DracoCounts> CheckDracoStream(std::string_view stream, const DracoLimits& limits) {
  StreamReader reader(stream);
  // "DRACO", version 2.2, a mesh, sequential, no flags (metadata would be one).
  TILEMEND_RETURN_IF_ERROR(reader.Expect({"DRACO\2\2\1\0\0\0", 11}, "a sequential Draco mesh without metadata"));
  DracoCounts counts;
  TILEMEND_ASSIGN_OR_RETURN(counts.triangles, reader.Varint("the number of triangles"));
  TILEMEND_ASSIGN_OR_RETURN(counts.points, reader.Varint("the number of points"));
  TILEMEND_RETURN_IF_ERROR(CheckCounts(counts.points, counts.triangles, limits));
  if (counts.points == 0) return reader.Error("at least one point");
  TILEMEND_RETURN_IF_ERROR(reader.Expect({"\1", 1}, "plain indices"));
  TILEMEND_RETURN_IF_ERROR(SkipIndices(counts, reader));
  TILEMEND_RETURN_IF_ERROR(CheckAttribute(reader));
  TILEMEND_RETURN_IF_ERROR(CheckCoding(reader));
  return counts;
}

}  // namespace tilemend
