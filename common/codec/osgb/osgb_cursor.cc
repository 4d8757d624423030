#include "common/codec/osgb/osgb_cursor.h"

#include <bit>

#include "absl/strings/escaping.h"
#include "absl/strings/str_cat.h"

namespace tilemend {

uint64_t LoadOsgbNumber(const char* bytes, size_t size) {
  uint64_t value = 0;
  for (size_t i = size; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

void OsgbCursor::Fail(size_t offset, std::string_view message) {
  constexpr size_t kMaxShown = 200;  // names in the file can be of any length and hold any bytes
  if (!status_.ok()) return;
  status_ = absl::InvalidArgumentError(
      absl::StrCat(name_, ": byte ", offset, ": ", absl::CHexEscape(std::string(message.substr(0, kMaxShown)))));
}

std::string_view OsgbCursor::Take(size_t size, std::string_view what) {
  if (!ok()) return {};
  if (size > remaining()) {
    Fail(absl::StrCat("expected ", std::string(what), " (", size, " bytes); the file ends after ", remaining()));
    return {};
  }
  offset_ += size;
  return bytes_.substr(offset_ - size, size);
}

uint64_t OsgbCursor::Number(size_t size, std::string_view what) {
  const std::string_view taken = Take(size, what);
  return taken.empty() ? 0 : LoadOsgbNumber(taken.data(), size);
}

bool OsgbCursor::Flag(std::string_view what) { return Number(1, what) != 0; }

uint32_t OsgbCursor::U32(std::string_view what) { return static_cast<uint32_t>(Number(sizeof(uint32_t), what)); }

float OsgbCursor::F32(std::string_view what) { return std::bit_cast<float>(U32(what)); }

double OsgbCursor::F64(std::string_view what) { return std::bit_cast<double>(Number(sizeof(double), what)); }

std::string_view OsgbCursor::String(std::string_view what) { return Take(Count(1, what), what); }

uint32_t OsgbCursor::Count(size_t item_bytes, std::string_view what) {
  const size_t at = offset_;
  const uint32_t count = U32(what);
  if (count <= remaining() / item_bytes) return count;
  Fail(at, absl::StrCat(std::string(what), ": the count of ", count, " is too large for the rest of the file"));
  return 0;
}

void OsgbCursor::Begin(std::string_view what) {
  if (bracket_bytes_ == 0 || !ok()) return;
  const size_t at = offset_;
  const uint64_t size = Number(bracket_bytes_, what);
  if (ok() && (size < bracket_bytes_ || size > bytes_.size() - at)) {
    Fail(at, absl::StrCat(std::string(what), ": a bracket of ", size, " bytes does not fit into the file"));
  }
  brackets_.push_back({at, bracket_});
  bracket_ = static_cast<int32_t>(brackets_.size()) - 1;
}

void OsgbCursor::End(std::string_view what) {
  if (bracket_bytes_ == 0 || !ok()) return;
  const OsgbBracket& bracket = brackets_[static_cast<size_t>(bracket_)];
  const size_t end = bracket.offset + LoadOsgbNumber(bytes_.data() + bracket.offset, bracket_bytes_);
  if (end != offset_) {
    Fail(absl::StrCat(std::string(what), ": the bracket opened at byte ", bracket.offset, " ends at byte ", end));
  }
  bracket_ = bracket.parent;
}

}  // namespace tilemend
