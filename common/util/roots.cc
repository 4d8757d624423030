#include "common/util/roots.h"

#include <fcntl.h>
#include <linux/openat2.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_split.h"
#include "common/util/error_info.h"
#include "common/util/object_store.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

std::shared_ptr<const Roots>& Kept() {
  static std::shared_ptr<const Roots> roots;
  return roots;
}

// Without "." and "..", doubled slashes and one at the end. "" for a path that is not absolute.
std::string Normal(const std::string& path) {
  if (path.empty() || path.front() != '/' || path.find('\0') != std::string::npos) return "";
  std::string normal = std::filesystem::path(path).lexically_normal().string();
  while (normal.size() > 1 && normal.back() == '/') normal.pop_back();
  return normal;
}

std::string WithoutSlashes(std::string path) {
  while (path.ends_with('/')) path.pop_back();
  return path;
}

int OpenBelow(int folder, const std::string& path, int flags, mode_t mode) {
  open_how how{};
  how.flags = static_cast<uint64_t>(flags);
  how.mode = mode;
  how.resolve = RESOLVE_BENEATH | RESOLVE_NO_MAGICLINKS;
  int fd = -1;
  do {
    fd = static_cast<int>(syscall(SYS_openat2, folder, path.c_str(), &how, sizeof(how)));
  } while (fd < 0 && (errno == EINTR || errno == EAGAIN));  // EAGAIN: something was renamed meanwhile
  return fd;
}

absl::Status Outside(const std::string& path) {
  return WithErrorInfo(
      absl::PermissionDeniedError(
          absl::StrCat(Printable(path), ": not below a folder that may be used (--root), or led out of it by a link")),
      {"OUTSIDE_ROOTS", {}});
}

}  // namespace

absl::StatusOr<std::shared_ptr<const Roots>> Roots::Open(const std::vector<std::string>& folders) {
  std::shared_ptr<Roots> roots(new Roots);
  for (const std::string& folder : folders) {
    if (IsObjectPath(folder)) {
      roots->prefixes_.insert(WithoutSlashes(folder));
      continue;
    }
    const std::string normal = Normal(folder);
    if (normal.empty()) return absl::InvalidArgumentError(absl::StrCat("'", folder, "': expected an absolute path"));
    const int fd = ::open(normal.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC);
    if (fd < 0) return absl::NotFoundError(absl::StrCat(folder, ": cannot use this folder: ", std::strerror(errno)));
    if (!roots->folders_.emplace(normal, fd).second) ::close(fd);
    const int probe = OpenBelow(fd, ".", O_PATH | O_CLOEXEC, 0);
    if (probe < 0 && errno == ENOSYS) {
      return absl::UnimplementedError("this kernel cannot keep files below a folder: Linux 5.6 has openat2");
    }
    if (probe >= 0) ::close(probe);
  }
  return roots;
}

Roots::~Roots() {
  for (const auto& [path, fd] : folders_) ::close(fd);
}

int Roots::OpenFile(const std::string& path, int flags, mode_t mode) const {
  const std::string normal = Normal(path);
  // The path as it was given: ".." behind a link is not what it looks like.
  if (!normal.empty() && path.find("/../") == std::string::npos && !path.ends_with("/..")) {
    for (const auto& [root, fd] : folders_) {
      if (normal == root) return OpenBelow(fd, ".", flags, mode);
      const std::string folder = root == "/" ? root : root + "/";
      if (normal.starts_with(folder)) return OpenBelow(fd, normal.substr(folder.size()), flags, mode);
    }
  }
  errno = EXDEV;
  return -1;
}

// Keys are not paths: ".." is a name like any other, so that the text alone says where an object is.
bool Roots::HasObject(const std::string& path) const {
  return std::any_of(prefixes_.begin(), prefixes_.end(),
                     [&](const std::string& prefix) { return path == prefix || path.starts_with(prefix + "/"); });
}

absl::Status Roots::Check(const std::string& path) const {
  if (IsObjectPath(path)) return HasObject(path) ? absl::OkStatus() : Outside(path);
  std::filesystem::path at = Normal(path);
  if (at.empty()) return Outside(path);
  const std::filesystem::path tail = std::filesystem::path(path).filename();
  if (tail == ".." || path.find("/../") != std::string::npos) return Outside(path);
  while (true) {
    const int fd = OpenFile(at.string(), O_PATH | O_CLOEXEC);
    if (fd >= 0) {
      ::close(fd);
      return absl::OkStatus();
    }
    if (errno != ENOENT || at == at.root_path()) return Outside(path);
    // A link that leads nowhere yet may lead out later.
    const int link = OpenFile(at.string(), O_PATH | O_NOFOLLOW | O_CLOEXEC);
    if (link >= 0) {
      ::close(link);
      return Outside(path);
    }
    at = at.parent_path();
  }
}

std::vector<std::string> RootsInFlag(const std::string& text) {
  std::vector<std::string> roots;
  for (const absl::string_view part : absl::StrSplit(text, ':', absl::SkipEmpty())) {
    if (!roots.empty() && roots.back() == "s3" && part.substr(0, 2) == "//") {
      absl::StrAppend(&roots.back(), ":", part);
    } else {
      roots.emplace_back(part);
    }
  }
  return roots;
}

void KeepFilesTo(std::shared_ptr<const Roots> roots) { Kept() = std::move(roots); }

const Roots* FilesRoots() { return Kept().get(); }

}  // namespace tilemend
