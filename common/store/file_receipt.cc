#include "common/store/file_receipt.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <cerrno>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/time/time.h"
#include "common/store/digest.h"
#include "common/store/fingerprint.h"
#include "common/util/object_store.h"
#include "common/util/place.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

// By the name of the content, which a copy within the store has, too: the time would be another one.
absl::StatusOr<FileReceipt> ReceiptOfObject(const std::string& path) {
  TILEMEND_ASSIGN_OR_RETURN(ObjectStore* const objects, ObjectsFor(path));
  TILEMEND_ASSIGN_OR_RETURN(const ObjectLook look, objects->Look(path));
  return FileReceipt{look.size, std::stoull(FileDigest(look.etag).substr(0, 16), nullptr, 16), 0};
}

}  // namespace

absl::StatusOr<FileReceipt> ReceiptOf(const std::string& path) {
  if (IsObjectPath(path)) return ReceiptOfObject(path);
  const Descriptor file(OpenKept(path, O_PATH | O_NOFOLLOW | O_CLOEXEC));
  struct stat info {};
  if (file.get() < 0 || ::fstat(file.get(), &info) != 0) return ErrnoStatus(errno, "cannot look at it", path);
  if (!S_ISREG(info.st_mode)) return absl::NotFoundError(absl::StrCat(path, ": no regular file"));
  return FileReceipt{info.st_size, info.st_ino, absl::ToUnixNanos(absl::TimeFromTimespec(info.st_mtim))};
}

absl::StatusOr<ReadReceipt> ReadForReceipt(const std::string& path) {
  TILEMEND_ASSIGN_OR_RETURN(const FileReceipt before, ReceiptOf(path));
  TILEMEND_ASSIGN_OR_RETURN(std::string digest, DigestOfFile(path));
  TILEMEND_ASSIGN_OR_RETURN(const FileReceipt after, ReceiptOf(path));
  if (before == after) return ReadReceipt{std::move(digest), after};
  return absl::UnavailableError(absl::StrCat(path, ": changed while it was read"));
}

}  // namespace tilemend
