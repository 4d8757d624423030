#include "client/work_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "common/util/shortage.h"

namespace tilemend {
namespace {

namespace fs = std::filesystem;

constexpr char kName[] = "tilemend-run-";
constexpr char kMark[] = ".tilemend-work-folder";  // in each: a user's folder may have such a name too
constexpr char kUnlocked[] = "tilemend-new-";      // until it is locked, so that nobody takes it for one that was left

int OpenFolder(const std::string& path) {
  return ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
}

// A descriptor that locks the folder; -1 if somebody else does, or it is another user's.
int Lock(const std::string& path) {
  const int folder = OpenFolder(path);
  struct stat info {};
  const bool locked = folder >= 0 && ::fstat(folder, &info) == 0 && info.st_uid == ::geteuid() &&
                      ::flock(folder, LOCK_EX | LOCK_NB) == 0;
  if (locked || folder < 0) return folder;
  ::close(folder);
  return -1;
}

// Where the system's folder for such things comes from, in the order of temp_directory_path.
std::string NameOfTemporaryFolder() {
  for (const char* variable : {"TMPDIR", "TMP", "TEMP", "TEMPDIR"}) {
    if (const char* const value = std::getenv(variable)) return absl::StrCat(variable, "=", value);
  }
  return "/tmp";
}

void RemoveLeft(const fs::path& base) {
  std::error_code error;
  for (fs::directory_iterator at(base, error), end; !error && at != end; at.increment(error)) {
    const std::string path = at->path().string();
    if (!absl::StartsWith(at->path().filename().string(), kName)) continue;
    if (std::error_code unread; !fs::is_regular_file(fs::symlink_status(at->path() / kMark, unread))) continue;
    const int lock = Lock(path);
    if (lock < 0) continue;
    std::error_code ignored;
    fs::remove_all(path, ignored);
    ::close(lock);
  }
}

}  // namespace

absl::StatusOr<WorkFolder> WorkFolder::Make(const std::string& parent) {
  std::error_code error;
  const fs::path base = parent.empty() ? fs::temp_directory_path(error) : fs::path(parent);
  if (error) {
    return absl::PermissionDeniedError(
        absl::StrCat(NameOfTemporaryFolder(), ": not a folder for temporary files; choose one with TMPDIR or --work"));
  }
  fs::create_directories(base, error);
  if (!error) RemoveLeft(base);
  std::string made = (base / absl::StrCat(kUnlocked, "XXXXXX")).string();
  if (error || ::mkdtemp(made.data()) == nullptr) {
    return absl::PermissionDeniedError(
        absl::StrCat(base.string(), ": cannot make a work folder there; choose another with --work"));
  }
  std::ofstream(fs::path(made) / kMark) << "A folder of tilemend for what it needs while it runs.\n";
  const int lock = Lock(made);  // -1 on a file system without locks: nobody can lock it there to remove it
  const std::string path = (base / absl::StrCat(kName, made.substr(made.size() - 6))).string();
  const bool renamed = ::rename(made.c_str(), path.c_str()) == 0;
  return WorkFolder(renamed ? path : made, lock);
}

WorkFolder::WorkFolder(std::string path, int lock) : path_(std::move(path)), lock_(lock) { RemoveOnShortage(path_); }

WorkFolder::WorkFolder(WorkFolder&& other) noexcept
    : path_(std::exchange(other.path_, "")), lock_(std::exchange(other.lock_, -1)) {}

WorkFolder::~WorkFolder() {
  if (path_.empty()) return;
  RemoveOnShortage("");
  std::error_code error;
  fs::remove_all(path_, error);
  if (lock_ >= 0) ::close(lock_);
}

}  // namespace tilemend
