#include "coordinator/store/blob_folder.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include "absl/cleanup/cleanup.h"
#include "absl/strings/str_cat.h"
#include "common/rpc/limits.h"
#include "common/util/error_info.h"
#include "common/util/failpoint.h"
#include "common/util/place.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

// Blobs lie in 16 folders, by the first digit: a folder of a job of a million cells has some 100,000 files, and a small
// job makes few folders.
constexpr size_t kParentDigits = 1;

absl::Status BlobNotFound(const std::string& digest) {
  return WithErrorInfo(absl::NotFoundError(absl::StrCat("blob ", digest, ": the job has none of that name")),
                       {"BLOB_NOT_FOUND", {{"digest", digest}}});
}

absl::StatusOr<std::string> PathOf(const std::string& folder, const std::string& digest) {
  if (!IsDigest(digest)) return absl::InvalidArgumentError("a digest has 64 lower-case hexadecimal digits");
  return absl::StrCat(folder, "/", digest.substr(0, kParentDigits), "/", digest.substr(kParentDigits));
}

// In all folders.
std::atomic<size_t>& HeldInAll() {
  static std::atomic<size_t> bytes{0};
  return bytes;
}

// False if that would be too much.
bool TakeMemory(size_t bytes) {
  if (HeldInAll().fetch_add(bytes) + bytes <= kMostHeldBytes) return true;
  HeldInAll().fetch_sub(bytes);
  return false;
}

// Hard links to blobs in another such folder, synced. False if one cannot be made.
bool LinkBlobs(const std::string& folder, const std::set<std::string>& digests, const std::string& other) {
  std::set<std::string> parents = {other};
  for (const std::string& digest : digests) {
    const auto from = PathOf(folder, digest), to = PathOf(other, digest);
    std::error_code error;
    if (!from.ok() || !std::filesystem::exists(*from, error)) continue;  // lost, and so made again
    const std::string parent = std::filesystem::path(*to).parent_path().string();
    if (parents.insert(parent).second && ::mkdir(parent.c_str(), 0700) != 0) return false;
    if (::link(from->c_str(), to->c_str()) != 0) return false;
  }
  return std::all_of(parents.begin(), parents.end(), [](const std::string& p) { return SyncFolder(p).ok(); });
}

absl::Status RemoveOthers(const std::string& folder, const std::set<std::string>& digests) {
  namespace fs = std::filesystem;
  std::error_code error;
  std::vector<fs::path> others;
  for (fs::recursive_directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    if (at->is_directory(error)) continue;
    const std::string digest = at->path().parent_path().filename().string() + at->path().filename().string();
    if (!digests.contains(digest)) others.push_back(at->path());
  }
  for (const fs::path& other : others) fs::remove(other, error);
  return error ? ErrnoStatus(error.value(), "cannot look through it", folder) : absl::OkStatus();
}

}  // namespace

BlobFolder::Writer::~Writer() {
  if (fd_ >= 0) ::close(fd_);
  if (!path_.empty()) ::unlink(path_.c_str());
}

absl::Status BlobFolder::Writer::Append(std::string_view bytes) {
  sha_.Update(bytes);
  return Write(bytes);
}

absl::Status BlobFolder::Writer::Write(std::string_view bytes) {
  size_ += static_cast<int64_t>(bytes.size());
  if (size_ > kMaxBlobBytes) {
    return WithErrorInfo(
        absl::ResourceExhaustedError(absl::StrCat("a blob may have ", kMaxBlobBytes, " bytes at most")),
        {"BLOB_TOO_LARGE", {{"limit", absl::StrCat(kMaxBlobBytes)}}});
  }
  while (!bytes.empty()) {
    const ssize_t n = ::write(fd_, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return ErrnoStatus(errno, "cannot write", path_);
    bytes.remove_prefix(static_cast<size_t>(n));
  }
  return absl::OkStatus();
}

absl::StatusOr<int64_t> BlobFolder::Writer::Commit(const std::string& expected) {
  const std::string digest = sha_.FinishHex();
  if (digest != expected) {
    return WithErrorInfo(
        absl::InvalidArgumentError(absl::StrCat("blob ", expected, ": its ", size_, " bytes have the digest ", digest)),
        {"BLOB_CORRUPT", {{"digest", expected}}});
  }
  TILEMEND_RETURN_IF_ERROR(MoveTo(digest));
  return size_;
}

absl::Status BlobFolder::Writer::MoveTo(const std::string& digest) {
  if (sync_ == Sync::kYes) {
    if (FailPoint("blob.sync")) return ErrnoStatus(EIO, "cannot sync (injected)", path_);
    if (::fsync(fd_) != 0) return ErrnoStatus(errno, "cannot sync", path_);
  }
  const int closed = ::close(std::exchange(fd_, -1));
  if (closed != 0) return ErrnoStatus(errno, "cannot close", path_);
  TILEMEND_RETURN_IF_ERROR(folder_.MoveIntoPlace(path_, digest, sync_));
  path_.clear();
  return absl::OkStatus();
}

absl::StatusOr<std::shared_ptr<BlobFolder>> BlobFolder::Create(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) return ErrnoStatus(error.value(), "cannot create folder", path);
  return std::make_shared<BlobFolder>(path);
}

