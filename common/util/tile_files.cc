#include "common/util/tile_files.h"

#include <algorithm>
#include <cstring>
#include <iterator>

#include "absl/status/status.h"
#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "common/util/file_pack.h"
#include "common/util/files.h"
#include "common/util/folders.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

// The program's own files of this kind.
constexpr const char* kNoTilesets[] = {"scene.json", "report.json", "acceptance.json"};
constexpr int64_t kMostFolders = 16;
constexpr size_t kMostFiles = 10000;  // a limit on mistakes: a tile of seven levels has some 5,500

// The folder of a path, with the slash at its end; empty for a bare name.
std::string FolderWithSlash(const std::string& path) { return path.substr(0, path.rfind('/') + 1); }

bool EndsIn(std::string_view text, std::string_view end) {
  return absl::EndsWithIgnoreCase(std::string(text), std::string(end));
}

// What models may name in place of images of their own.
bool IsImage(std::string_view path) {
  constexpr const char* kImages[] = {".jpg", ".jpeg", ".png", ".webp", ".ktx2"};
  return std::any_of(std::begin(kImages), std::end(kImages), [&](const char* end) { return EndsIn(path, end); });
}

// Adds the files of the tree whose own file `own` lies in `root`, and that lie in its folder `below`, which ends with a
// slash if it is not empty.
absl::Status AddFiles(const std::string& root, const std::string& below, const std::string& own,
                      std::vector<std::string>& files) {
  const std::string folder = absl::StrCat(root, below);
  if (std::count(below.begin(), below.end(), '/') > kMostFolders) {
    return absl::ResourceExhaustedError(absl::StrCat(folder, ": folders more than ", kMostFolders, " deep"));
  }
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<FolderEntry> entries, ListKinds(folder.empty() ? "." : folder));
  for (const auto& [name, kind] : entries) {
    const std::string file = absl::StrCat(below, name);
    if (file == own || name.starts_with('.')) continue;
    const bool is_of_tree = IsFileOfTree(own, file) || (IsTileset(own) && IsImage(name));
    if (is_of_tree && kind == PathKind::kFile) {
      files.push_back(file);
      if (files.size() < kMostFiles) continue;
      return absl::ResourceExhaustedError(absl::StrCat(root, ": more than ", kMostFiles, " files for one tile"));
    }
    if (!IsTileset(own) || kind != PathKind::kFolder) continue;
    const auto look = LookAt(root + file, Links::kKeep);
    if (look.ok() && look->kind == PathKind::kFolder) {
      TILEMEND_RETURN_IF_ERROR(AddFiles(root, file + "/", own, files));
    }
  }
  return absl::OkStatus();
}

}  // namespace

bool IsTileset(std::string_view path) {
  const std::string_view name = path.substr(path.rfind('/') + 1);
  const auto is_own = [&](const char* own) { return absl::EqualsIgnoreCase(std::string(name), own); };
  return EndsIn(name, ".json") && std::none_of(std::begin(kNoTilesets), std::end(kNoTilesets), is_own);
}

bool IsTileTree(std::string_view path) { return EndsIn(path, ".osgb") || IsTileset(path); }

bool HasLevelsOfDetail(std::string_view format) { return format == "osgb" || format == "3dtiles"; }

bool IsTreeFile(std::string_view path) { return IsTileTree(path) || EndsIn(path, ".b3dm") || EndsIn(path, ".glb"); }

bool IsFileOfTree(std::string_view tile, std::string_view path) {
  const std::string_view folder = tile.substr(0, tile.rfind('/') + 1);
  if (!path.starts_with(folder) || !IsTreeFile(path)) return false;
  const std::string_view name = path.substr(folder.size());
  if (IsTileset(tile))
    return !EndsIn(path, ".osgb") && !name.starts_with('.') && name.find("/.") == std::string_view::npos;
  return EndsIn(path, ".osgb") && name.find('/') == std::string_view::npos;
}

absl::StatusOr<std::vector<std::string>> FilesOfTile(const std::string& path) {
  const std::string folder = FolderWithSlash(path);
  const std::string own = path.substr(folder.size());
  std::vector<std::string> files;
  if (IsTileTree(path)) TILEMEND_RETURN_IF_ERROR(AddFiles(folder, "", own, files));
  std::sort(files.begin(), files.end());
  files.insert(files.begin(), own);
  return files;
}

std::string FileBesideTile(const std::string& path, const std::string& name) {
  return absl::StrCat(path.substr(0, path.rfind('/') + 1), name);
}

absl::StatusOr<std::string> ReadTileBytes(const std::string& path, const TileFrame& frame) {
  if (!IsTileTree(path)) return ReadFile(path);
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<std::string> names, FilesOfTile(path));
  std::vector<std::string> contents;
  std::vector<PackedFile> files;
  contents.reserve(names.size());
  for (const std::string& name : names) {
    TILEMEND_ASSIGN_OR_RETURN(contents.emplace_back(), ReadFile(FileBesideTile(path, name)));
    files.push_back({name, contents.back()});
  }
  if (IsTileset(path) && !frame.empty()) {
    files.push_back({kFrameFile, {reinterpret_cast<const char*>(frame.data()), frame.size() * sizeof(double)}});
  }
  return PackFiles(files);
}

TileFrame FrameIn(std::string_view bytes) {
  constexpr size_t kNumbers = 16;
  TileFrame frame;
  if (bytes.size() != kNumbers * sizeof(double)) return frame;
  frame.resize(kNumbers);
  std::memcpy(frame.data(), bytes.data(), bytes.size());
  return frame;
}

absl::StatusOr<int64_t> SizeOfTile(const std::string& path, const TileFrame& frame) {
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<std::string> names, FilesOfTile(path));
  std::vector<PackedFile> empty;
  int64_t size = 0;
  for (const std::string& name : names) {
    TILEMEND_ASSIGN_OR_RETURN(const PathLook look, LookAt(FileBesideTile(path, name)));
    size += look.size;
    empty.push_back({name, {}});
  }
  if (IsTileset(path) && !frame.empty()) {
    size += static_cast<int64_t>(frame.size() * sizeof(double));
    empty.push_back({kFrameFile, {}});
  }
  return IsTileTree(path) ? size + static_cast<int64_t>(PackFiles(empty).size()) : size;
}

}  // namespace tilemend
