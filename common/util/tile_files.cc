#include "common/util/tile_files.h"

#include <utility>

#include "absl/status/status.h"
#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "common/util/file_pack.h"
#include "common/util/files.h"
#include "common/util/folders.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

constexpr size_t kMostFiles = 10000;  // a limit on mistakes: a tile of seven levels has some 5,500

// The folder of a path, with the slash at its end; empty for a bare name.
std::string FolderWithSlash(const std::string& path) { return path.substr(0, path.rfind('/') + 1); }

}  // namespace

bool IsTileTree(std::string_view path) { return absl::EndsWithIgnoreCase(std::string(path), ".osgb"); }

absl::StatusOr<std::vector<std::string>> FilesOfTile(const std::string& path) {
  const std::string folder = FolderWithSlash(path);
  std::vector<std::string> files{path.substr(folder.size())};
  if (!IsTileTree(path)) return files;
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<std::string> names, ListFolder(folder.empty() ? "." : folder));
  for (const std::string& name : names) {
    if (name == files[0] || !IsTileTree(name) || KindOf(folder + name) != PathKind::kFile) continue;
    files.push_back(name);
    if (files.size() > kMostFiles) {
      return absl::ResourceExhaustedError(absl::StrCat(folder, ": more than ", kMostFiles, " files for one tile"));
    }
  }
  return files;
}

std::string FileBesideTile(const std::string& path, const std::string& name) {
  return absl::StrCat(path.substr(0, path.rfind('/') + 1), name);
}

absl::StatusOr<std::string> ReadTileBytes(const std::string& path) {
  if (!IsTileTree(path)) return ReadFile(path);
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<std::string> names, FilesOfTile(path));
  std::vector<std::string> contents;
  std::vector<PackedFile> files;
  contents.reserve(names.size());
  for (const std::string& name : names) {
    TILEMEND_ASSIGN_OR_RETURN(contents.emplace_back(), ReadFile(FileBesideTile(path, name)));
    files.push_back({name, contents.back()});
  }
  return PackFiles(files);
}

absl::StatusOr<int64_t> SizeOfTile(const std::string& path) {
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<std::string> names, FilesOfTile(path));
  std::vector<PackedFile> empty;
  int64_t size = 0;
  for (const std::string& name : names) {
    TILEMEND_ASSIGN_OR_RETURN(const PathLook look, LookAt(FileBesideTile(path, name)));
    size += look.size;
    empty.push_back({name, {}});
  }
  return IsTileTree(path) ? size + static_cast<int64_t>(PackFiles(empty).size()) : size;
}

}  // namespace tilemend
