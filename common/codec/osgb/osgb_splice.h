// Insertions into the bytes of an OSGB file and removals from them.
#ifndef TILEMEND_COMMON_CODEC_OSGB_OSGB_SPLICE_H_
#define TILEMEND_COMMON_CODEC_OSGB_OSGB_SPLICE_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/codec/osgb/osgb_parse.h"

namespace tilemend {

class OsgbSplice {
 public:
  // Both must outlive the splice; `layout` is that of `bytes`.
  OsgbSplice(std::string_view bytes, const OsgbLayout& layout);

  // Overwrites the 32-bit number at `offset`.
  void SetNumber(size_t offset, uint32_t value);

  // Puts `text` in place of the `removed` bytes at `offset`. `bracket` is the innermost that encloses them, -1 for
  // none. Offsets do not descend from call to call, and removed ranges do not overlap.
  void Replace(size_t offset, size_t removed, std::string_view text, int32_t bracket);

  // The new bytes, with the sizes of all enclosing brackets. kInvalidArgument, with `name`, if they are over 2 GiB.
  // Linear.
  absl::StatusOr<std::string> Finish(const std::string& name) &&;

 private:
  struct Edit {
    size_t offset = 0;
    size_t removed = 0;
    std::string text;
  };

  const OsgbLayout& layout_;
  std::string bytes_;  // with the new numbers
  std::vector<Edit> edits_;
  std::vector<int64_t> growth_;  // of each bracket in bytes
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_CODEC_OSGB_OSGB_SPLICE_H_
