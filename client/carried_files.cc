#include "client/carried_files.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <map>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/codec/mtl.h"
#include "common/util/files.h"

namespace tilemend {
namespace {

constexpr size_t kPiece = 1 << 16;  // bytes read at once

// Reads up to `piece.size()` bytes; gives how many.
size_t Fill(std::ifstream& file, std::vector<char>& piece) {
  file.read(piece.data(), static_cast<std::streamsize>(piece.size()));
  return static_cast<size_t>(file.gcount());
}

}  // namespace

CarriedState CompareFiles(const std::string& in, const std::string& out, bool may_be_longer) {
  std::ifstream a(in, std::ios::binary), b(out, std::ios::binary);
  if (!a || !b) return CarriedState::kMissing;
  std::vector<char> piece_a(kPiece), piece_b(kPiece);
  while (true) {
    const size_t read_a = Fill(a, piece_a), read_b = Fill(b, piece_b);
    const size_t both = std::min(read_a, read_b);
    if (read_b < read_a ||
        !std::equal(piece_a.begin(), piece_a.begin() + static_cast<ptrdiff_t>(both), piece_b.begin()))
      return CarriedState::kChanged;
    if (read_a < kPiece) return read_b == read_a || may_be_longer ? CarriedState::kSame : CarriedState::kChanged;
  }
}

bool DefinesAgain(const std::string& before, const std::string& after) {
  if (after.size() == before.size()) return false;
  std::map<std::string, int64_t> more;  // of definitions in `after`
  const std::vector<MtlMaterial> known = ParseMtl(before).materials;
  for (const MtlMaterial& material : known) --more[material.name];
  for (const MtlMaterial& material : ParseMtl(after).materials) {
    if (const auto found = more.find(material.name); found != more.end()) ++found->second;
  }
  return std::ranges::any_of(more, [](const auto& material) { return material.second > 0; });
}

void CarriedFiles::Compare(const TileFiles& files) {
  for (const std::string& path : files.libraries) CompareOne(path, true);
  for (const std::string& path : files.images) CompareOne(path, false);
}

void CarriedFiles::CompareOne(const std::string& path, bool is_library) {
  if (!seen_.insert(path).second) return;
  const std::string in = absl::StrCat(in_, "/", path), out = absl::StrCat(out_, "/", path);
  CarriedState state = CompareFiles(in, out, is_library);
  if (state == CarriedState::kSame && is_library) {
    const auto before = ReadFile(in), after = ReadFile(out);
    if (before.ok() && after.ok() && DefinesAgain(*before, *after)) state = CarriedState::kChanged;
  }
  if (state == CarriedState::kMissing) missing_.push_back(path);
  if (state == CarriedState::kChanged) changed_.push_back(path);
}

}  // namespace tilemend
