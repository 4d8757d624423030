// The files of jobs that the page shows: the scene's grid, the report's holes, the meshes of a cell.
#ifndef TILEMEND_COORDINATOR_WEB_JOB_FILES_H_
#define TILEMEND_COORDINATOR_WEB_JOB_FILES_H_

#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "absl/status/statusor.h"
#include "common/grid/scene.h"
#include "coordinator/api/jobs_handler.h"

namespace tilemend {

// Larger ones are not served: kResourceExhausted (TOO_LARGE).
inline constexpr int64_t kMostTileBytes = int64_t{64} << 20;
inline constexpr int64_t kMostReportBytes = int64_t{256} << 20;
// More holes than this are not listed one by one: those that were left come first, then the largest.
inline constexpr size_t kMostListedHoles = 20000;

// A few values by name: those that were asked for last. Thread-safe.
template <typename T>
class RecentValues {
 public:
  explicit RecentValues(size_t most) : most_(most) {}

  // Null if it is not kept.
  std::shared_ptr<const T> Find(const std::string& name) {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (auto it = values_.begin(); it != values_.end(); ++it) {
      if (it->first != name) continue;
      values_.splice(values_.begin(), values_, it);
      return it->second;
    }
    return nullptr;
  }
  void Keep(const std::string& name, std::shared_ptr<const T> value) {
    const std::lock_guard<std::mutex> lock(mutex_);
    values_.emplace_front(name, std::move(value));
    if (values_.size() > most_) values_.pop_back();
  }

 private:
  const size_t most_;
  std::mutex mutex_;
  std::list<std::pair<std::string, std::shared_ptr<const T>>> values_;  // the last asked first
};

// Nothing that comes with a request is ever a path: files are those that the job's scene names, and lie below its
// folder or the output's, links included. Thread-safe. Calls may wait for a disk.
class JobFiles {
 public:
  // The scene of a job. kNotFound if it has no scene.json yet; errors of LoadScene. Kept for the last jobs asked for.
  absl::StatusOr<std::shared_ptr<const Scene>> SceneOf(const std::string& name, const JobSpec& spec);

  // {"holeCount", "holes"} of the report, as JSON text. kNotFound (REPORT_NOT_FOUND) before there is one; errors of
  // reading.
  absl::StatusOr<std::shared_ptr<const std::string>> HolesOf(const std::string& name, const JobCells& job);

  struct Tile {
    std::string name;  // the last part of its path
    std::string bytes;
  };
  // The mesh of a cell, in the scene or in the output. kNotFound (TILE_NOT_FOUND) if the cell has none.
  absl::StatusOr<Tile> TileOf(const std::string& name, const JobSpec& spec, CellId cell, bool after);

 private:
  RecentValues<Scene> scenes_{8};
  RecentValues<std::string> holes_{4};
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_WEB_JOB_FILES_H_
