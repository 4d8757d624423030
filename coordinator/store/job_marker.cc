#include "coordinator/store/job_marker.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <mutex>
#include <set>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/records/output_names.h"
#include "common/util/error_info.h"
#include "common/util/failpoint.h"
#include "common/util/files.h"
#include "common/util/folders.h"
#include "common/util/object_store.h"
#include "common/util/place.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

absl::Status MarkerError(const std::string& path) {
  const std::string text = absl::StrCat(path, ": cannot write there: ", std::strerror(errno), "; choose another --out");
  return errno == ENOSPC || errno == EDQUOT ? absl::ResourceExhaustedError(text) : absl::PermissionDeniedError(text);
}

absl::Status InUse(const std::string& folder) {
  return WithErrorInfo(absl::AbortedError(absl::StrCat(
                           folder, ": another job is writing there; wait for its end, or choose another --out")),
                       {"OUTPUT_IN_USE", {}});
}

// Whether `path` is the file that `opened` tells of.
bool IsStill(const std::string& path, const struct stat& opened) {
  const Descriptor file(OpenKept(path, O_PATH | O_NOFOLLOW | O_CLOEXEC));
  struct stat named {};
  return file.get() >= 0 && ::fstat(file.get(), &named) == 0 && opened.st_ino == named.st_ino;
}

class LockedFile : public JobMarker {
 public:
  explicit LockedFile(std::string folder) : folder_(std::move(folder)), path_(absl::StrCat(folder_, "/", kJobMarker)) {}
  ~LockedFile() override {
    if (file_ >= 0) ::close(file_);
  }

  absl::Status Lock() {
    struct stat opened {};
    do {
      if (file_ >= 0) ::close(file_);
      file_ = OpenKept(path_, O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0644);
      if (file_ < 0) return MarkerError(folder_);
      // A file system without locks has to do without.
      if (::flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) return InUse(folder_);
      // The job that had the marker may have removed it before the lock was taken.
    } while (::fstat(file_, &opened) != 0 || !IsStill(path_, opened));
    had_key_ = opened.st_size > 0;
    return absl::OkStatus();
  }

  absl::Status Write(const std::string& key) override {
    const auto size = static_cast<ssize_t>(key.size());
    if (::pwrite(file_, key.data(), key.size(), 0) != size || ::ftruncate(file_, size) != 0) {
      return MarkerError(folder_);
    }
    FailPoint("output.claimed");
    return ::fsync(file_) == 0 ? absl::OkStatus() : MarkerError(folder_);
  }

  void Remove() override { RemoveFile(path_).IgnoreError(); }

 private:
  const std::string folder_, path_;
  int file_ = -1;
};

// The outputs in object stores that jobs of this process write to.
class ClaimedOutputs {
 public:
  static ClaimedOutputs& Here() {
    static ClaimedOutputs claimed;
    return claimed;
  }
  bool Take(const std::string& folder) {
    const std::lock_guard lock(mutex_);
    return folders_.insert(folder).second;
  }
  void GiveBack(const std::string& folder) {
    const std::lock_guard lock(mutex_);
    folders_.erase(folder);
  }

 private:
  std::mutex mutex_;
  std::set<std::string> folders_;
};

class MarkerObject : public JobMarker {
 public:
  explicit MarkerObject(std::string folder)
      : folder_(std::move(folder)), path_(absl::StrCat(folder_, "/", kJobMarker)) {}
  ~MarkerObject() override {
    if (is_taken_) ClaimedOutputs::Here().GiveBack(folder_);
  }

  absl::Status Lock() {
    is_taken_ = ClaimedOutputs::Here().Take(folder_);
    if (!is_taken_) return InUse(folder_);
    const auto key = ReadFile(path_);
    if (!key.ok() && !absl::IsNotFound(key.status())) return key.status();
    had_key_ = key.ok() && !key->empty();
    return absl::OkStatus();
  }

  absl::Status Write(const std::string& key) override { return WriteFileAtomically(path_, key); }

  void Remove() override { RemoveFile(path_).IgnoreError(); }

 private:
  const std::string folder_, path_;
  bool is_taken_ = false;
};

template <class Marker>
absl::StatusOr<std::unique_ptr<JobMarker>> Locked(const std::string& folder) {
  auto marker = std::make_unique<Marker>(folder);
  TILEMEND_RETURN_IF_ERROR(marker->Lock());
  return marker;
}

}  // namespace

absl::StatusOr<std::unique_ptr<JobMarker>> JobMarker::Take(const std::string& folder) {
  return IsObjectPath(folder) ? Locked<MarkerObject>(folder) : Locked<LockedFile>(folder);
}

}  // namespace tilemend
