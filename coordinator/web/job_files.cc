#include "coordinator/web/job_files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stop_token>
#include <system_error>

#include "absl/strings/ascii.h"
#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_split.h"
#include "common/grid/delivery_paths.h"
#include "common/store/file_stamp.h"
#include "common/util/error_info.h"
#include "common/util/files.h"
#include "common/util/folders.h"
#include "common/util/object_store.h"
#include "common/util/roots.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"
#include "common/util/tile_files.h"
#include "coordinator/report/changed_options.h"
#include "coordinator/report/json_access.h"
#include "coordinator/report/page_holes.h"
#include "coordinator/report/page_review.h"
#include "coordinator/report/shallow_json.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

constexpr char kSceneFileName[] = "scene.json";
constexpr char kReportName[] = "report.json";
constexpr char kHolesName[] = "holes.geojson";
constexpr size_t kMostReadAtOnce = size_t{16} << 20;  // then it is looked whether to stop

absl::Status NoTile(const std::string& what) {
  return WithErrorInfo(absl::NotFoundError(what), {"TILE_NOT_FOUND", {}});
}

absl::Status TooLarge(const std::string& path, int64_t most) {
  return WithErrorInfo(absl::ResourceExhaustedError(absl::StrCat(path, ": larger than ", most, " bytes")),
                       {"TOO_LARGE", {{"limit", absl::StrCat(most)}}});
}

// A file descriptor that closes itself.
class OpenedFile {
 public:
  explicit OpenedFile(int fd) : fd_(fd) {}
  ~OpenedFile() {
    if (fd_ >= 0) close(fd_);
  }
  OpenedFile(const OpenedFile&) = delete;
  OpenedFile& operator=(const OpenedFile&) = delete;
  int fd() const { return fd_; }

 private:
  const int fd_;
};

absl::StatusOr<std::string> ReadAll(int fd, int64_t size, const std::string& path, const std::stop_token& stop) {
  std::string bytes(static_cast<size_t>(size), '\0');
  size_t at = 0;
  while (at < bytes.size()) {
    if (stop.stop_requested()) return absl::CancelledError(absl::StrCat(path, ": asked to end while it was read"));
    const ssize_t count = read(fd, bytes.data() + at, std::min(bytes.size() - at, kMostReadAtOnce));
    if (count <= 0) return absl::DataLossError(absl::StrCat(path, ": it ends before its size"));
    at += static_cast<size_t>(count);
  }
  return bytes;
}

// An object below `folder`, as below.
absl::StatusOr<std::string> ReadObjectBelow(const std::string& folder, const std::string& path, int64_t most) {
  const std::string whole = absl::StrCat(folder, "/", path);
  const auto look = LookAt(whole);
  if (absl::IsNotFound(look.status())) return NoTile(absl::StrCat(path, ": no such file in its folder"));
  TILEMEND_RETURN_IF_ERROR(look.status());
  if (look->size > most) return TooLarge(path, most);
  return ReadFileUpTo(whole, most);
}

