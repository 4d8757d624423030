#include "coordinator/store/result_log.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "absl/cleanup/cleanup.h"
#include "absl/strings/escaping.h"
#include "absl/strings/str_cat.h"
#include "common/rpc/limits.h"
#include "common/store/digest.h"
#include "common/util/files.h"
#include "common/util/folders.h"
#include "common/util/place.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

constexpr std::string_view kHead = "tilemend-results-2\n";
constexpr uint32_t kMark = 0x746d5231;  // "tmR1"

absl::Status LogError(const std::string& path, const char* what) {
  const std::string text = absl::StrCat(path, ": ", what, ": ", std::strerror(errno));
  return errno == ENOSPC || errno == EDQUOT ? absl::ResourceExhaustedError(text) : absl::UnavailableError(text);
}

bool WriteAt(int fd, std::string_view bytes, int64_t offset) {
  while (!bytes.empty()) {
    const ssize_t n = ::pwrite(fd, bytes.data(), bytes.size(), offset);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return false;
    bytes.remove_prefix(static_cast<size_t>(n));
    offset += n;
  }
  return true;
}

bool ReadAt(int fd, char* bytes, size_t size, int64_t offset) {
  while (size > 0) {
    const ssize_t n = ::pread(fd, bytes, size, offset);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    bytes += n;
    offset += n;
    size -= static_cast<size_t>(n);
  }
  return true;
}

bool Rename(const std::string& from, const std::string& to) {
  const Place old_place(from), new_place(to);
  return ::renameat(old_place.at(), old_place.name.c_str(), new_place.at(), new_place.name.c_str()) == 0;
}

}  // namespace

// As it lies in the file, before the result. The log stays on machines of one kind.
struct ResultLog::Record {
  uint32_t mark = kMark;
  uint32_t begins = 0;  // a job begins; there is no result
  Name name{};
  int64_t bytes = 0;
  Name sum{};  // of all of the above and the digest of the result

  int64_t size() const { return static_cast<int64_t>(sizeof(Record)) + bytes; }
  Name SumWith(const std::string& result_digest) const {
    Sha256 sha;
    sha.Update({reinterpret_cast<const char*>(this), offsetof(Record, sum)});
    sha.Update(result_digest);
    const std::string digest = absl::HexStringToBytes(sha.FinishHex());
    Name sum_of_all;
    std::copy_n(digest.begin(), sum_of_all.size(), sum_of_all.begin());
    return sum_of_all;
  }
};

namespace {

std::array<char, 16> NameOf(const std::string& key) {
  const std::string bytes = absl::HexStringToBytes(key);
  std::array<char, 16> name{};
  std::copy_n(bytes.begin(), std::min(bytes.size(), name.size()), name.begin());
  return name;
}

}  // namespace

absl::StatusOr<ResultLog> ResultLog::Open(const std::string& path, Opening how) {
  const int fd = OpenKept(path, O_RDWR | O_CLOEXEC | O_NOFOLLOW);
  if (fd < 0 && errno != ENOENT) return LogError(path, "cannot open what earlier jobs left for this one");
  ResultLog log(path, fd);
  if (fd >= 0) TILEMEND_RETURN_IF_ERROR(log.Scan(how));
  return log;
}

ResultLog::ResultLog(ResultLog&& other) noexcept
    : path_(std::move(other.path_)),
      fd_(std::exchange(other.fd_, -1)),
      made_(other.made_),
      end_(other.end_),
      begun_(other.begun_),
      earlier_(std::move(other.earlier_)),
      own_(std::move(other.own_)),
      put_(std::move(other.put_)) {}

ResultLog::~ResultLog() {
  if (fd_ >= 0) ::close(fd_);
}

absl::Status ResultLog::Scan(Opening how) {
  std::string head(kHead.size(), '\0');
  if (!ReadAt(fd_, head.data(), head.size(), 0) || head != kHead) return absl::OkStatus();
  end_ = static_cast<int64_t>(kHead.size());
  int64_t begin = end_;  // of what the last job has put
  while (const auto record = ReadHead(end_)) {
    if (record->begins != 0) {
      begun_ = how != Opening::kNewJob;
      begin = end_ + record->size();
      for (auto& [name, place] : own_) earlier_[name] = place;
      own_.clear();
    } else {
      own_[record->name] = {end_, false};
    }
    end_ += record->size();
  }
  if (how == Opening::kSameJob) return absl::OkStatus();
  if (how == Opening::kSameJobAnew) {
    own_.clear();
    end_ = begin;
    return ::ftruncate(fd_, end_) == 0 ? absl::OkStatus() : LogError(path_, "cannot shorten it");
  }
  for (auto& [name, place] : own_) earlier_[name] = place;
  own_.clear();
  return earlier_.empty() ? absl::OkStatus() : Append({}, "", Sha256Hex(""), true);
}

