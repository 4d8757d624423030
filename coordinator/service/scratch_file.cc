#include "coordinator/service/scratch_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

template <typename T>
std::string_view BytesOf(const std::vector<T>& column) {
  // Read back by this process alone, whose layout it is.
  static_assert(std::is_standard_layout_v<T> && std::is_trivially_destructible_v<T>);
  return {reinterpret_cast<const char*>(column.data()), column.size() * sizeof(T)};
}

absl::Status Failed(int error, const char* what) {
  return absl::ErrnoToStatus(error, absl::StrCat("the file of what the job puts aside: ", what));
}

}  // namespace

struct ScratchFile::RecordPlaces {
  Place vertices, edges, colours, band_points, band_triangles;
};

struct ScratchFile::Kept {
  std::shared_ptr<const ScratchFile> file;
  SurveySummary summary;
  RecordPlaces places;
};

absl::StatusOr<std::shared_ptr<ScratchFile>> ScratchFile::Create(const std::string& folder) {
  std::error_code error;
  const std::filesystem::path base =
      folder.empty() ? std::filesystem::temp_directory_path(error) : std::filesystem::path(folder);
  std::string path = (base / "tilemend-scratch-XXXXXX").string();
  const int fd = mkostemp(path.data(), O_CLOEXEC);
  if (error || fd < 0) return absl::ErrnoToStatus(errno, absl::StrCat(base.string(), ": cannot make a file there"));
  unlink(path.c_str());
  return std::shared_ptr<ScratchFile>(new ScratchFile(fd));
}

ScratchFile::~ScratchFile() { close(fd_); }

absl::StatusOr<ScratchFile::Place> ScratchFile::Put(std::string_view bytes) {
  const auto size = static_cast<int64_t>(bytes.size());
  const Place place{end_.fetch_add(size), size};
  for (int64_t at = place.at; !bytes.empty();) {
    const ssize_t written = pwrite(fd_, bytes.data(), bytes.size(), at);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return Failed(errno, "cannot write");
    bytes.remove_prefix(static_cast<size_t>(written));
    at += written;
  }
  return place;
}

absl::Status ScratchFile::ReadInto(int64_t at, void* data, size_t size) const {
  for (auto* to = static_cast<char*>(data); size > 0;) {
    const ssize_t read = pread(fd_, to, size, at);
    if (read < 0 && errno == EINTR) continue;
    if (read <= 0) return Failed(read < 0 ? errno : EIO, "cannot read");
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

template <typename T>
absl::Status ScratchFile::ReadColumn(const Place& place, std::vector<T>& column) const {
  column.resize(static_cast<size_t>(place.size) / sizeof(T));
  return ReadInto(place.at, column.data(), static_cast<size_t>(place.size));
}

absl::StatusOr<SurveyRecord> ScratchFile::ReadRecord(const SurveySummary& summary, const RecordPlaces& places,
                                                     bool with_band) const {
  SurveyRecord record;
  static_cast<SurveySummary&>(record) = summary;
  TILEMEND_RETURN_IF_ERROR(ReadColumn(places.vertices, record.vertices));
  TILEMEND_RETURN_IF_ERROR(ReadColumn(places.edges, record.edges));
  TILEMEND_RETURN_IF_ERROR(ReadColumn(places.colours, record.colours));
  if (!with_band) return record;
  TILEMEND_RETURN_IF_ERROR(ReadColumn(places.band_points, record.band.points));
  TILEMEND_RETURN_IF_ERROR(ReadColumn(places.band_triangles, record.band.triangles));
  return record;
}

absl::StatusOr<StoredRecord> ScratchFile::Keep(const SurveyRecord& record) {
  // Once for all copies of the handle, of which there are several for each cell of a scene.
  const auto kept = std::make_shared<Kept>();
  RecordPlaces& places = kept->places;
  TILEMEND_ASSIGN_OR_RETURN(places.vertices, Put(BytesOf(record.vertices)));
  TILEMEND_ASSIGN_OR_RETURN(places.edges, Put(BytesOf(record.edges)));
  TILEMEND_ASSIGN_OR_RETURN(places.colours, Put(BytesOf(record.colours)));
  TILEMEND_ASSIGN_OR_RETURN(places.band_points, Put(BytesOf(record.band.points)));
  TILEMEND_ASSIGN_OR_RETURN(places.band_triangles, Put(BytesOf(record.band.triangles)));
  kept->file = shared_from_this();
  kept->summary = record;
  const auto read = [kept](bool with_band) {
    absl::StatusOr<SurveyRecord> again = kept->file->ReadRecord(kept->summary, kept->places, with_band);
    if (!again.ok()) throw std::runtime_error(std::string(again.status().message()));
    return std::make_shared<const SurveyRecord>(*std::move(again));
  };
  return StoredRecord(record, read);
}

}  // namespace tilemend
