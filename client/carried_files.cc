#include "client/carried_files.h"

#include <algorithm>
#include <cstdint>
#include <map>

#include "absl/strings/str_cat.h"
#include "common/codec/mtl.h"
#include "common/util/files.h"

namespace tilemend {

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
  for (const auto* paths : {&files.libraries, &files.images}) {
    for (const std::string& path : *paths) {
      if (seen_.contains(path)) continue;
      const auto before = ReadFile(absl::StrCat(in_, "/", path));
      if (before.ok()) {
        Compare(path, *before, paths == &files.libraries);
      } else {
        seen_.insert(path);
        missing_.push_back(path);
      }
    }
  }
}

void CarriedFiles::Compare(const std::string& path, const std::string& bytes, bool is_library) {
  if (!seen_.insert(path).second) return;
  const auto after = ReadFile(absl::StrCat(out_, "/", path));
  if (!after.ok()) {
    missing_.push_back(path);
    return;
  }
  const bool may_differ = is_library && after->starts_with(bytes) && !DefinesAgain(bytes, *after);
  if (*after != bytes && !may_differ) changed_.push_back(path);
}

}  // namespace tilemend
