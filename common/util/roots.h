// Folders that a process keeps to: files below them are opened relative to them, and no link leads out.
#ifndef TILEMEND_COMMON_UTIL_ROOTS_H_
#define TILEMEND_COMMON_UTIL_ROOTS_H_

#include <sys/types.h>

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

namespace tilemend {

// Thread-safe. Needs Linux 5.6 (openat2).
class Roots {
 public:
  // Absolute paths of folders, and s3://BUCKET[/PREFIX] (object_store.h). Folders are what the names lead to now,
  // however the links in them change. Errors: kInvalidArgument for a path that is not absolute, kNotFound,
  // kUnimplemented for an older kernel.
  static absl::StatusOr<std::shared_ptr<const Roots>> Open(const std::vector<std::string>& folders);
  ~Roots();
  Roots(const Roots&) = delete;
  Roots& operator=(const Roots&) = delete;

  // As open(2). It is -1 with EXDEV for a path that is not below a root, or that a link leads out of it. An absolute
  // link always does.
  int OpenFile(const std::string& path, int flags, mode_t mode = 0) const;

  // For a path that need not be there yet. Returns kPermissionDenied (OUTSIDE_ROOTS) if it is not below a root, or the
  // part of it that exists leads out.
  absl::Status Check(const std::string& path) const;

 private:
  Roots() = default;
  bool HasObject(const std::string& path) const;
  std::map<std::string, int> folders_;  // descriptors by normal path, without a slash at the end
  std::set<std::string> prefixes_;      // of objects, without a slash at the end
};

// The roots that a flag names: with colons between them, which an s3:// has, too.
std::vector<std::string> RootsInFlag(const std::string& text);

// From now on the functions of files.h keep to these: those of the jobs and those of the program itself. For the start
// of main, once. Null: everywhere.
void KeepFilesTo(std::shared_ptr<const Roots> roots);

// What KeepFilesTo was told.
const Roots* FilesRoots();

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_ROOTS_H_