absl::StatusOr<std::string> BlobFolder::Put(std::string_view bytes, Sync sync, std::string known) {
  std::string digest = known.empty() ? Sha256Hex(bytes) : std::move(known);
  if (sync == Sync::kNo && Size(digest).ok()) return digest;
  TILEMEND_ASSIGN_OR_RETURN(const std::unique_ptr<Writer> writer, NewWriter(sync));
  TILEMEND_RETURN_IF_ERROR(writer->Write(bytes));
  TILEMEND_RETURN_IF_ERROR(writer->MoveTo(digest));
  return digest;
}

absl::Status BlobFolder::Hold(const std::string& digest, const std::function<absl::StatusOr<std::string>()>& read) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (const auto held = held_.find(digest); held != held_.end()) {
      ++held->second.times;
      return absl::OkStatus();
    }
  }
  TILEMEND_ASSIGN_OR_RETURN(std::string bytes, read());
  const size_t size = bytes.size();
  const bool in_memory = TakeMemory(size);
  if (!in_memory) TILEMEND_RETURN_IF_ERROR(Put(bytes, Sync::kNo, digest).status());
  std::lock_guard<std::mutex> lock(mutex_);
  HeldBlob& blob = held_[digest];
  const bool is_first = blob.times++ == 0;
  if (is_first && in_memory) blob.bytes = std::make_shared<const std::string>(std::move(bytes));
  if (!is_first && in_memory) HeldInAll().fetch_sub(size);  // another thread was quicker
  return absl::OkStatus();
}

void BlobFolder::LetGo(const std::string& digest) {
  std::lock_guard<std::mutex> lock(mutex_);
  const auto held = held_.find(digest);
  if (held == held_.end() || --held->second.times > 0) return;
  HeldInAll().fetch_sub(held->second.MemoryBytes());
  held_.erase(held);
}

void BlobFolder::LetGoOfAll() {
  std::lock_guard<std::mutex> lock(mutex_);
  for (const auto& [digest, held] : held_) HeldInAll().fetch_sub(held.MemoryBytes());
  held_.clear();
}

std::shared_ptr<const std::string> BlobFolder::HeldBytes(const std::string& digest) const {
  std::lock_guard<std::mutex> lock(mutex_);
  const auto held = held_.find(digest);
  return held == held_.end() ? nullptr : held->second.bytes;
}

absl::StatusOr<std::unique_ptr<BlobFolder::Writer>> BlobFolder::NewWriter(Sync sync) {
  if (removed_.load()) return absl::FailedPreconditionError(absl::StrCat(path_, ": the job is over"));
  // Of a name that is free: a coordinator that was stopped and wakes may write here until it finds itself replaced.
  std::string path = absl::StrCat(path_, "/part-XXXXXX");
  const int fd = ::mkostemp(path.data(), O_CLOEXEC);
  if (fd < 0) return ErrnoStatus(errno, "cannot create", path);
  return std::unique_ptr<Writer>(new Writer(*this, sync, std::move(path), fd));
}

absl::Status BlobFolder::MoveIntoPlace(const std::string& temporary, const std::string& digest, Sync sync) {
  TILEMEND_ASSIGN_OR_RETURN(const std::string path, PathOf(path_, digest));
  const std::string parent = absl::StrCat(path_, "/", digest.substr(0, kParentDigits));
  if (::rename(temporary.c_str(), path.c_str()) != 0) {
    // Not create_directories: it would bring a removed folder back.
    if (::mkdir(parent.c_str(), 0700) != 0 && errno != EEXIST)
      return ErrnoStatus(errno, "cannot create folder", parent);
    if (::rename(temporary.c_str(), path.c_str()) != 0) return ErrnoStatus(errno, "cannot rename into place", path);
  }
  if (sync == Sync::kNo) return absl::OkStatus();
  FailPoint("blob.renamed");
  TILEMEND_RETURN_IF_ERROR(SyncFolder(parent));
  const uint32_t bit = uint32_t{1} << (digest[0] <= '9' ? digest[0] - '0' : digest[0] - 'a' + 10);
  if ((synced_parents_.load() & bit) != 0) return absl::OkStatus();
  if (FailPoint("blob.parent")) return ErrnoStatus(EIO, "cannot sync (injected)", path_);
  TILEMEND_RETURN_IF_ERROR(SyncFolder(path_));  // in which another blob may have made `parent`
  synced_parents_.fetch_or(bit);
  return absl::OkStatus();
}

