#include "worker/materials/scene_file.h"

#include <algorithm>
#include <filesystem>

#include "absl/strings/ascii.h"
#include "absl/strings/match.h"
#include "common/records/output_names.h"
#include "common/util/folders.h"
#include "common/util/object_store.h"
#include "common/util/real_path.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

namespace fs = std::filesystem;

bool IsAbsolute(std::string_view name) {
  const bool drive = name.size() > 1 && absl::ascii_isalpha(static_cast<unsigned char>(name[0])) && name[1] == ':';
  return drive || name.starts_with('/');
}

// Of a file system, what cannot be looked at is not there.
absl::StatusOr<PathKind> KindAt(const fs::path& path) {
  const auto look = LookAt(path.string());
  if (look.ok()) return look->kind;
  if (IsStoreError(path.string(), look.status())) return look.status();
  return PathKind::kNothing;
}

// The entry of `folder` that is called `name` but for capital letters; empty if there is none.
absl::StatusOr<std::string> EntryLike(const fs::path& folder, const std::string& name) {
  const auto entries = ListFolder(folder.string());
  if (IsStoreError(folder.string(), entries.status())) return entries.status();
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

absl::StatusOr<SceneFile> FindSceneFile(const std::string& root, const std::string& folder, std::string_view name) {
  if (name.size() > 1 && name.front() == '"' && name.back() == '"') name = name.substr(1, name.size() - 2);
  std::string slashed(name);
  std::replace(slashed.begin(), slashed.end(), '\\', '/');
  if (slashed.empty()) return SceneFile{"", "is no name"};
  if (slashed.find('\0') != std::string::npos) return SceneFile{"", "is no name"};
  if (IsAbsolute(slashed) || IsAbsolute(folder)) return SceneFile{"", "is an absolute path"};
  const fs::path wanted = (fs::path(folder) / slashed).lexically_normal();
  if (wanted.begin() != wanted.end() && *wanted.begin() == "..")
    return SceneFile{"", "lies outside the scene's folder"};
  fs::path found;
  PathKind kind = PathKind::kFolder;  // of it
  for (const fs::path& part : wanted) {
    TILEMEND_ASSIGN_OR_RETURN(kind, KindAt(fs::path(root) / found / part));
    std::string entry = part.string();
    if (kind == PathKind::kNothing) {
      TILEMEND_ASSIGN_OR_RETURN(entry, EntryLike(fs::path(root) / found, entry));
      if (entry.empty()) return SceneFile{"", "is not there"};
      TILEMEND_ASSIGN_OR_RETURN(kind, KindAt(fs::path(root) / found / entry));
    }
    found /= entry;
  }
  if (kind != PathKind::kFile) return SceneFile{"", "is no file"};
  if (LeadsOut(root, folder, found)) return SceneFile{"", "leads out of the scene's folder by a link"};
  if (IsOutputName(found.string())) return SceneFile{"", "has the name of a tile or of a file that tilemend writes"};
  return SceneFile{found.string(), ""};
}

std::string FolderOf(const std::string& path) { return fs::path(path).parent_path().string(); }

}  // namespace tilemend
