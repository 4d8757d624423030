#include "common/store/file_stamp.h"

#include <fcntl.h>
#include <sys/stat.h>

#include <optional>

#include "absl/strings/str_cat.h"
#include "common/util/object_store.h"
#include "common/util/place.h"

namespace tilemend {
namespace {

constexpr absl::Duration kCoarse = absl::Seconds(2);  // FAT's, and that of NFS servers in want of something finer

std::optional<struct stat> Look(const std::string& path) {
  const Descriptor file(OpenKept(path, O_PATH | O_CLOEXEC));
  struct stat info {};
  if (file.get() < 0 || ::fstat(file.get(), &info) != 0 || !S_ISREG(info.st_mode)) return std::nullopt;
  return info;
}

// An ETag tells the content, so that no time is needed. "" if there is no such object.
std::string StampOfObject(const std::string& path) {
  const auto objects = ObjectsFor(path);
  const auto look = objects.ok() ? (*objects)->Look(path) : objects.status();
  return look.ok() ? absl::StrCat(look->etag, " ", look->size) : "";
}

std::string TextOf(const struct stat& info) {
  return absl::StrCat(info.st_ino, " ", info.st_size, " ", absl::ToUnixNanos(absl::TimeFromTimespec(info.st_mtim)), " ",
                      absl::ToUnixNanos(absl::TimeFromTimespec(info.st_ctim)));
}

}  // namespace

std::string StampOf(const std::string& path, absl::Time now) {
  if (IsObjectPath(path)) return StampOfObject(path);
  const auto info = Look(path);
  return info && absl::TimeFromTimespec(info->st_ctim) + kCoarse < now ? TextOf(*info) : "";
}

std::string YoungStampOf(const std::string& path) {
  if (IsObjectPath(path)) return StampOfObject(path);
  const auto info = Look(path);
  return info ? TextOf(*info) : "";
}

bool HasStamp(const std::string& path, const std::string& stamp) {
  if (stamp.empty()) return false;
  if (IsObjectPath(path)) return StampOfObject(path) == stamp;
  const auto info = Look(path);
  return info && TextOf(*info) == stamp;
}

}  // namespace tilemend