absl::StatusOr<int64_t> BlobFolder::Size(const std::string& digest) const {
  if (const auto held = HeldBytes(digest)) return static_cast<int64_t>(held->size());
  TILEMEND_ASSIGN_OR_RETURN(const std::string path, PathOf(path_, digest));
  struct stat info {};
  if (::stat(path.c_str(), &info) != 0) return BlobNotFound(digest);
  return static_cast<int64_t>(info.st_size);
}

absl::StatusOr<std::string> BlobFolder::Read(const std::string& digest) const {
  if (const auto held = HeldBytes(digest)) return *held;
  TILEMEND_ASSIGN_OR_RETURN(const int64_t size, Size(digest));
  std::string bytes;
  bytes.reserve(static_cast<size_t>(size));
  TILEMEND_RETURN_IF_ERROR(ReadChunks(digest, [&bytes](std::string_view chunk) {
    bytes.append(chunk);
    return true;
  }));
  if (Sha256Hex(bytes) == digest) return bytes;
  return WithErrorInfo(absl::UnavailableError(absl::StrCat("blob ", digest, ": damaged in ", path_)),
                       {"BLOB_DAMAGED", {{"digest", digest}}});
}

absl::Status BlobFolder::ReadChunks(const std::string& digest,
                                    const std::function<bool(std::string_view)>& take) const {
  if (const auto held = HeldBytes(digest)) {
    for (size_t at = 0; at < held->size(); at += kMaxChunkBytes) {
      if (!take(std::string_view(*held).substr(at, kMaxChunkBytes))) break;
    }
    return absl::OkStatus();
  }
  TILEMEND_ASSIGN_OR_RETURN(const std::string path, PathOf(path_, digest));
  TILEMEND_ASSIGN_OR_RETURN(const int64_t size, Size(digest));
  const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) return errno == ENOENT ? BlobNotFound(digest) : ErrnoStatus(errno, "cannot open", path);
  const auto close = absl::MakeCleanup([fd] { ::close(fd); });
  std::string buffer(std::min<size_t>(static_cast<size_t>(size), kMaxChunkBytes), '\0');
  while (!buffer.empty()) {
    const ssize_t n = ::read(fd, buffer.data(), buffer.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return ErrnoStatus(errno, "cannot read", path);
    if (n == 0 || !take(std::string_view(buffer.data(), static_cast<size_t>(n)))) break;
  }
  return absl::OkStatus();
}

absl::Status BlobFolder::KeepOnly(const std::set<std::string>& digests) {
  std::string beside = absl::StrCat(path_, ".XXXXXX");
  if (::mkdtemp(beside.data()) == nullptr) return ErrnoStatus(errno, "cannot create", beside);
  const bool changed = LinkBlobs(path_, digests, beside) &&
                       ::renameat2(AT_FDCWD, beside.c_str(), AT_FDCWD, path_.c_str(), RENAME_EXCHANGE) == 0;
  if (changed) {
    synced_parents_.store(0);  // they were of the folder that is now beside this one
    return SyncFolder(std::filesystem::path(path_).parent_path().string());
  }
  std::error_code error;
  std::filesystem::remove_all(beside, error);
  return RemoveOthers(path_, digests);
}

void BlobFolder::Remove(const std::function<bool()>& stop) {
  namespace fs = std::filesystem;
  removed_.store(true);
  LetGoOfAll();
  std::error_code error;
  std::vector<fs::path> files;
  for (fs::recursive_directory_iterator at(path_, error), end; !error && at != end; at.increment(error)) {
    if (!at->is_directory(error)) files.push_back(at->path());
  }
  for (const fs::path& file : files) {
    if (stop()) return;
    fs::remove(file, error);
  }
  // Twice: a write that began before may put a file in after the folder was listed.
  fs::remove_all(path_, error);
  fs::remove_all(path_, error);
}

}  // namespace tilemend
