#include "coordinator/store/output_folder.h"

#include <algorithm>
#include <filesystem>

#include "absl/strings/str_cat.h"
#include "common/records/output_names.h"
#include "common/util/error_info.h"
#include "common/util/files.h"
#include "common/util/folders.h"
#include "common/util/object_store.h"
#include "common/util/real_path.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"
#include "common/util/tile_files.h"

namespace tilemend {
namespace {

namespace fs = std::filesystem;

// A folder without the links on its path and, if it is there, its number. Two mounts of one folder have two paths.
class FolderSet {
 public:
  void Insert(const fs::path& folder) {
    paths_.insert(RealPath(folder));
    if (const auto id = IdOf(folder)) ids_.insert(*id);
  }
  bool Contains(const fs::path& real) const {
    if (paths_.contains(real)) return true;
    const auto id = IdOf(real);
    return id && ids_.contains(*id);
  }

 private:
  std::set<fs::path> paths_;
  std::set<FileId> ids_;
};

std::set<fs::path> RealFolders(const fs::path& root, const std::set<std::string>& relative) {
  std::set<fs::path> folders;
  for (const std::string& folder : relative) folders.insert(RealPath(folder.empty() ? root : root / folder));
  return folders;
}

// Whether nothing of the output would lie among the scene's files.
absl::Status CheckApart(const std::string& path, const Scene& scene, const std::set<std::string>& files) {
  const fs::path root = RealPath(scene.root);
  std::set<std::string> inputs;
  for (const SceneTile& tile : scene.tiles) {
    if (!tile.path.empty()) inputs.insert(tile.path);
  }
  FolderSet sources, scene_folder;
  scene_folder.Insert(root);
  if (scene.found_by_name && std::ranges::none_of(scene.tiles, IsTileset, &SceneTile::path)) {
    sources.Insert(root);  // the next search there would find the output's tiles too
  }
  for (const std::string& folder : FoldersOf(inputs)) {
    // Beside tiles that lie in the scene's folder itself, a folder of its own does no harm.
    if (!scene_folder.Contains(RealPath(root / folder))) sources.Insert(root / folder);
  }
  std::set<fs::path> targets = RealFolders(path, FoldersOf(files)), above;
  targets.insert(RealPath(path));
  for (const fs::path& target : targets) {
    for (fs::path at = target; above.insert(at).second && at.has_relative_path();) at = at.parent_path();
  }
  for (const fs::path& folder : above) {
    if (!sources.Contains(folder) && !(targets.contains(folder) && scene_folder.Contains(folder))) continue;
    return absl::InvalidArgumentError(absl::StrCat(path, ": the output would lie among the tiles of the scene, in ",
                                                   folder.string(),
                                                   "; choose another --out, apart from the scene's folders of tiles"));
  }
  return absl::OkStatus();
}

// Whether the folder holds nothing, or an unfinished output of the job `key`.
absl::Status CheckVacant(const std::string& path, const std::string& key) {
  const auto names = ListFolder(path);
  if (absl::IsPermissionDenied(names.status())) {
    return absl::PermissionDeniedError(absl::StrCat(std::string(names.status().message()), "; choose another --out"));
  }
  if (!names.ok() && !absl::IsNotFound(names.status())) return names.status();
  const bool empty = !names.ok() || std::all_of(names->begin(), names->end(), [](const std::string& name) {
    return name == kJobMarker || name == kAttemptFolder || name == kResultLog;
  });
  const auto marker = ReadFile(absl::StrCat(path, "/", kJobMarker));
  if (!marker.ok() && !absl::IsNotFound(marker.status())) return marker.status();
  if (marker.ok() && *marker == key) return absl::OkStatus();
  // A path that cannot be shows when it is made. A marker without a key is of a job that has not claimed the folder
  // yet.
  if (empty && (!marker.ok() || marker->empty())) return absl::OkStatus();
  // Files that no job wrote are nothing to decide on.
  const bool has_output = names.ok() && std::ranges::find(*names, kReportFiles[0]) != names->end();
  return absl::AlreadyExistsError(absl::StrCat(
      path, ": exists already",
      marker.ok() ? ", an unfinished output of a job with another scene or other options" : "",
      "; choose another --out, ", has_output ? "" : "or ", "give --overwrite to replace the files that the job writes",
      has_output ? ", or --decisions FILE to do only the holes again that a reviewer decided on" : ""));
}

// That `found` is in the way of what the job would make.
absl::Status InTheWay(const std::string& path, PathKind found, PathKind wanted) {
  const std::string what = found == PathKind::kFolder ? "a folder"
                           : found == PathKind::kFile ? "a file"
                                                      : "a link, a pipe or a device";
  return absl::InvalidArgumentError(absl::StrCat(Printable(path), ": ", what, " where the job makes a ",
                                                 wanted == PathKind::kFolder ? "folder" : "file",
                                                 "; remove it, or choose another --out"));
}

// Whether nothing else, a link neither, is where the job would make a file or a folder of its own.
absl::Status CheckName(const std::string& path, PathKind wanted) {
  const auto look = LookAt(path, Links::kKeep);
  if (!look.ok() || look->kind == wanted) return absl::OkStatus();  // what cannot be looked at shows when it is made
  return InTheWay(path, look->kind, wanted);
}

// The same for all that the job makes in a folder.
absl::Status CheckNames(const std::string& path, const std::set<std::string>& files) {
  TILEMEND_ASSIGN_OR_RETURN(const PathKind kind, FindKind(path));
  if (kind == PathKind::kNothing) return absl::OkStatus();
  const std::string folder = path + "/";
  TILEMEND_RETURN_IF_ERROR(CheckName(folder + kJobMarker, PathKind::kFile));
  TILEMEND_RETURN_IF_ERROR(CheckName(folder + kResultLog, PathKind::kFile));
  TILEMEND_RETURN_IF_ERROR(CheckName(folder + kAttemptFolder, PathKind::kFolder));
  std::set<std::string> parents;
  for (const std::string& file : files) {
    // Anything but a folder is replaced, a link itself.
    const auto look = LookAt(folder + file, Links::kKeep);
    if (look.ok() && look->kind == PathKind::kFolder) return InTheWay(folder + file, look->kind, PathKind::kFile);
    for (fs::path at = fs::path(file).parent_path(); !at.empty(); at = at.parent_path()) {
      if (!parents.insert(at.string()).second) break;
    }
  }
  for (const std::string& parent : parents) TILEMEND_RETURN_IF_ERROR(CheckName(folder + parent, PathKind::kFolder));
  return absl::OkStatus();
}

absl::Status CheckScheme(const std::string& path) {
  if (path.find("://") == std::string::npos || IsObjectPath(path)) return absl::OkStatus();
  return absl::InvalidArgumentError(absl::StrCat(path, ": this release writes to folders and to s3://BUCKET/PREFIX"));
}

absl::Status CheckFolder(const std::string& path) {
  const auto kind = FindKind(path);
  if (absl::IsInvalidArgument(kind.status())) {
    return absl::InvalidArgumentError(absl::StrCat(std::string(kind.status().message()), "; choose another --out"));
  }
  TILEMEND_RETURN_IF_ERROR(kind.status());
  if (*kind == PathKind::kNothing || *kind == PathKind::kFolder) return absl::OkStatus();
  return absl::InvalidArgumentError(absl::StrCat(path, ": the output is a file, not a folder; choose another --out"));
}

// Those that are, the innermost first; they come the outermost first.
void RemoveEmptyFolders(std::vector<std::string> folders) {
  std::reverse(folders.begin(), folders.end());
  for (const std::string& folder : folders) RemoveEmptyFolder(folder).IgnoreError();
}

// Makes the folders of `path` that are missing; gives them, the outermost first.
absl::StatusOr<std::vector<std::string>> MakeFolders(const std::string& path) {
  std::vector<std::string> missing;
  if (IsObjectPath(path)) return missing;
  for (fs::path at = path; at.has_relative_path() && KindOf(at.string()) == PathKind::kNothing; at = at.parent_path()) {
    missing.push_back(at.string());
  }
  std::reverse(missing.begin(), missing.end());
  std::vector<std::string> made;
  for (const std::string& folder : missing) {
    const absl::Status status = MakeFolder(folder);
    if (!status.ok()) {
      RemoveEmptyFolders(made);
      return absl::Status(status.code(), absl::StrCat(std::string(status.message()), "; choose another --out"));
    }
    made.push_back(folder);
  }
  return made;
}

// Whether there is nothing in the folder that a job, run again, could know as done.
bool IsBare(const std::string& folder, const AttemptFolder& attempt_folder) {
  const auto names = ListFolder(folder), attempts = ListFolder(attempt_folder.path());
  const std::set<std::string> hidden = {kJobMarker, kAttemptFolder, kResultLog};
  return names.ok() && attempts.ok() && attempts->size() <= 1 &&
         std::all_of(names->begin(), names->end(), [&](const std::string& name) { return hidden.contains(name); });
}

}  // namespace

absl::StatusOr<OutputFolder> OutputFolder::Claim(const std::string& path, const Scene& scene, bool overwrite,
                                                 const std::string& key) {
  TILEMEND_RETURN_IF_ERROR(CheckScheme(path));
  TILEMEND_RETURN_IF_ERROR(CheckFolder(path));
  std::set<std::string> files;
  for (const SceneTile& tile : scene.tiles) files.insert(OutputPath(tile));
  TILEMEND_RETURN_IF_ERROR(CheckApart(path, scene, files));
  if (!overwrite) TILEMEND_RETURN_IF_ERROR(CheckVacant(path, key));
  files.insert(kSceneFile);
  if (KindOf(absl::StrCat(scene.root, "/", kMetadataFile)) == PathKind::kFile) files.insert(kMetadataFile);
  if (!scene.tileset.empty()) files.insert(scene.tileset);
  files.insert(std::begin(kReportFiles), std::end(kReportFiles));
  TILEMEND_RETURN_IF_ERROR(CheckNames(path, files));
  OutputFolder folder(path, key);
  folder.files_.Adopt(files);
  TILEMEND_ASSIGN_OR_RETURN(folder.made_, MakeFolders(path));
  auto marker = JobMarker::Take(path);
  folder.keep_ = ErrorReason(marker.status()) == "OUTPUT_IN_USE" || (marker.ok() && (*marker)->had_key());
  TILEMEND_RETURN_IF_ERROR(marker.status());
  folder.marker_ = *std::move(marker);
  if (!overwrite) {
    TILEMEND_RETURN_IF_ERROR(CheckVacant(path, key));  // another job may have ended here since
    if (!folder.keep_) TILEMEND_RETURN_IF_ERROR(folder.marker_->Write(key));
  }
  TILEMEND_ASSIGN_OR_RETURN(folder.attempts_, AttemptFolder::Make(path));
  return folder;
}

OutputFolder::OutputFolder(OutputFolder&& other) noexcept
    : path_(std::exchange(other.path_, "")),
      key_(std::move(other.key_)),
      files_(std::move(other.files_)),
      made_(std::move(other.made_)),
      marker_(std::move(other.marker_)),
      keep_(other.keep_),
      wrote_(other.wrote_),
      attempts_(std::exchange(other.attempts_, std::nullopt)) {}

OutputFolder::~OutputFolder() {
  if (path_.empty()) return;
  if (!keep_ || (!wrote_ && attempts_ && IsBare(path_, *attempts_))) {
    if (attempts_) attempts_->Remove();
    if (marker_) marker_->Remove();
    RemoveEmptyFolders(made_);
  }
}

absl::Status OutputFolder::BeginWriting() {
  TILEMEND_RETURN_IF_ERROR(marker_->Write(key_));
  keep_ = wrote_ = true;
  // An old report beside new tiles would tell of them as if they were complete.
  for (const char* file : kReportFiles) TILEMEND_RETURN_IF_ERROR(RemoveFile(absl::StrCat(path_, "/", file)));
  return absl::OkStatus();
}

absl::Status OutputFolder::CheckRoomFor(const std::set<std::string>& files) const { return CheckNames(path_, files); }

bool OutputFolder::has_report() const {
  return KindOf(absl::StrCat(path_, "/", kReportFiles[0])) != PathKind::kNothing;
}

std::string OutputFolder::result_log() const { return absl::StrCat(path_, "/", kResultLog); }

void OutputFolder::Finish() {
  keep_ = wrote_ = true;
  attempts_->Remove();
  marker_->Remove();
}

}  // namespace tilemend
