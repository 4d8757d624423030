#include "common/util/files.h"

#include <fcntl.h>
#include <linux/fs.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <random>
#include <span>
#include <system_error>

#include "absl/strings/str_cat.h"
#include "common/util/failpoint.h"
#include "common/util/object_store.h"
#include "common/util/place.h"
#include "common/util/real_path.h"
#include "common/util/roots.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

// The descriptor; of an object, that of a local copy.
absl::StatusOr<int> OpenToRead(const std::string& path) {
  if (IsObjectPath(path)) {
    TILEMEND_ASSIGN_OR_RETURN(ObjectStore* const objects, ObjectsFor(path));
    TILEMEND_ASSIGN_OR_RETURN(const int shared, objects->Open(path));
    const Descriptor copy(shared);
    // Opened anew: what reads it has an offset of its own.
    const int own = ::open(absl::StrCat("/proc/self/fd/", copy.get()).c_str(), O_RDONLY | O_CLOEXEC);
    if (own < 0) return ErrnoStatus(errno, "cannot open its local copy", path);
    return own;
  }
  const int file = OpenKept(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0) return ErrnoStatus(errno, "cannot open", path);
  return file;
}

int Remove(const Place& place) { return ::unlinkat(place.at(), place.name.c_str(), 0); }
int Rename(const Place& from, const Place& to) {
  return ::renameat(from.at(), from.name.c_str(), to.at(), to.name.c_str());
}

absl::Status WriteAll(int fd, std::string_view content, const std::string& path) {
  while (!content.empty()) {
    const ssize_t n = ::write(fd, content.data(), content.size());
    if (n < 0) {
      if (errno == EINTR) continue;
      return WriteErrnoStatus(errno, "cannot write", path);
    }
    content.remove_prefix(static_cast<size_t>(n));
  }
  return absl::OkStatus();
}

bool SetDirect(int fd, bool direct) {
  const int flags = ::fcntl(fd, F_GETFL);
  return flags >= 0 && ::fcntl(fd, F_SETFL, direct ? flags | O_DIRECT : flags & ~O_DIRECT) == 0;
}

// Writes the whole blocks of `content` past the page cache, as far as the file system can, to an empty file. Returns
// how many bytes it wrote; what stopped it shows when the rest is written.
size_t WriteBlocksDirectly(int fd, std::string_view content) {
  constexpr size_t kBlock = 4096;  // that of disks, or a multiple
  constexpr size_t kChunk = size_t{1} << 20;
  if (content.size() < kChunk || !SetDirect(fd, true)) return 0;
  const std::unique_ptr<void, decltype(&std::free)> buffer(std::aligned_alloc(kBlock, kChunk), &std::free);
  size_t done = 0;
  while (buffer != nullptr && content.size() - done >= kBlock) {
    const size_t size = std::min(kChunk, (content.size() - done) / kBlock * kBlock);
    std::memcpy(buffer.get(), content.data() + done, size);
    const ssize_t n = ::write(fd, buffer.get(), size);
    if (n < 0 && errno == EINTR) continue;
    if (n > 0) done += static_cast<size_t>(n);
    if (n != static_cast<ssize_t>(size)) break;
  }
  SetDirect(fd, false);
  return done;
}

absl::Status MakeFoldersBelow(const Roots& roots, const std::filesystem::path& folder) {
  if (const Descriptor there(roots.OpenFile(folder, O_PATH | O_DIRECTORY | O_CLOEXEC)); there.get() >= 0) {
    return absl::OkStatus();
  }
  if (errno != ENOENT || folder == folder.parent_path()) {
    return WriteErrnoStatus(errno, "cannot create folder", folder.string());
  }
  TILEMEND_RETURN_IF_ERROR(MakeFoldersBelow(roots, folder.parent_path()));
  const Place place(folder.string());
  if (place.ok() && (::mkdirat(place.at(), place.name.c_str(), 0777) == 0 || errno == EEXIST)) return absl::OkStatus();
  return WriteErrnoStatus(place.ok() ? errno : place.error, "cannot create folder", folder.string());
}