// A regular file below `folder`; what a link leads out to is as if it was not there.
absl::StatusOr<std::string> ReadBelow(const std::string& folder, const std::string& path, int64_t most,
                                      const std::stop_token& stop = {}) {
  if (IsObjectPath(folder)) return ReadObjectBelow(folder, path, most);
  if (FilesRoots() != nullptr) TILEMEND_RETURN_IF_ERROR(FilesRoots()->Check(folder));
  std::error_code error;
  const std::string absolute = std::filesystem::absolute(folder, error).lexically_normal().string();
  TILEMEND_ASSIGN_OR_RETURN(const auto root, Roots::Open({absolute}));
  const std::string whole = absl::StrCat(absolute, "/", path);
  const OpenedFile file(root->OpenFile(whole, O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct stat look {};
  if (file.fd() < 0 || fstat(file.fd(), &look) != 0 || !S_ISREG(look.st_mode)) {
    return NoTile(absl::StrCat(path, ": no such file in its folder"));
  }
  if (look.st_size > most) {
    return TooLarge(path, most);
  }
  return ReadAll(file.fd(), look.st_size, path, stop);
}

// The folder of the tiles of a scene that is a folder, or a file in it.
std::string FolderOf(const std::string& scene) {
  return KindOf(scene) == PathKind::kFolder ? scene : std::filesystem::path(scene).parent_path().string();
}

bool IsFile(const std::string& path) { return KindOf(path) == PathKind::kFile; }

// Where the tiles of a job that is over lie, without reading them. If the scene has no scene.json, that beside the
// output has the same tiles, unless it is in another format: then they are found by their names.
absl::StatusOr<Scene> TilesOf(const JobSpec& spec) {
  for (const std::string& path : {spec.scene(), absl::StrCat(spec.scene(), "/", kSceneFileName)}) {
    if (absl::EndsWith(path, ".json") && !IsTileset(path) && IsFile(path)) return LoadScene(path, nullptr);
  }
  const bool is_delivery = !spec.output_format().empty() && spec.output_format() != "same";
  const std::string beside = absl::StrCat(spec.out(), "/", kSceneFileName);
  const bool has_file = !spec.out().empty() && IsFile(beside);
  if (has_file && !is_delivery) return LoadScene(beside, nullptr);
  absl::StatusOr<Scene> named = FindSceneWithoutGrid(FolderOf(spec.scene()));
  if (named.ok()) return named;
  if (has_file) return LoadScene(beside, nullptr);
  return WithErrorInfo(
      absl::NotFoundError("the scene has no scene.json, and no tiles with a column and a row as names"),
      {"SCENE_FILE_NOT_FOUND", {}});
}

LoadedValues<SceneSight>::Result LoadSight(const JobSpec& spec) {
  TILEMEND_ASSIGN_OR_RETURN(Scene scene, TilesOf(spec));
  scene.root = FolderOf(spec.scene());
  TILEMEND_RETURN_IF_ERROR(SetDeliveryPaths(spec.output_format(), scene));
  return std::make_shared<const SceneSight>(scene);
}

absl::Status ReplacedBy(const std::string& name, const std::string& other, const std::string& what) {
  const std::string id = other.substr(other.find('/') + 1);
  return WithErrorInfo(absl::AbortedError(absl::StrCat(name, ": its output ", what)),
                       {"OUTPUT_REPLACED", {{"job", id}}});
}

std::string BesideOutput(const JobSpec& spec, const char* file) { return absl::StrCat(spec.out(), "/", file); }

// Whether what lies in the output is still that of the job, as far as the coordinator knows: OUTPUT_REPLACED. A later
// job that is not complete takes the report away before it writes.
absl::Status CheckIsLast(const std::string& name, const JobCells& job) {
  if (job.later_job.empty()) return absl::OkStatus();
  if (job.later_is_complete) {
    return ReplacedBy(name, job.later_job, absl::StrCat("was written again by ", job.later_job, "; look there"));
  }
  TILEMEND_ASSIGN_OR_RETURN(const PathKind report, FindKind(BesideOutput(job.spec, kReportName)));
  if (report != PathKind::kNothing) return absl::OkStatus();
  return ReplacedBy(name, job.later_job,
                    absl::StrCat("is being written again by ", job.later_job, ", or was; look there"));
}

// Whether a report can be that of the job. That of a program elsewhere in the same folder has another scene or other
// decisions, else it says the same.
absl::Status CheckIsReportOf(const std::string& name, const JobSpec& spec, const Json& report) {
  const Json &scene = Member(report, "scene"), &decisions = Member(Member(report, "options"), "decisions");
  if ((!scene.is_string() || scene == spec.scene()) && (!decisions.is_string() || decisions == spec.decisions())) {
    return absl::OkStatus();
  }
  return ReplacedBy(name, "",
                    "was written again, with another scene or other decisions, by no job of this coordinator");
}

absl::StatusOr<Json> ReadReport(const std::string& name, const JobSpec& spec, const std::stop_token& stop) {
  TILEMEND_ASSIGN_OR_RETURN(const std::string text, ReadBelow(spec.out(), kReportName, kMostReportBytes, stop));
  Json report = ParseShallow(text, {.stop = stop});
  if (!report.is_object()) {
    return absl::DataLossError(absl::StrCat(BesideOutput(spec, kReportName), ": not JSON"));
  }
  TILEMEND_RETURN_IF_ERROR(CheckIsReportOf(name, spec, report));
  return report;
}

std::shared_ptr<const std::string> TextOf(const Json& json) {
  return std::make_shared<const std::string>(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

LoadedValues<std::string>::Result LoadHoles(const std::string& name, const JobSpec& spec, const std::stop_token& stop) {
  TILEMEND_ASSIGN_OR_RETURN(const Json report, ReadReport(name, spec, stop));
  const Json& warnings = Member(report, "warnings");
  return TextOf({{"holeCount", ChosenHoles(report).size()},
                 {"holes", PageHoles(report, kMostListedHoles)},
                 {"planned", false},
                 {"date", Member(report, "date")},  // tells a report from the one before, even with the same holes
                 {"fillsToDecide", FillsToDecideOn(report)},
                 {"warnings", warnings.is_array() ? warnings : Json::array()}});
}

// The height of the levels' zero is that of the scene.json that says where the tiles lie.
LoadedValues<std::string>::Result LoadReview(const std::string& name, const JobSpec& spec,
                                             const std::stop_token& stop) {
  TILEMEND_ASSIGN_OR_RETURN(const Json report, ReadReport(name, spec, stop));
  TILEMEND_ASSIGN_OR_RETURN(const std::string holes, ReadBelow(spec.out(), kHolesName, kMostReportBytes, stop));
  const auto scene = TilesOf(spec);
  TILEMEND_ASSIGN_OR_RETURN(Json review, PageReview(report, holes, scene.ok() ? &*scene : nullptr, stop));
  return TextOf({{"scene", Member(report, "scene")},
                 {"out", spec.out()},
                 {"changed_options", ChangedOptions(report)},
                 {"date", Member(report, "date")},
                 {"look_at", Member(report, "look_at")},
                 {"review", std::move(review)}});
}

// Names what was read of these files of the output: another one if a file has changed since.
std::string KeyOf(const std::string& name, const JobSpec& spec, std::initializer_list<const char*> files) {
  std::string key = name;
  for (const char* file : files) absl::StrAppend(&key, " ", YoungStampOf(BesideOutput(spec, file)));
  return key;
}

absl::Status NoReport(const std::string& name) {
  return WithErrorInfo(absl::NotFoundError(absl::StrCat(name, ": there is no report yet")), {"REPORT_NOT_FOUND", {}});
}

// Whether a file beside a tile may be one that the tile names; both are relative to one folder, and normal.
bool MayBelongTo(const std::string& tile, const std::string& path) {
  for (const absl::string_view part : absl::StrSplit(path, '/')) {
    if (part.empty() || part.front() == '.') return false;
  }
  const std::string ending = absl::AsciiStrToLower(path.substr(std::min(path.rfind('.'), path.size() - 1)));
  constexpr const char* kBeside[] = {".mtl", ".jpg", ".jpeg", ".png"};
  if (std::ranges::find(kBeside, ending) != std::end(kBeside)) return true;
  return IsTileTree(tile) && IsFileOfTree(tile, path) && IsTreeFile(path);
}

std::string NameOf(const std::string& path) { return path.substr(path.rfind('/') + 1); }

}  // namespace

absl::StatusOr<std::shared_ptr<const SceneSight>> JobFiles::SightOf(const std::string& name, const JobCells& job) {
  if (job.sight != nullptr) {
    sights_.Keep(name, job.sight);
    return job.sight;
  }
  if (!IsOver(job.state)) {
    return WithErrorInfo(absl::NotFoundError("the scene is not read yet"), {"SCENE_FILE_NOT_FOUND", {}});
  }
  return sights_.Find(name, [spec = job.spec](const std::stop_token&) { return LoadSight(spec); });
}

absl::StatusOr<std::shared_ptr<const std::string>> JobFiles::HolesOf(const std::string& name, const JobCells& job) {
  if (!job.report.empty()) {
    TILEMEND_RETURN_IF_ERROR(CheckIsLast(name, job));
    return holes_.Find(KeyOf(name, job.spec, {kReportName}),
                       [name, spec = job.spec](const std::stop_token& stop) { return LoadHoles(name, spec, stop); });
  }
  auto planned = job.sight == nullptr ? nullptr : job.sight->planned_holes();
  if (planned == nullptr) return NoReport(name);
  return planned;
}

absl::StatusOr<std::shared_ptr<const std::string>> JobFiles::ReviewOf(const std::string& name, const JobCells& job) {
  if (job.report.empty()) return NoReport(name);
  TILEMEND_RETURN_IF_ERROR(CheckIsLast(name, job));
  return reviews_.Find(KeyOf(name, job.spec, {kReportName, kHolesName}),
                       [name, spec = job.spec](const std::stop_token& stop) { return LoadReview(name, spec, stop); });
}

absl::StatusOr<JobFiles::File> JobFiles::FileOf(const std::string& name, const JobCells& job, CellId cell, bool after,
                                                const std::string& path) {
  if (after) TILEMEND_RETURN_IF_ERROR(CheckIsLast(name, job));
  TILEMEND_ASSIGN_OR_RETURN(const auto sight, SightOf(name, job));
  auto tile = sight->TileOf(cell, after);
  if (!tile) return NoTile(absl::StrCat("cell ", cell.col, ", ", cell.row, ": it has no tile"));
  std::string file = tile->path;
  if (!path.empty()) {
    file = (std::filesystem::path(tile->path).parent_path() / path).lexically_normal().string();
    if (!MayBelongTo(tile->path, file)) return NoTile(absl::StrCat(Printable(path), ": not a file of this tile"));
  }
  TILEMEND_ASSIGN_OR_RETURN(std::string bytes, ReadBelow(after ? job.spec.out() : sight->root(), file, kMostTileBytes));
  return File{NameOf(file), std::move(bytes), std::move(tile->frame)};
}

}  // namespace tilemend
