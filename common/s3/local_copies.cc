#include "common/s3/local_copies.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include "common/util/place.h"

namespace tilemend {
namespace {

// Each copy takes a descriptor, of which a process has 1,024 where nobody raised the limit.
constexpr size_t kMostCopies = 256;

int Duplicate(int file) { return ::fcntl(file, F_DUPFD_CLOEXEC, 0); }

}  // namespace

LocalCopies::~LocalCopies() {
  for (const Copy& copy : copies_) ::close(copy.file);
}

absl::StatusOr<int> LocalCopies::NewFile() const {
  std::error_code error;
  const std::string folder = folder_.empty() ? std::filesystem::temp_directory_path(error).string() : folder_;
  std::string name = folder + "/tilemend-object-XXXXXX";
  const int file = ::mkostemp(name.data(), O_CLOEXEC);
  if (file < 0) return WriteErrnoStatus(errno, "cannot make a file for copies of objects", folder);
  ::unlink(name.c_str());
  return file;
}

int LocalCopies::Find(const std::string& name) {
  const std::lock_guard lock(mutex_);
  const auto found = std::find_if(copies_.begin(), copies_.end(), [&](const Copy& copy) { return copy.name == name; });
  if (found == copies_.end()) return -1;
  copies_.splice(copies_.begin(), copies_, found);
  return Duplicate(found->file);
}

void LocalCopies::Keep(const std::string& name, int file, int64_t bytes) {
  if (bytes > most_) return;
  const int kept = Duplicate(file);
  if (kept < 0) return;
  const std::lock_guard lock(mutex_);
  while (!copies_.empty() && (bytes_ + bytes > most_ || copies_.size() >= kMostCopies)) DropLast();
  copies_.push_front({name, kept, bytes});
  bytes_ += bytes;
}

void LocalCopies::DropLast() {
  bytes_ -= copies_.back().bytes;
  ::close(copies_.back().file);
  copies_.pop_back();
}

}  // namespace tilemend