// Creates the folders that are to hold `path`.
absl::Status MakeFoldersOf(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  if (folder.empty()) return absl::OkStatus();
  if (const Roots* const roots = FilesRoots(); roots != nullptr) return MakeFoldersBelow(*roots, folder);
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  return error ? WriteErrnoStatus(error.value(), "cannot create folder", folder.string()) : absl::OkStatus();
}

// A name beside `path` that nobody else uses.
std::string TemporaryName(const std::string& path) {
  static std::atomic<uint64_t> counter{0};
  // Not the process id: containers on several machines have the same.
  static const uint32_t process = std::random_device()();
  return absl::StrCat(path, kPartSuffix, absl::Hex(process, absl::kZeroPad8), "-", counter.fetch_add(1));
}

// Calls `write` with the new file `path` and syncs it (unless `sync` is kNo). Errors speak of `told`.
template <class Write>
absl::Status WriteNew(const std::string& path, const std::string& told, Sync sync, Write write) {
  Descriptor file(OpenKept(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644));
  if (file.get() < 0) return WriteErrnoStatus(errno, "cannot create", told);
  absl::Status status = write(file.get());
  if (status.ok() && sync == Sync::kYes && ::fsync(file.get()) != 0)
    status = WriteErrnoStatus(errno, "cannot sync", told);
  if (file.Close() != 0 && status.ok()) status = WriteErrnoStatus(errno, "cannot close", told);
  if (!status.ok()) Remove(Place(path));
  return status;
}

// The same with a new file beside `path`, which is then renamed into place.
template <class Write>
absl::Status WriteInPlace(const std::string& path, Sync sync, Write write) {
  TILEMEND_RETURN_IF_ERROR(MakeFoldersOf(path));
  const std::string temporary = TemporaryName(path);
  TILEMEND_RETURN_IF_ERROR(WriteNew(temporary, path, sync, write));
  FailPoint("file.written");
  if (Rename(Place(temporary), Place(path)) == 0) {
    FailPoint("file.renamed");
    return absl::OkStatus();
  }
  absl::Status status = WriteErrnoStatus(errno, "cannot rename into place", path);
  Remove(Place(temporary));
  return status;
}

// Makes `to` another name of the open file `from`; false where that is not possible.
bool LinkNew(int from, const std::string& to) {
  const std::string source = absl::StrCat("/proc/self/fd/", from);
  const Place place(to);
  return place.ok() && ::linkat(AT_FDCWD, source.c_str(), place.at(), place.name.c_str(), AT_SYMLINK_FOLLOW) == 0;
}

bool LinkInPlace(int from, const std::string& to) {
  const std::string temporary = TemporaryName(to);
  if (!LinkNew(from, temporary)) return false;
  const bool renamed = Rename(Place(temporary), Place(to)) == 0;
  Remove(Place(temporary));  // is still there, too, if `to` was that file already: rename does nothing then
  return renamed;
}

absl::Status CopyBytes(int from, int to, const std::string& from_path, const std::string& to_path) {
  constexpr size_t kChunk = size_t{1} << 20;
  std::string buffer;
  bool in_kernel = true;
  for (;;) {
    ssize_t n = in_kernel ? ::copy_file_range(from, nullptr, to, nullptr, kChunk << 6, 0) : -1;
    if (n > 0) continue;
    if (n == 0) return absl::OkStatus();
    if (in_kernel && (errno == ENOSPC || errno == EDQUOT)) return WriteErrnoStatus(errno, "cannot write", to_path);
    in_kernel = false;  // between some file systems: by hand, from where it stands
    buffer.resize(kChunk);
    n = ::read(from, buffer.data(), buffer.size());
    if (n < 0 && errno != EINTR) return ErrnoStatus(errno, "cannot read", from_path);
    if (n == 0) return absl::OkStatus();
    if (n > 0) TILEMEND_RETURN_IF_ERROR(WriteAll(to, {buffer.data(), static_cast<size_t>(n)}, to_path));
  }
}

