#include "worker/materials/scene_file.h"

#include <algorithm>
#include <filesystem>

#include "absl/strings/ascii.h"
#include "absl/strings/match.h"
#include "common/records/output_names.h"
#include "common/util/folders.h"
#include "common/util/real_path.h"

namespace tilemend {
namespace {

namespace fs = std::filesystem;

bool IsAbsolute(std::string_view name) {
  const bool drive = name.size() > 1 && absl::ascii_isalpha(static_cast<unsigned char>(name[0])) && name[1] == ':';
  return drive || name.starts_with('/');
}

bool Exists(const fs::path& path) { return KindOf(path.string()) != PathKind::kNothing; }

// The entry of `folder` that is called `name` but for capital letters; empty if there is none.
std::string EntryLike(const fs::path& folder, const std::string& name) {
  const auto entries = ListFolder(folder.string());
  if (!entries.ok()) return "";
  const auto found = std::find_if(entries->begin(), entries->end(),
                                  [&](const std::string& entry) { return absl::EqualsIgnoreCase(entry, name); });
  return found == entries->end() ? "" : *found;
}

// Whether a link leads from the scene to somewhere else. A folder of tiles may lie there as a whole: who made that link
// wants its files, too.
bool LeadsOut(const fs::path& root, const std::string& folder, const fs::path& found) {
  const fs::path real = RealPath(root / found);
  return !IsBelow(RealPath(root), real) && !IsBelow(RealPath(root / folder), real);
}

}  // namespace

SceneFile FindSceneFile(const std::string& root, const std::string& folder, std::string_view name) {
  if (name.size() > 1 && name.front() == '"' && name.back() == '"') name = name.substr(1, name.size() - 2);
  std::string slashed(name);
  std::replace(slashed.begin(), slashed.end(), '\\', '/');
  if (slashed.empty()) return {"", "is no name"};
  if (slashed.find('\0') != std::string::npos) return {"", "is no name"};
  if (IsAbsolute(slashed) || IsAbsolute(folder)) return {"", "is an absolute path"};
  const fs::path wanted = (fs::path(folder) / slashed).lexically_normal();
  if (wanted.begin() != wanted.end() && *wanted.begin() == "..") return {"", "lies outside the scene's folder"};
  fs::path found;
  for (const fs::path& part : wanted) {
    const std::string entry =
        Exists(fs::path(root) / found / part) ? part.string() : EntryLike(fs::path(root) / found, part.string());
    if (entry.empty()) return {"", "is not there"};
    found /= entry;
  }
  if (KindOf((fs::path(root) / found).string()) != PathKind::kFile) return {"", "is no file"};
  if (LeadsOut(root, folder, found)) return {"", "leads out of the scene's folder by a link"};
  if (IsOutputName(found.string())) return {"", "has the name of a tile or of a file that tilemend writes"};
  return {found.string(), ""};
}

std::string FolderOf(const std::string& path) { return fs::path(path).parent_path().string(); }

}  // namespace tilemend
