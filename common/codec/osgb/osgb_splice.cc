#include "common/codec/osgb/osgb_splice.h"

#include <limits>

#include "absl/strings/str_cat.h"

namespace tilemend {
namespace {

void StoreNumber(uint64_t value, size_t size, char* to) {
  for (size_t i = 0; i < size; ++i, value >>= 8) to[i] = static_cast<char>(value & 0xff);
}

}  // namespace

OsgbSplice::OsgbSplice(std::string_view bytes, const OsgbLayout& layout)
    : layout_(layout), bytes_(bytes), growth_(layout.brackets.size()) {}

void OsgbSplice::SetNumber(size_t offset, uint32_t value) { StoreNumber(value, sizeof(value), bytes_.data() + offset); }

void OsgbSplice::Replace(size_t offset, size_t removed, std::string_view text, int32_t bracket) {
  edits_.push_back({offset, removed, std::string(text)});
  if (bracket < 0) return;
  growth_[static_cast<size_t>(bracket)] += static_cast<int64_t>(text.size()) - static_cast<int64_t>(removed);
}

absl::StatusOr<std::string> OsgbSplice::Finish(const std::string& name) && {
  const size_t size_bytes = layout_.bracket_bytes;
  for (size_t i = growth_.size(); i-- > 0;) {  // parents come before their children
    if (growth_[i] == 0) continue;
    const OsgbBracket& bracket = layout_.brackets[i];
    const uint64_t size = LoadOsgbNumber(bytes_.data() + bracket.offset, size_bytes);
    StoreNumber(size + static_cast<uint64_t>(growth_[i]), size_bytes, bytes_.data() + bracket.offset);
    if (bracket.parent >= 0) growth_[static_cast<size_t>(bracket.parent)] += growth_[i];
  }
  size_t size = bytes_.size();
  for (const Edit& edit : edits_) size += edit.text.size() - edit.removed;
  if (size > std::numeric_limits<int32_t>::max()) {
    return absl::InvalidArgumentError(absl::StrCat(name, ": the file would be over 2 GiB"));
  }
  std::string out;
  out.reserve(size);
  size_t at = 0;
  for (const Edit& edit : edits_) {
    out.append(bytes_, at, edit.offset - at);
    out += edit.text;
    at = edit.offset + edit.removed;
  }
  out.append(bytes_, at);
  return out;
}

}  // namespace tilemend