absl::Status CloneOrCopy(int from, int to, const std::string& from_path, const std::string& to_path) {
  const bool shared = ::ioctl(to, FICLONE, from) == 0;
  return shared ? absl::OkStatus() : CopyBytes(from, to, from_path, to_path);
}

// Whether `file` is open and a regular file; fills `info`.
absl::Status CheckSource(int file, const std::string& path, struct stat& info) {
  if (file < 0) return ErrnoStatus(errno, "cannot open", path);
  if (::fstat(file, &info) != 0) return ErrnoStatus(errno, "cannot stat", path);
  if (S_ISREG(info.st_mode)) return absl::OkStatus();
  return absl::InvalidArgumentError(absl::StrCat(path, ": not a regular file"));
}

absl::Status PutObject(const std::string& path, std::string_view content) {
  TILEMEND_ASSIGN_OR_RETURN(ObjectStore* const objects, ObjectsFor(path));
  return objects->Put(path, content);
}

// For an object whose folder must be there: a key that begins as its folder. Another process may remove that one
// between this and the next request.
absl::Status CheckFolderOfObject(const std::string& path) {
  TILEMEND_ASSIGN_OR_RETURN(ObjectStore* const objects, ObjectsFor(path));
  return objects->List(path.substr(0, path.rfind('/'))).status();
}

// Fills `room` from `offset` on; returns how many bytes there were: fewer if the file has shrunk.
absl::StatusOr<size_t> ReadInto(int file, int64_t offset, std::span<char> room, const std::string& path) {
  size_t have = 0;
  while (have < room.size()) {
    const ssize_t n = ::pread(file, room.data() + have, room.size() - have, offset + static_cast<int64_t>(have));
    if (n < 0) {
      if (errno == EINTR) continue;
      return ErrnoStatus(errno, "cannot read", path);
    }
    if (n == 0) break;
    have += static_cast<size_t>(n);
  }
  return have;
}

// Up to `length` bytes from `offset` on. In blocks that stay in the processor's cache: a string of the whole length
// would be written with zeros first.
absl::StatusOr<std::string> ReadRange(int file, int64_t offset, int64_t length, const std::string& path) {
  constexpr size_t kBlock = size_t{1} << 17;
  const auto whole = static_cast<size_t>(length);
  std::string content, block(std::min(whole, kBlock), '\0');
  content.reserve(whole);
  while (content.size() < whole) {
    const std::span room = std::span<char>(block).first(std::min(block.size(), whole - content.size()));
    TILEMEND_ASSIGN_OR_RETURN(const size_t have,
                              ReadInto(file, offset + static_cast<int64_t>(content.size()), room, path));
    content.append(room.data(), have);
    if (have < room.size()) break;
  }
  return content;
}

// Gives the object `to` the content of `from`, a file or an object; returns its size.
absl::StatusOr<int64_t> CarryToObject(const std::string& from, const std::string& to) {
  if (from == to) return absl::InvalidArgumentError(absl::StrCat(from, ": would be written over itself"));
  TILEMEND_ASSIGN_OR_RETURN(ObjectStore* const objects, ObjectsFor(to));
  if (!IsObjectPath(from)) {
    TILEMEND_ASSIGN_OR_RETURN(const std::string content, ReadFile(from));
    TILEMEND_RETURN_IF_ERROR(objects->Put(to, content));
    return static_cast<int64_t>(content.size());
  }
  TILEMEND_RETURN_IF_ERROR(ObjectsFor(from).status());
  TILEMEND_ASSIGN_OR_RETURN(const ObjectLook look, objects->Look(from));
  const absl::Status copied = objects->Copy(from, look, to);
  // It was there a moment ago: missing is what a caller may do without.
  if (absl::IsNotFound(copied)) return absl::UnavailableError(copied.message());
  TILEMEND_RETURN_IF_ERROR(copied);
  return look.size;
}

