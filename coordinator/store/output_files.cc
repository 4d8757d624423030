#include "coordinator/store/output_files.h"

#include <filesystem>

#include "absl/strings/str_cat.h"
#include "common/records/output_names.h"
#include "common/store/file_stamp.h"
#include "common/store/fingerprint.h"
#include "common/util/error_info.h"
#include "common/util/files.h"
#include "common/util/folders.h"
#include "common/util/object_store.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"
#include "coordinator/store/job_marker.h"

namespace tilemend {
namespace {

namespace fs = std::filesystem;

// What is in `folders` of `root`, relative to `root`, but for these folders and that of attempts.
std::vector<std::string> EntriesOf(const std::string& root, const std::set<std::string>& folders) {
  std::vector<std::string> entries;
  for (const std::string& folder : folders) {
    const auto names = ListFolder(absl::StrCat(root, "/", folder));
    for (const std::string& name : names.ok() ? *names : std::vector<std::string>()) {
      std::string entry = folder.empty() ? name : absl::StrCat(folder, "/", name);
      if (name != kAttemptFolder && !folders.contains(entry)) entries.push_back(std::move(entry));
    }
  }
  return entries;
}

// Whether the file of an attempt, at `written`, is the one at `path`.
absl::Status CheckSame(const AttemptFile& file, const std::string& written, const std::string& path) {
  bool same = false;
  if (file.digest.empty()) {
    same = HaveSameContent(written, path);
  } else {
    const auto has_digest = FileHasDigest(path, file.digest);
    if (absl::IsUnavailable(has_digest.status()) || IsStoreError(path, has_digest.status())) return has_digest.status();
    same = has_digest.value_or(false);
  }
  if (same) return absl::OkStatus();
  return WithErrorInfo(
      absl::AlreadyExistsError(absl::StrCat(
          Printable(path), ": is there from an earlier job, and would become another file: a tile, a polygon, the ",
          "program or this file has changed since; give --overwrite to write all cells anew")),
      {"OUTPUT_EXISTS", {}});
}

// A file as it was placed. A hard link to it, as by a backup, changes the stamp and no byte. Errors are those of a
// store or a mount that fails.
absl::StatusOr<bool> IsThere(const std::string& path, int64_t bytes, const std::string& digest,
                             const std::string& stamp) {
  const auto look = LookAt(path, Links::kKeep);
  if (absl::IsUnavailable(look.status()) || IsStoreError(path, look.status())) return look.status();
  if (!look.ok() || look->kind != PathKind::kFile || look->size != bytes) return false;
  if (digest.empty() || HasStamp(path, stamp)) return true;
  const auto is_same = FileHasDigest(path, digest);
  if (absl::IsUnavailable(is_same.status()) || IsStoreError(path, is_same.status())) return is_same.status();
  return is_same.value_or(false);
}

}  // namespace

std::set<std::string> FoldersOf(const std::set<std::string>& files) {
  std::set<std::string> folders;
  for (const std::string& file : files) {
    fs::path at = fs::path(file).parent_path();
    do {
      if (!folders.insert(at.string()).second) break;
      at = at.parent_path();
    } while (!at.empty());
  }
  return folders;
}

void OutputFiles::Adopt(const std::set<std::string>& files) {
  for (const std::string& file : files) files_.try_emplace(file);
}

absl::Status OutputFiles::Place(const std::vector<AttemptFile>& files, const AttemptFolder& attempts) {
  std::vector<std::string> is_new;
  for (const AttemptFile& file : files) {
    if (!own_ || !files_.contains(file.path)) continue;
    TILEMEND_ASSIGN_OR_RETURN(const PathKind kind, FindKind(absl::StrCat(path_, "/", file.path), Links::kKeep));
    if (kind == PathKind::kNothing) is_new.push_back(file.path);
  }
  if (own_) own_->Add(is_new);
  for (const AttemptFile& file : files) {
    if (!files_.contains(file.path)) continue;  // Keep says so
    const std::string written = absl::StrCat(attempts.path(), "/", file.attempt);
    const bool is_left = own_ && !own_->Has(file.path);
    TILEMEND_RETURN_IF_ERROR(is_left ? CheckSame(file, written, absl::StrCat(path_, "/", file.path))
                                     : attempts.Place(file, path_));
  }
  return Keep(files);
}

absl::Status OutputFiles::Keep(const std::vector<AttemptFile>& files) {
  for (const AttemptFile& file : files) {
    const auto known = files_.find(file.path);
    if (known == files_.end()) {
      return absl::InvalidArgumentError(absl::StrCat(Printable(file.path), ": no file of this output"));
    }
    known->second = {file.bytes, file.digest, YoungStampOf(absl::StrCat(path_, "/", file.path))};
  }
  return absl::OkStatus();
}

absl::Status OutputFiles::RemoveUnwritten(const std::string& file) const {
  return own_ && !own_->Has(file) ? absl::OkStatus() : RemoveFile(absl::StrCat(path_, "/", file));
}

absl::Status OutputFiles::SeeAll(const std::function<bool()>& ends) const {
  int64_t missing = 0, placed = 0;
  std::string first;
  std::set<std::string> folders;
  for (const auto& [file, was] : files_) {
    if (was.bytes < 0) continue;
    if (ends()) return absl::CancelledError("asked to end while the output was looked at");
    ++placed;
    const fs::path path = fs::path(path_) / file;
    folders.insert(path.parent_path().string());
    TILEMEND_ASSIGN_OR_RETURN(const bool is_there, IsThere(path.string(), was.bytes, was.digest, was.stamp));
    if (is_there) continue;
    if (missing++ == 0) first = path.string();
  }
  if (missing > 0) {
    const absl::Status changed = absl::AbortedError(
        absl::StrCat(Printable(first), ": not there as it was written, as ", missing, " of ", placed,
                     " files of the output; was something removed or changed while the job ran? Run the job again"));
    return WithErrorInfo(changed, {"OUTPUT_CHANGED", {{"file", Printable(first)}}});
  }
  for (const std::string& folder : folders) TILEMEND_RETURN_IF_ERROR(SyncFolder(folder));
  return absl::OkStatus();
}

int64_t OutputFiles::TidyUp() {
  std::set<std::string> files;
  for (const auto& [file, placed] : files_) files.insert(file);
  std::set<std::string> folders = FoldersOf(files);
  folders.insert("");
  int64_t others = 0;
  for (const std::string& file : EntriesOf(path_, folders)) {
    if (file == kJobMarker || file.starts_with(kResultLog) || files_.contains(file)) continue;
    const size_t suffix = file.rfind(kPartSuffix);
    if (suffix != std::string::npos && files_.contains(file.substr(0, suffix))) {
      RemoveFile(absl::StrCat(path_, "/", file)).IgnoreError();
    } else {
      ++others;
    }
  }
  return others;
}

}  // namespace tilemend
