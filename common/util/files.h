// Files: whole reads, and writes that appear at once or not at all. In a process that keeps to some folders (roots.h)
// all of them do, with kPermissionDenied for what is not below them.
#ifndef TILEMEND_COMMON_UTIL_FILES_H_
#define TILEMEND_COMMON_UTIL_FILES_H_

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

namespace tilemend {

// The whole content of a regular file. kNotFound, kPermissionDenied, kInvalidArgument (a folder, a device), kInternal;
// the message names the path.
absl::StatusOr<std::string> ReadFile(const std::string& path);

// The same for a file of which more than `most` bytes are not read: kInvalidArgument with both sizes.
absl::StatusOr<std::string> ReadFileUpTo(const std::string& path, int64_t most);

// The same for a file of the program's own (a certificate, a token), which may lie outside of its roots (roots.h).
absl::StatusOr<std::string> ReadOwnFile(const std::string& path);

// The size of a regular file and up to `most` bytes of its beginning and of its end. Errors as ReadFile.
struct FileEnds {
  int64_t size = 0;
  std::string first, last;
};
absl::StatusOr<FileEnds> ReadFileEnds(const std::string& path, int64_t most);

// Calls `take` with a regular file piece by piece, of at most `most` bytes. Errors as ReadFile.
absl::Status ReadInPieces(const std::string& path, int64_t most, const std::function<void(std::string_view)>& take);

// kNo leaves it to the kernel when the bytes reach the disk: after a power cut the file may be empty or torn. For data
// that is checked when it is read and can be made again.
enum class Sync { kYes, kNo };

// What WriteFileAtomically puts between a file's name and a number while it writes: a process that is killed then
// leaves such a file behind.
inline constexpr char kPartSuffix[] = ".part-";

// Writes `content` beside `path` under a temporary name, syncs it (unless `sync` is kNo) and renames it into place. So
// a reader sees the old file or the whole new one. Creates missing parent folders. Errors: kPermissionDenied,
// kInvalidArgument (a path below a file, onto a folder, too long), kResourceExhausted (disk full), kInternal. After an
// error nothing is left behind but folders.
absl::Status WriteFileAtomically(const std::string& path, std::string_view content, Sync sync = Sync::kYes);

// How a file gets to another place. With kCopy it is a file of its own. On file systems that can, it shares its blocks
// with the other until one of them is changed. With kLink it is a hard link, one file under two names; a copy where
// there can be none.
enum class Carry { kCopy, kLink };

// Puts a file with the content of `from` at `to`, at once or not at all, in place of what is there, a link itself.
// Creates missing parent folders. `from` stays as it is. Returns kNotFound and kInvalidArgument for `from`, which must
// be a regular file, and kInvalidArgument if `to` is `from`. Other errors as WriteFileAtomically.
absl::Status CarryFile(const std::string& from, const std::string& to, Carry how);

// For files whose folder must be there, and that nobody else writes: no temporary name, and no folder is made.
// WriteNewFile writes and syncs a file that is not there yet; CarryToNewFile gives `to` the content of `from`, as
// CarryFile does, and returns its size. After an error there is no file. Errors as above, and kInvalidArgument if
// there is a file.
absl::Status WriteNewFile(const std::string& path, std::string_view content);
absl::StatusOr<int64_t> CarryToNewFile(const std::string& from, const std::string& to, Carry how);

// Gives the file `from` the name `to`, in place of what is there; a reader sees the old file or the new one. Creates
// missing parent folders. Across file systems the file is copied. kNotFound if `from` is gone; else as
// WriteFileAtomically.
absl::Status MoveFile(const std::string& from, const std::string& to);

// Has the names in a folder survive a power cut.
absl::Status SyncFolder(const std::string& path);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_FILES_H_
