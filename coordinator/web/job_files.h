// The files of jobs that the page shows: the scene's grid, the holes and the review queue, the files of a cell's tile.
#ifndef TILEMEND_COORDINATOR_WEB_JOB_FILES_H_
#define TILEMEND_COORDINATOR_WEB_JOB_FILES_H_

#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "coordinator/api/jobs_handler.h"
#include "coordinator/report/scene_sight.h"
#include "coordinator/web/loaded_values.h"

namespace tilemend {

// Larger ones are not served: kResourceExhausted (TOO_LARGE).
inline constexpr int64_t kMostTileBytes = int64_t{64} << 20;
inline constexpr int64_t kMostReportBytes = int64_t{256} << 20;

// Files are those of a tile that the job's scene names. Beside it they have the name of a material file, an image or a
// part of its tree. All are opened below the scene's folder or the output's, links included. Thread-safe.
// Scenes and reports of jobs that are over are read in the background: kUnavailable until they are there. A report is
// read again once its files have changed. kAborted (OUTPUT_REPLACED) for the report and the output of a job if another
// one has written there since.
class JobFiles {
 public:
  // What may be seen of the scene of a job. kNotFound (SCENE_FILE_NOT_FOUND) before the job has read it. Of one that is
  // over also if no scene.json lies in the scene's folder or in the output's, and no tile is named by column and row.
  // Errors of LoadScene.
  absl::StatusOr<std::shared_ptr<const SceneSight>> SightOf(const std::string& name, const JobCells& job);

  // {"holeCount", "holes", "planned"} as JSON text: as planned, then as in the report, with its "date" and
  // "warnings". kNotFound (REPORT_NOT_FOUND) before there is a plan; errors of reading. Looks at the output's files, as
  // the next two do: a mount may hang.
  absl::StatusOr<std::shared_ptr<const std::string>> HolesOf(const std::string& name, const JobCells& job);

  // The review queue (page_review.h) as JSON text. kNotFound (REPORT_NOT_FOUND) before there is a report; errors of
  // reading.
  absl::StatusOr<std::shared_ptr<const std::string>> ReviewOf(const std::string& name, const JobCells& job);

  struct File {
    std::string name;  // the last part of its path
    std::string bytes;
    TileFrame frame = {};  // of the tile, as SceneTile::frame
  };
  // The mesh of a cell, in the scene or in the output. With `path` the file that lies there, seen from its tile's
  // folder. kNotFound (TILE_NOT_FOUND) if the cell has no tile, and for any other file.
  absl::StatusOr<File> FileOf(const std::string& name, const JobCells& job, CellId cell, bool after,
                              const std::string& path);

 private:
  LoadedValues<SceneSight> sights_{16};
  LoadedValues<std::string> holes_{16};
  LoadedValues<std::string> reviews_{16};
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_WEB_JOB_FILES_H_
