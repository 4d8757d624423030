// Whether the files that a worker wrote beside a tile can be what was asked for.
#ifndef TILEMEND_COORDINATOR_JOBS_FILES_BESIDE_CHECK_H_
#define TILEMEND_COORDINATOR_JOBS_FILES_BESIDE_CHECK_H_

#include <string>

#include "absl/status/status.h"
#include "coordinator/jobs/result_checks.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {

// Whether a hole of the cell is filled.
bool HasPatch(const v1::AssembleInput& input);
// Whether the tile is to be another than the original.
bool IsPatched(const v1::AssembleInput& input);
// Whether a file of the output belongs to a tile that is a tree of files.
bool IsOfTree(const v1::AssembleInput& input, const std::string& path);
// Whether the worker made an image for the filled faces.
bool HasTexture(const v1::AssembleInput& input, const v1::AssembleOutput& output);

// The files beside the tile: each is expected, once; what is left out has a warning. The material file is compared with
// the one that is made here; of the image of filled faces only the digest is checked. Errors as of a ResultCheck.
absl::Status CheckBeside(const v1::AssembleInput& input, const v1::AssembleOutput& output, TileCheck how);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_FILES_BESIDE_CHECK_H_