// Objects have no other name: a copy, and then the old one is removed.
absl::Status MoveObject(const std::string& from, const std::string& to) {
  if (!IsObjectPath(from) || !IsObjectPath(to)) {
    return absl::InvalidArgumentError(absl::StrCat(from, ": cannot move it to ", to));
  }
  const auto size = CarryToObject(from, to);
  if (absl::IsNotFound(size.status())) return absl::NotFoundError(absl::StrCat(from, ": is gone"));
  TILEMEND_RETURN_IF_ERROR(size.status());
  FailPoint("file.moved");
  TILEMEND_ASSIGN_OR_RETURN(ObjectStore* const objects, ObjectsFor(from));
  return objects->Remove(from);
}

}  // namespace

absl::StatusOr<std::string> ReadFile(const std::string& path) {
  struct stat info {};
  TILEMEND_ASSIGN_OR_RETURN(const int opened, OpenToRead(path));
  const Descriptor file(opened);
  TILEMEND_RETURN_IF_ERROR(CheckSource(file.get(), path, info));
  return ReadRange(file.get(), 0, info.st_size, path);
}

absl::StatusOr<std::string> ReadFileUpTo(const std::string& path, int64_t most) {
  struct stat info {};
  TILEMEND_ASSIGN_OR_RETURN(const int opened, OpenToRead(path));
  const Descriptor file(opened);
  TILEMEND_RETURN_IF_ERROR(CheckSource(file.get(), path, info));
  if (info.st_size <= most) return ReadRange(file.get(), 0, info.st_size, path);
  constexpr int64_t kMebibyte = 1 << 20;
  return absl::InvalidArgumentError(absl::StrCat(path, ": ", info.st_size / kMebibyte, " MiB, but at most ",
                                                 most / kMebibyte, " MiB of such a file are read"));
}

absl::StatusOr<std::string> ReadOwnFile(const std::string& path) {
  struct stat info {};
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  TILEMEND_RETURN_IF_ERROR(CheckSource(file.get(), path, info));
  return ReadRange(file.get(), 0, info.st_size, path);
}

absl::StatusOr<FileEnds> ReadFileEnds(const std::string& path, int64_t most) {
  struct stat info {};
  TILEMEND_ASSIGN_OR_RETURN(const int opened, OpenToRead(path));
  const Descriptor file(opened);
  TILEMEND_RETURN_IF_ERROR(CheckSource(file.get(), path, info));
  FileEnds ends{info.st_size, "", ""};
  const int64_t length = std::min<int64_t>(most, info.st_size);
  TILEMEND_ASSIGN_OR_RETURN(ends.first, ReadRange(file.get(), 0, length, path));
  TILEMEND_ASSIGN_OR_RETURN(ends.last, ReadRange(file.get(), info.st_size - length, length, path));
  return ends;
}

absl::Status ReadInPieces(const std::string& path, int64_t most, const std::function<void(std::string_view)>& take) {
  struct stat info {};
  TILEMEND_ASSIGN_OR_RETURN(const int opened, OpenToRead(path));
  const Descriptor file(opened);
  TILEMEND_RETURN_IF_ERROR(CheckSource(file.get(), path, info));
  // One room for all pieces: new memory for each costs more than to read it.
  std::string room(static_cast<size_t>(std::min<int64_t>(most, info.st_size)), '\0');
  for (int64_t at = 0; at < info.st_size; at += most) {
    const size_t length = static_cast<size_t>(std::min<int64_t>(most, info.st_size - at));
    TILEMEND_ASSIGN_OR_RETURN(const size_t have, ReadInto(file.get(), at, std::span(room).first(length), path));
    take(std::string_view(room).substr(0, have));
  }
  return absl::OkStatus();
}

