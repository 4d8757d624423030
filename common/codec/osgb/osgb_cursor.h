// A position in an OSGB file, with checked reads.
#ifndef TILEMEND_COMMON_CODEC_OSGB_OSGB_CURSOR_H_
#define TILEMEND_COMMON_CODEC_OSGB_OSGB_CURSOR_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"

namespace tilemend {

// Where the size of a binary bracket stands. The size counts the bytes from its own first byte to the bracket's end.
struct OsgbBracket {
  size_t offset = 0;
  int32_t parent = -1;  // index of the enclosing bracket
};

// The first failure stays: afterwards every read returns zero or an empty text and moves nothing. `what` names the
// value in the message. All numbers are little-endian.
class OsgbCursor {
 public:
  // `name` stands in messages. Both arguments must outlive the cursor.
  OsgbCursor(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  bool ok() const { return status_.ok(); }
  const absl::Status& status() const { return status_; }
  size_t offset() const { return offset_; }
  size_t remaining() const { return bytes_.size() - offset_; }
  std::string_view bytes() const { return bytes_; }

  // Records `message` as the failure at `offset`, unless there is one already.
  void Fail(size_t offset, std::string_view message);
  void Fail(std::string_view message) { Fail(offset_, message); }

  bool Flag(std::string_view what);
  uint32_t U32(std::string_view what);
  int32_t I32(std::string_view what) { return static_cast<int32_t>(U32(what)); }
  float F32(std::string_view what);
  double F64(std::string_view what);
  std::string_view String(std::string_view what);

  // A number of items, each of which takes at least `item_bytes`; fails if the rest of the file cannot hold them.
  uint32_t Count(size_t item_bytes, std::string_view what);

  std::string_view Take(size_t size, std::string_view what);

  // Binary brackets take `size_bytes` (4 or 8) for their size; 0: the file has none, and Begin and End do nothing.
  void SetBracketBytes(size_t size_bytes) { bracket_bytes_ = size_bytes; }
  size_t bracket_bytes() const { return bracket_bytes_; }
  void Begin(std::string_view what);
  void End(std::string_view what);

  // The innermost open bracket as an index into brackets(), -1 outside all.
  int32_t bracket() const { return bracket_; }
  const std::vector<OsgbBracket>& brackets() const { return brackets_; }

 private:
  uint64_t Number(size_t size, std::string_view what);

  const std::string_view bytes_;
  const std::string& name_;
  size_t offset_ = 0;
  absl::Status status_;
  size_t bracket_bytes_ = 0;
  int32_t bracket_ = -1;
  std::vector<OsgbBracket> brackets_;
};

// The number of `size` bytes at `bytes`.
uint64_t LoadOsgbNumber(const char* bytes, size_t size);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_OSGB_OSGB_CURSOR_H_
