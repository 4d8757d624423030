#include "common/records/output_names.h"

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "absl/strings/match.h"
#include "common/grid/scene_sources.h"
#include "common/util/tile_files.h"

namespace tilemend {

bool IsOutputName(const std::string& path) {
  const std::filesystem::path normal = std::filesystem::path(path).lexically_normal();
  if (normal.empty()) return false;
  const std::string name = normal.filename().string(), first = normal.begin()->string();
  if ((IsTileFormat(name) && !IsTileTree(name)) || absl::StartsWithIgnoreCase(first, kHiddenPrefix)) return true;
  const auto is_first = [&](const char* own) { return absl::EqualsIgnoreCase(first, own); };
  return std::any_of(std::begin(kReportFiles), std::end(kReportFiles), is_first) || is_first(kSceneFile) ||
         is_first(kMetadataFile);
}

}  // namespace tilemend