absl::Status WriteFileAtomically(const std::string& path, std::string_view content, Sync sync) {
  if (IsObjectPath(path)) return PutObject(path, content);
  return WriteInPlace(path, sync, [&](int file) { return WriteAll(file, content, path); });
}

absl::Status WriteNewFile(const std::string& path, std::string_view content) {
  if (IsObjectPath(path)) {
    TILEMEND_RETURN_IF_ERROR(CheckFolderOfObject(path));
    return PutObject(path, content);
  }
  // A file that is synced at once gains nothing by the page cache but copies of all its bytes there.
  return WriteNew(path, path, Sync::kYes, [&](int file) {
    const size_t done = WriteBlocksDirectly(file, content);
    return WriteAll(file, content.substr(done), path);
  });
}

absl::StatusOr<int64_t> CarryToNewFile(const std::string& from, const std::string& to, Carry how) {
  if (IsObjectPath(to)) {
    TILEMEND_RETURN_IF_ERROR(CheckFolderOfObject(to));
    return CarryToObject(from, to);
  }
  struct stat info {};
  TILEMEND_ASSIGN_OR_RETURN(const int opened, OpenToRead(from));
  const Descriptor source(opened);
  TILEMEND_RETURN_IF_ERROR(CheckSource(source.get(), from, info));
  const bool linked = how == Carry::kLink && LinkNew(source.get(), to);
  if (!linked) {
    TILEMEND_RETURN_IF_ERROR(
        WriteNew(to, to, Sync::kYes, [&](int file) { return CloneOrCopy(source.get(), file, from, to); }));
  }
  return static_cast<int64_t>(info.st_size);
}

absl::Status MoveFile(const std::string& from, const std::string& to) {
  if (IsObjectPath(from) || IsObjectPath(to)) return MoveObject(from, to);
  TILEMEND_RETURN_IF_ERROR(MakeFoldersOf(to));
  const Place source(from), target(to);
  if (!source.ok()) return ErrnoStatus(source.error, "cannot open", from);
  if (!target.ok()) return WriteErrnoStatus(target.error, "cannot open", to);
  if (Rename(source, target) != 0) {
    if (errno == EXDEV) {
      TILEMEND_RETURN_IF_ERROR(CarryFile(from, to, Carry::kCopy));
    } else if (errno == ENOENT) {
      return absl::NotFoundError(absl::StrCat(from, ": is gone"));
    } else {
      return WriteErrnoStatus(errno, "cannot rename into place", to);
    }
  }
  FailPoint("file.moved");
  Remove(source);  // is still there if both were names of one file: rename does nothing then
  return absl::OkStatus();
}

absl::Status SyncFolder(const std::string& path) {
  if (IsObjectPath(path)) return absl::OkStatus();
  const Descriptor folder(OpenKept(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.get() < 0) return WriteErrnoStatus(errno, "cannot open", path);
  // Some file systems know no such thing.
  if (::fsync(folder.get()) == 0 || errno == EINVAL || errno == ENOTSUP) return absl::OkStatus();
  return WriteErrnoStatus(errno, "cannot sync", path);
}

absl::Status CarryFile(const std::string& from, const std::string& to, Carry how) {
  if (IsObjectPath(to)) return CarryToObject(from, to).status();
  struct stat info {};
  TILEMEND_ASSIGN_OR_RETURN(const int opened, OpenToRead(from));
  const Descriptor source(opened);
  TILEMEND_RETURN_IF_ERROR(CheckSource(source.get(), from, info));
  if (TakesThePlaceOf(from, to)) {
    return absl::InvalidArgumentError(absl::StrCat(from, ": would be written over itself"));
  }
  TILEMEND_RETURN_IF_ERROR(MakeFoldersOf(to));
  if (how == Carry::kLink && LinkInPlace(source.get(), to)) return absl::OkStatus();
  return WriteInPlace(to, Sync::kYes, [&](int file) { return CloneOrCopy(source.get(), file, from, to); });
}

}  // namespace tilemend
