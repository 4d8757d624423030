// The files beside an assembled tile: materials of its filled faces, and what the tile itself names.
#ifndef TILEMEND_WORKER_MATERIALS_WRITE_MATERIALS_H_
#define TILEMEND_WORKER_MATERIALS_WRITE_MATERIALS_H_

#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/codec/mtl.h"

namespace tilemend {

// Writes the material file `to`: that of `from` (empty: none) with `materials` after it. Errors of ReadFile and
// WriteFileAtomically.
absl::Status WriteMaterials(const std::string& from, const std::string& to, const std::vector<FillMaterial>& materials);

// Carries `files`, relative paths, from the folder `root` to the folder `output`. Images are linked if `link_images`;
// material files are always copied, as they may be added to. Gives a warning for each file that could not be carried;
// kResourceExhausted if the disk is full.
absl::StatusOr<std::vector<std::string>> CarryFiles(const std::string& root, const std::string& output,
                                                    const std::vector<std::string>& files, bool link_images);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_MATERIALS_WRITE_MATERIALS_H_
