#include "client/output_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>
#include <utility>

#include "absl/strings/str_cat.h"
#include "client/progress_display.h"
#include "common/util/error_info.h"
#include "common/util/exit_codes.h"
#include "common/util/files.h"
#include "common/util/folders.h"
#include "common/util/place.h"
#include "common/util/status_macros.h"
#include "coordinator/report/json_access.h"
#include "coordinator/report/shallow_json.h"

namespace tilemend {

namespace fs = std::filesystem;

namespace {

// Opens the lock file of the output `path`, and makes it if it is missing.
absl::StatusOr<int> OpenLock(const std::string& file, const std::string& path) {
  constexpr int kFlags = O_CLOEXEC | O_NOFOLLOW;
  int fd = ::open(file.c_str(), O_RDWR | O_CREAT | kFlags, 0644);
  if (fd >= 0) return fd;
  if (errno != EACCES) return WithOtherOut(WriteErrnoStatus(errno, "cannot write there", path));
  // A killed process of another user may have left it; a lock needs no right to write.
  fd = ::open(file.c_str(), O_RDONLY | kFlags);
  if (fd >= 0) return fd;
  if (errno != EACCES) return WithOtherOut(WriteErrnoStatus(EACCES, "cannot write there", path));
  return WithOtherOut(WriteErrnoStatus(EACCES, "cannot open this file, the lock of the output", file));
}

}  // namespace

absl::Status CheckOutputFile(const std::string& path, bool overwrite, const std::string& flag) {
  std::error_code error;
  if (fs::symlink_status(path, error).type() == fs::file_type::not_found) return absl::OkStatus();
  const fs::file_type type = fs::status(path, error).type();
  if (type == fs::file_type::directory) {
    return absl::InvalidArgumentError(absl::StrCat(path, ": the output is a folder; choose another ", flag));
  }
  if (type == fs::file_type::not_found) {
    return absl::InvalidArgumentError(
        absl::StrCat(path, ": is a link to nothing; remove it, or choose another ", flag));
  }
  if (type == fs::file_type::none || type == fs::file_type::unknown)
    return WriteErrnoStatus(error.value(), "cannot look at it", path);
  if (type != fs::file_type::regular) {
    return absl::InvalidArgumentError(absl::StrCat(path, ": is there and is no file; choose another ", flag));
  }
  if (overwrite) return absl::OkStatus();
  return absl::AlreadyExistsError(
      absl::StrCat(path, ": exists already; choose another ", flag, ", or give --overwrite"));
}

bool HoldsPolygons(const std::string& path) {
  constexpr std::string_view kGeoPackage = "SQLite format 3";
  constexpr std::string_view kTypes[] = {"FeatureCollection", "Feature", "Polygon", "MultiPolygon"};
  const auto text = ReadFile(path);
  if (!text.ok()) return false;
  if (text->empty() || text->starts_with(kGeoPackage)) return true;
  const auto only_members = [](int depth, const nlohmann::ordered_json&) { return depth == 0; };
  const nlohmann::ordered_json json = ParseShallow(*text, {.keep = only_members});
  return json.is_object() && std::ranges::find(kTypes, Text(Member(json, "type"))) != std::end(kTypes);
}

absl::Status WithOtherOut(const absl::Status& status) {
  if (status.ok() || absl::IsResourceExhausted(status)) return status;  // which has its own remedy
  return absl::Status(status.code(), absl::StrCat(std::string(status.message()), "; choose another --out"));
}

absl::StatusOr<OutputLock> OutputLock::Take(const std::string& path) {
  const fs::path out(path);
  OutputLock lock;
  std::vector<fs::path> missing;
  for (fs::path at = out.parent_path(); !at.empty() && KindOf(at.string()) == PathKind::kNothing;
       at = at.parent_path()) {
    missing.push_back(at);
  }
  for (auto folder = missing.rbegin(); folder != missing.rend(); ++folder) {
    TILEMEND_RETURN_IF_ERROR(WithOtherOut(MakeFolder(folder->string())));
    lock.made_.push_back(folder->string());
  }
  lock.file_ = (out.parent_path() / absl::StrCat(".", out.filename().string(), ".tilemend-lock")).string();
  struct stat opened {
  }, named{};
  do {
    if (lock.fd_ >= 0) ::close(std::exchange(lock.fd_, -1));
    TILEMEND_ASSIGN_OR_RETURN(lock.fd_, OpenLock(lock.file_, path));
    if (::flock(lock.fd_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      ::close(std::exchange(lock.fd_, -1));  // and leave the file to its holder
      return WithErrorInfo(absl::AbortedError(absl::StrCat(
                               path, ": another command is writing it; wait for its end, or choose another --out")),
                           {"OUTPUT_IN_USE", {}});
    }
    // Who had the file may have removed it before the lock was taken.
  } while (::fstat(lock.fd_, &opened) != 0 || ::stat(lock.file_.c_str(), &named) != 0 || opened.st_ino != named.st_ino);
  return lock;
}

OutputLock::OutputLock(OutputLock&& other) noexcept
    : made_(std::exchange(other.made_, {})), file_(std::move(other.file_)), fd_(std::exchange(other.fd_, -1)) {}

OutputLock::~OutputLock() { Release(); }

void OutputLock::Release() {
  if (fd_ >= 0) {
    ::unlink(file_.c_str());
    ::close(std::exchange(fd_, -1));
  }
  std::vector<std::string> made = std::exchange(made_, {});
  std::reverse(made.begin(), made.end());
  for (const std::string& folder : made) RemoveEmptyFolder(folder).IgnoreError();
}

void CancelOnSignal(SignalWatcher& signals, const std::function<void()>& clean_up) {
  signals.Start([clean_up](int) {
    EraseBar();
    std::fputs("tilemend: cancelled; nothing was written\n", stderr);
    clean_up();
    std::_Exit(kExitCancelled);
  });
}

}  // namespace tilemend
