#include "coordinator/jobs/scene_files.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <system_error>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "common/store/digest.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

// A file's name has at most 255 bytes; the rest is for what comes behind it.
constexpr size_t kMostStemBytes = 230;

// At most so many bytes, and no part of a character.
std::string FirstBytes(std::string text, size_t most) {
  if (text.size() <= most) return text;
  while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0) == 0x80) --most;
  text.resize(most);
  return text;
}

}  // namespace

std::string FolderInScene(const std::string& out, const std::string& root) {
  std::error_code error;
  const std::filesystem::path relative = std::filesystem::relative(out, root, error);
  return error || relative.empty() || *relative.begin() == ".." ? "" : relative.string();
}

bool SceneFiles::HidesAnother(const std::string& path) const {
  return !output_.empty() && files_.contains((std::filesystem::path(output_) / path).lexically_normal().string());
}

void SceneFiles::Take(CellId cell, const TileFiles& files, bool is_written) {
  for (const std::vector<std::string>* list : {&files.libraries, &files.images}) {
    for (const std::string& path : *list) {
      File& file = files_[path];
      spelt_small_.insert(absl::AsciiStrToLower(path));
      ++file.tiles;
      if (!is_written || (file.first && *file.first <= cell)) continue;
      if (file.first) of_cells_[*file.first].erase(path);
      file.first = cell;
      of_cells_[cell].insert(path);
    }
  }
  if (!files.libraries.empty()) libraries_[cell] = files.libraries;
  if (!files.images.empty()) with_images_.insert(cell);
  Warn(cell, files.warnings);
}

void SceneFiles::Warn(CellId cell, const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) {
    std::string text = Printable(warning.substr(0, kMostFileWarningBytes));
    // Several tasks may read one file.
    const auto [known, is_new] = first_cells_.try_emplace(Sha256Hex(text), cell);
    if (!is_new && !(cell < known->second)) continue;
    if (!is_new) kept_warnings_ -= std::erase(warnings_[known->second], text);
    known->second = cell;
    warnings_[cell].push_back(std::move(text));
    ++kept_warnings_;
    std::erase_if(warnings_, [](const auto& of_cell) { return of_cell.second.empty(); });
    if (kept_warnings_ <= kMostWarnings) continue;
    const auto last = std::prev(warnings_.end());
    last->second.pop_back();
    if (last->second.empty()) warnings_.erase(last);
    --kept_warnings_;
  }
}

std::string SceneFiles::LibraryOf(CellId cell) const {
  const auto libraries = libraries_.find(cell);
  if (libraries == libraries_.end()) return "";
  const auto& paths = libraries->second;
  const auto own = std::find_if(paths.rbegin(), paths.rend(), [&](const std::string& path) {
    return files_.at(path).tiles == 1 && !HidesAnother(path);
  });
  return own == paths.rend() ? "" : *own;
}

std::string SceneFiles::NewFileFor(const std::string& path, absl::string_view ending) const {
  const std::filesystem::path tile(path);
  const std::string stem = (tile.parent_path() / FirstBytes(tile.stem().string(), kMostStemBytes)).string();
  std::string name = absl::StrCat(stem, "_tilemend.", ending);
  const auto is_taken = [&] { return spelt_small_.contains(absl::AsciiStrToLower(name)) || HidesAnother(name); };
  for (int n = 2; is_taken(); ++n) name = absl::StrCat(stem, "_tilemend", n, ".", ending);
  return name;
}

std::vector<std::string> SceneFiles::CarriedBy(CellId cell) const {
  std::vector<std::string> carried;
  const auto paths = of_cells_.find(cell);
  if (paths == of_cells_.end()) return carried;
  const std::string library = LibraryOf(cell);
  for (const std::string& path : paths->second) {
    if (path != library && !HidesAnother(path)) carried.push_back(path);
  }
  return carried;
}

std::set<std::string> SceneFiles::Carried() const {
  std::set<std::string> carried;
  for (const auto& [path, file] : files_) {
    if (file.first && !HidesAnother(path)) carried.insert(path);
  }
  return carried;
}

std::vector<std::string> SceneFiles::Warnings() const {
  std::vector<std::string> warnings;
  int64_t more = std::ssize(first_cells_) - static_cast<int64_t>(kept_warnings_);
  const auto add = [&](std::string warning) {
    if (warnings.size() < kMostWarnings) {
      warnings.push_back(std::move(warning));
    } else {
      ++more;
    }
  };
  for (const auto& [path, file] : files_) {
    if (HidesAnother(path)) {
      add(absl::StrCat(Printable(path), ": would be written over another file of the scene: it is not in the output"));
    }
  }
  for (const auto& [cell, of_cell] : warnings_) {
    for (const std::string& warning : of_cell) add(warning);
  }
  if (more > 0)
    warnings.push_back(absl::StrCat(more, more == 1 ? " more warning" : " more warnings",
                                    " on material files, images and levels of detail"));
  return warnings;
}

}  // namespace tilemend
