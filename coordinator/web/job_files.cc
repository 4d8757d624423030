#include "coordinator/web/job_files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>

#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "common/util/error_info.h"
#include "common/util/folders.h"
#include "common/util/roots.h"
#include "common/util/status_macros.h"
#include "coordinator/report/page_holes.h"

namespace tilemend {
namespace {

constexpr char kSceneName[] = "scene.json";

absl::Status NoTile(const std::string& what) {
  return WithErrorInfo(absl::NotFoundError(what), {"TILE_NOT_FOUND", {}});
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

absl::StatusOr<std::string> ReadAll(int fd, int64_t size, const std::string& path) {
  std::string bytes(static_cast<size_t>(size), '\0');
  size_t at = 0;
  while (at < bytes.size()) {
    const ssize_t count = read(fd, bytes.data() + at, bytes.size() - at);
    if (count <= 0) return absl::DataLossError(absl::StrCat(path, ": it ends before its size"));
    at += static_cast<size_t>(count);
  }
  return bytes;
}

// A regular file below `folder`; what a link leads out to is as if it was not there.
absl::StatusOr<std::string> ReadBelow(const std::string& folder, const std::string& path, int64_t most) {
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
    return WithErrorInfo(absl::ResourceExhaustedError(absl::StrCat(path, ": larger than ", most, " bytes")),
                         {"TOO_LARGE", {{"limit", absl::StrCat(most)}}});
  }
  return ReadAll(file.fd(), look.st_size, path);
}

// Whether a scene at `path` says its grid itself, so that no mesh need be read.
bool HasSceneFile(const std::string& path) {
  return KindOf(absl::EndsWith(path, ".json") ? path : absl::StrCat(path, "/", kSceneName)) == PathKind::kFile;
}

}  // namespace

absl::StatusOr<std::shared_ptr<const Scene>> JobFiles::SceneOf(const std::string& name, const JobSpec& spec) {
  if (auto known = scenes_.Find(name)) return known;
  if (!HasSceneFile(spec.scene())) {
    return WithErrorInfo(absl::NotFoundError("the scene has no scene.json"), {"SCENE_FILE_NOT_FOUND", {}});
  }
  TILEMEND_ASSIGN_OR_RETURN(Scene scene, LoadScene(spec.scene(), nullptr));
  auto kept = std::make_shared<const Scene>(std::move(scene));
  scenes_.Keep(name, kept);
  return kept;
}

absl::StatusOr<std::shared_ptr<const std::string>> JobFiles::HolesOf(const std::string& name, const JobCells& job) {
  if (auto known = holes_.Find(name)) return known;
  if (job.report.empty()) {
    return WithErrorInfo(absl::NotFoundError(absl::StrCat(name, ": there is no report yet")), {"REPORT_NOT_FOUND", {}});
  }
  TILEMEND_ASSIGN_OR_RETURN(const std::string text, ReadBelow(job.spec.out(), "report.json", kMostReportBytes));
  const auto report = nlohmann::ordered_json::parse(text, nullptr, false);
  if (!report.is_object()) return absl::DataLossError(absl::StrCat(name, ": its report.json is not JSON"));
  nlohmann::ordered_json holes = {{"holeCount", HoleRowsOf(report).size()},
                                  {"holes", PageHoles(report, kMostListedHoles)}};
  auto kept =
      std::make_shared<const std::string>(holes.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  holes_.Keep(name, kept);
  return kept;
}

absl::StatusOr<JobFiles::Tile> JobFiles::TileOf(const std::string& name, const JobSpec& spec, CellId cell, bool after) {
  TILEMEND_ASSIGN_OR_RETURN(const auto scene, SceneOf(name, spec));
  const auto tile = std::ranges::find(scene->tiles, cell, &SceneTile::cell);
  if (tile == scene->tiles.end() || (!after && tile->path.empty())) {
    return NoTile(absl::StrCat("cell ", cell.col, ", ", cell.row, ": it has no tile"));
  }
  const std::string path = after ? OutputPath(*tile) : tile->path;
  TILEMEND_ASSIGN_OR_RETURN(std::string bytes, ReadBelow(after ? spec.out() : scene->root, path, kMostTileBytes));
  return Tile{path.substr(path.rfind('/') + 1), std::move(bytes)};
}

}  // namespace tilemend
