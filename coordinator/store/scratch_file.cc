#include "coordinator/store/scratch_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <tuple>
#include <type_traits>

#include "absl/strings/str_cat.h"
#include "common/util/place.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

// The columns of a record in the order in which they lie in the file, those of the band last.
template <class Record>
auto ColumnsOf(Record& record) {
  return std::tie(record.vertices, record.edges, record.colours, record.band.points, record.band.triangles);
}

constexpr size_t kOutlineColumns = 3;
constexpr size_t kColumns = 5;

template <typename T>
std::string_view BytesOf(const std::vector<T>& column) {
  // Read back by this process alone, whose layout it is.
  static_assert(std::is_standard_layout_v<T> && std::is_trivially_destructible_v<T>);
  return {reinterpret_cast<const char*>(column.data()), column.size() * sizeof(T)};
}

}  // namespace

// A record whose columns lie in the file one after the other.
class ScratchFile::StoredColumns : public StoredRecord::Source {
 public:
  StoredColumns(std::shared_ptr<ScratchFile> file, const SurveySummary& summary, int64_t at,
                const std::array<int32_t, kColumns>& sizes)
      : file_(std::move(file)), summary_(summary), at_(at), sizes_(sizes) {}

  const SurveySummary& summary() const override { return summary_; }

  StoredRecord::Pointer Read(bool with_band) const override {
    Records& recent = with_band ? file_->whole_ : file_->outlines_;
    if (auto known = recent.Find(at_)) return known;
    auto record = ReadColumns(with_band);
    const auto bytes_of = [](const auto&... columns) { return (BytesOf(columns).size() + ...); };
    recent.Put(at_, record, std::apply(bytes_of, ColumnsOf(*record)));
    return record;
  }

 private:
  StoredRecord::Pointer ReadColumns(bool with_band) const {
    const auto record = std::make_shared<SurveyRecord>();
    static_cast<SurveySummary&>(*record) = summary_;
    int64_t at = at_;
    size_t number = 0;
    const auto read = [&](auto& column) {
      if (!with_band && number == kOutlineColumns) return;
      column.resize(static_cast<size_t>(sizes_[number++]));
      const size_t bytes = BytesOf(column).size();
      const absl::Status status = file_->ReadInto(at, column.data(), bytes);
      if (!status.ok()) throw std::runtime_error(std::string(status.message()));
      at += static_cast<int64_t>(bytes);
    };
    std::apply([&](auto&... columns) { (read(columns), ...); }, ColumnsOf(*record));
    return record;
  }

  const std::shared_ptr<ScratchFile> file_;
  const SurveySummary summary_;
  const int64_t at_;
  const std::array<int32_t, kColumns> sizes_;  // entries
};

absl::StatusOr<std::shared_ptr<ScratchFile>> ScratchFile::Create(const std::string& folder) {
  std::error_code error;
  const std::filesystem::path base =
      folder.empty() ? std::filesystem::temp_directory_path(error) : std::filesystem::path(folder);
  std::string path = (base / "tilemend-scratch-XXXXXX").string();
  const int fd = mkostemp(path.data(), O_CLOEXEC);
  if (error || fd < 0) return absl::ErrnoToStatus(errno, absl::StrCat(base.string(), ": cannot make a file there"));
  unlink(path.c_str());
  return std::shared_ptr<ScratchFile>(new ScratchFile(fd, base.string()));
}

ScratchFile::~ScratchFile() { close(fd_); }

absl::StatusOr<ScratchFile::Place> ScratchFile::Put(std::string_view bytes) {
  const auto size = static_cast<int64_t>(bytes.size());
  const Place place{end_.fetch_add(size), size};
  TILEMEND_RETURN_IF_ERROR(WriteAt(place.at, bytes));
  return place;
}

absl::Status ScratchFile::WriteAt(int64_t at, std::string_view bytes) const {
  while (!bytes.empty()) {
    const ssize_t written = pwrite(fd_, bytes.data(), bytes.size(), at);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return ErrnoStatus(errno, "cannot write what the job puts aside", folder_);
    bytes.remove_prefix(static_cast<size_t>(written));
    at += written;
  }
  return absl::OkStatus();
}

absl::Status ScratchFile::ReadInto(int64_t at, void* data, size_t size) const {
  for (auto* to = static_cast<char*>(data); size > 0;) {
    const ssize_t read = pread(fd_, to, size, at);
    if (read < 0 && errno == EINTR) continue;
    if (read <= 0) return ErrnoStatus(read < 0 ? errno : EIO, "cannot read what the job puts aside", folder_);
    to += read;
    at += read;
    size -= static_cast<size_t>(read);
  }
  return absl::OkStatus();
}

absl::StatusOr<std::string> ScratchFile::Get(const Place& place) const {
  std::string bytes(static_cast<size_t>(place.size), '\0');
  TILEMEND_RETURN_IF_ERROR(ReadInto(place.at, bytes.data(), bytes.size()));
  return bytes;
}

absl::StatusOr<StoredRecord> ScratchFile::Keep(const SurveyRecord& record) {
  std::array<std::string_view, kColumns> bytes;
  std::array<int32_t, kColumns> sizes{};
  int64_t all = 0;
  size_t number = 0;
  const auto take = [&](const auto& column) {
    bytes[number] = BytesOf(column);
    sizes[number] = static_cast<int32_t>(column.size());
    all += static_cast<int64_t>(bytes[number++].size());
  };
  std::apply([&](const auto&... columns) { (take(columns), ...); }, ColumnsOf(record));
  const int64_t begin = end_.fetch_add(all);
  int64_t at = begin;
  for (const std::string_view column : bytes) {
    TILEMEND_RETURN_IF_ERROR(WriteAt(at, column));
    at += static_cast<int64_t>(column.size());
  }
  return StoredRecord(std::make_shared<StoredColumns>(shared_from_this(), record, begin, sizes));
}

}  // namespace tilemend
