#include "worker/materials/scene_file.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "absl/strings/ascii.h"
#include "absl/strings/match.h"

namespace tilemend {
namespace {

namespace fs = std::filesystem;

bool IsAbsolute(std::string_view name) {
  const bool drive = name.size() > 1 && absl::ascii_isalpha(static_cast<unsigned char>(name[0])) && name[1] == ':';
  return drive || name.starts_with('/');
}

bool Exists(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error);
}

// The entry of `folder` that is called `name` but for capital letters; empty if there is none.
std::string EntryLike(const fs::path& folder, const std::string& name) {
  std::string best;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::string entry = at->path().filename().string();
    if (absl::EqualsIgnoreCase(entry, name) && (best.empty() || entry < best)) best = entry;
  }
  return best;
}

}  // namespace

SceneFile FindSceneFile(const std::string& root, const std::string& folder, std::string_view name) {
  if (name.size() > 1 && name.front() == '"' && name.back() == '"') name = name.substr(1, name.size() - 2);
  std::string slashed(name);
  std::replace(slashed.begin(), slashed.end(), '\\', '/');
  if (slashed.empty()) return {"", "is no name"};
  if (slashed.find('\0') != std::string::npos) return {"", "is no name"};
  if (IsAbsolute(slashed)) return {"", "is an absolute path"};
  const fs::path wanted = (fs::path(folder) / slashed).lexically_normal();
  if (wanted.begin() != wanted.end() && *wanted.begin() == "..") return {"", "lies outside the scene's folder"};
  fs::path found;
  for (const fs::path& part : wanted) {
    const std::string entry =
        Exists(fs::path(root) / found / part) ? part.string() : EntryLike(fs::path(root) / found, part.string());
    if (entry.empty()) return {"", "is not there"};
    found /= entry;
  }
  std::error_code error;
  if (!fs::is_regular_file(fs::path(root) / found, error)) return {"", "is no file"};
  return {found.string(), ""};
}

std::string FolderOf(const std::string& path) { return fs::path(path).parent_path().string(); }

}  // namespace tilemend
