// Whether a result can be that of assembling a tile.
#ifndef TILEMEND_COORDINATOR_JOBS_ASSEMBLE_CHECK_H_
#define TILEMEND_COORDINATOR_JOBS_ASSEMBLE_CHECK_H_

#include <string>

#include "absl/status/status.h"
#include "coordinator/jobs/checked_files.h"

namespace tilemend {

// kDataLoss (Wrong, of wrong_result.h) unless the bytes of an AssembleOutput tell the files of the AssembleInput, each
// as closely as SceneResultCheck says. Of a tile that is a tree all files are looked at like the tile. kUnavailable if
// this machine cannot tell.
absl::Status CheckAssembleResult(const std::string& input_bytes, const v1::AssembleOutput& output,
                                 TileReading& reading);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_ASSEMBLE_CHECK_H_