std::optional<ResultLog::Record> ResultLog::ReadHead(int64_t offset) const {
  struct stat info {};
  Record record;
  if (::fstat(fd_, &info) != 0 || !ReadAt(fd_, reinterpret_cast<char*>(&record), sizeof(record), offset)) return {};
  if (record.mark != kMark || record.bytes < 0 || record.bytes > kMaxBlobBytes) return {};
  if (offset + record.size() > info.st_size) return {};
  return record;
}

std::optional<std::string> ResultLog::ReadResult(int64_t offset) const {
  const auto record = ReadHead(offset);
  if (!record) return {};
  std::string result(static_cast<size_t>(record->bytes), '\0');
  if (!ReadAt(fd_, result.data(), result.size(), offset + static_cast<int64_t>(sizeof(Record)))) return {};
  if (record->SumWith(Sha256Hex(result)) != record->sum) return {};
  return result;
}

std::optional<std::string> ResultLog::Find(const std::string& key) {
  const auto found = earlier_.find(NameOf(key));
  if (found == earlier_.end()) return std::nullopt;
  std::optional<std::string> result = ReadResult(found->second.offset);
  found->second.used = result.has_value();
  return result;
}

absl::Status ResultLog::Put(const std::string& key, std::string_view result, const std::string& digest) {
  const Name name = NameOf(key);
  if (const auto own = own_.find(name); own != own_.end() && ReadResult(own->second.offset) == result) {
    own->second.used = true;  // put before a restart
    return absl::OkStatus();
  }
  if (!begun_) TILEMEND_RETURN_IF_ERROR(Append({}, "", Sha256Hex(""), true));
  return Append(name, result, digest.empty() ? Sha256Hex(result) : digest, false);
}

absl::Status ResultLog::Append(const Name& name, std::string_view result, const std::string& digest, bool begins) {
  if (fd_ < 0) {
    fd_ = OpenKept(path_, O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0644);
    made_ = fd_ >= 0;
  }
  if (fd_ < 0) return LogError(path_, "cannot make it");
  if (end_ == 0) {
    if (::ftruncate(fd_, 0) != 0 || !WriteAt(fd_, kHead, 0)) return LogError(path_, "cannot write");
    end_ = static_cast<int64_t>(kHead.size());
  }
  Record record{.begins = begins, .name = name, .bytes = static_cast<int64_t>(result.size())};
  record.sum = record.SumWith(digest);
  const std::string_view head(reinterpret_cast<const char*>(&record), sizeof(record));
  // The head last: a record is there when all of it is.
  if (!WriteAt(fd_, result, end_ + static_cast<int64_t>(head.size())) || !WriteAt(fd_, head, end_)) {
    return LogError(path_, "cannot write");
  }
  if (begins) {
    begun_ = true;
  } else {
    put_.push_back(end_);
  }
  end_ += record.size();
  return absl::OkStatus();
}

void ResultLog::Discard() {
  if (std::exchange(made_, false)) RemoveFile(path_).IgnoreError();
}

absl::Status ResultLog::KeepUsed() {
  std::vector<int64_t> kept = put_;
  int64_t bytes = static_cast<int64_t>(kHead.size());
  for (const auto* places : {&earlier_, &own_}) {
    for (const auto& [name, place] : *places) {
      if (!place.used) continue;
      kept.push_back(place.offset);
    }
  }
  std::sort(kept.begin(), kept.end());
  for (const int64_t offset : kept) {
    if (const auto record = ReadHead(offset)) bytes += record->size();
  }
  // What marks the beginnings of jobs is not worth a copy.
  if (kept.empty() || bytes + 16 * static_cast<int64_t>(sizeof(Record)) >= end_) return absl::OkStatus();
  const std::string part = absl::StrCat(path_, kPartSuffix, "1");
  const int to = OpenKept(part, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0644);
  if (to < 0) return LogError(part, "cannot make it");
  auto give_up = absl::MakeCleanup([&] {
    ::close(to);
    RemoveFile(part).IgnoreError();
  });
  int64_t end = static_cast<int64_t>(kHead.size());
  if (!WriteAt(to, kHead, 0)) return LogError(part, "cannot write");
  for (const int64_t offset : kept) {
    const auto record = ReadHead(offset);
    if (!record) continue;
    std::string whole(static_cast<size_t>(record->size()), '\0');
    if (!ReadAt(fd_, whole.data(), whole.size(), offset) || !WriteAt(to, whole, end)) {
      return LogError(part, "cannot write");
    }
    end += record->size();
  }
  if (!Rename(part, path_)) return LogError(part, "cannot rename into place");
  std::move(give_up).Cancel();
  ::close(to);
  return absl::OkStatus();
}

}  // namespace tilemend
