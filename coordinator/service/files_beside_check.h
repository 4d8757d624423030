// Whether the files that a worker wrote beside a tile can be what was asked for.
#ifndef TILEMEND_COORDINATOR_SERVICE_FILES_BESIDE_CHECK_H_
#define TILEMEND_COORDINATOR_SERVICE_FILES_BESIDE_CHECK_H_

#include <cstdint>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "coordinator/service/result_checks.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {

// kUnavailable if it cannot be looked at.
absl::StatusOr<int64_t> SizeOfFile(const std::string& path);
// `otherwise` if the file has another digest; kUnavailable if it cannot be read.
absl::Status CheckFile(const std::string& path, const std::string& digest, const absl::Status& otherwise);
// What this machine says of a file that is not as it was surveyed.
absl::Status Changed(const std::string& path);

// Whether a hole of the cell is filled.
bool HasPatch(const v1::AssembleInput& input);
// Whether the worker made an image for the filled faces.
bool HasTexture(const v1::AssembleInput& input, const v1::AssembleOutput& output);

// The files beside the tile: each is expected, once; what is left out has a warning. The material file is compared with
// the one that is made here; of the image of filled faces only the digest is checked. Errors as of a ResultCheck.
absl::Status CheckBeside(const v1::AssembleInput& input, const v1::AssembleOutput& output, TileCheck how);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_SERVICE_FILES_BESIDE_CHECK_H_
