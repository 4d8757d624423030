#include "common/util/file_pack.h"

#include <cstdint>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"

namespace tilemend {
namespace {

constexpr std::string_view kMagic = "tilemend pack 1\n";

void AppendSize(size_t size, std::string& text) {
  const uint64_t value = size;
  for (int shift = 0; shift < 64; shift += 8) text.push_back(static_cast<char>((value >> shift) & 0xff));
}

// Takes a size and as many bytes off the front; false if there are fewer.
bool TakeSized(std::string_view& rest, std::string_view& taken) {
  if (rest.size() < 8) return false;
  uint64_t size = 0;
  for (int k = 0; k < 8; ++k) size |= uint64_t{static_cast<unsigned char>(rest[k])} << (8 * k);
  rest.remove_prefix(8);
  if (size > rest.size()) return false;
  taken = rest.substr(0, size);
  rest.remove_prefix(size);
  return true;
}

}  // namespace

std::string PackFiles(const std::vector<PackedFile>& files) {
  std::string pack(kMagic);
  size_t bytes = pack.size();
  for (const PackedFile& file : files) bytes += 16 + file.name.size() + file.bytes.size();
  pack.reserve(bytes);
  for (const PackedFile& file : files) {
    AppendSize(file.name.size(), pack);
    pack.append(file.name);
    AppendSize(file.bytes.size(), pack);
    pack.append(file.bytes);
  }
  return pack;
}

bool IsFilePack(std::string_view bytes) { return bytes.starts_with(kMagic); }

absl::StatusOr<std::vector<PackedFile>> UnpackFiles(std::string_view bytes, const std::string& name) {
  std::vector<PackedFile> files;
  std::string_view rest = bytes;
  bool is_whole = IsFilePack(bytes);
  if (is_whole) rest.remove_prefix(kMagic.size());
  while (is_whole && !rest.empty()) {
    std::string_view file_name;
    std::string_view content;
    is_whole = TakeSized(rest, file_name) && TakeSized(rest, content);
    if (is_whole) files.push_back({std::string(file_name), content});
  }
  if (is_whole && !files.empty()) return files;
  return absl::InvalidArgumentError(
      absl::StrCat(name, ": at byte ", bytes.size() - rest.size(), ": not the files of a tile"));
}

}  // namespace tilemend
