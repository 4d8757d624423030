#include "client/carried_files.h"

#include <algorithm>
#include <cstdint>
#include <map>

#include "absl/strings/str_cat.h"
#include "common/codec/mtl.h"
#include "common/util/files.h"

namespace tilemend {

CarriedState CompareFiles(const std::string& in, const std::string& out, bool may_be_longer) {
  const auto before = ReadFile(in), after = ReadFile(out);
  if (!before.ok() || !after.ok()) return CarriedState::kMissing;
  const bool goes_on = after->starts_with(*before) && (may_be_longer || after->size() == before->size());
  return goes_on ? CarriedState::kSame : CarriedState::kChanged;
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
