// The files beside an assembled tile: materials of its filled faces, and what the tile itself names.
#ifndef TILEMEND_WORKER_MATERIALS_WRITE_MATERIALS_H_
#define TILEMEND_WORKER_MATERIALS_WRITE_MATERIALS_H_

#include <functional>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/codec/mtl.h"
#include "common/util/files.h"

namespace tilemend {

// A material file: that of `from` (empty: none) with `materials` after it. Errors of ReadFile; kAborted
// if `from` has not the FileDigest `digest` (empty: any).
absl::StatusOr<std::string> MaterialsAfter(const std::string& from, const std::vector<FillMaterial>& materials,
                                           const std::string& digest = "");

// Writes it to `to`. Errors of ReadFile and WriteFileAtomically.
absl::Status WriteMaterials(const std::string& from, const std::string& to, const std::vector<FillMaterial>& materials);

// Carries one file, `path` of the output, from its path in the scene.
using CarryOne = std::function<absl::Status(const std::string& from, const std::string& path, Carry how)>;

// Carries `files`, relative paths, from the folder `root`. Images are linked if `link_images`; material files are
// always copied, as they may be added to. Gives a warning for each file that could not be carried; kResourceExhausted
// and kUnavailable, if the disk is full or not there, are handed on.
absl::StatusOr<std::vector<std::string>> CarryFiles(const std::string& root, const std::vector<std::string>& files,
                                                    bool link_images, const CarryOne& carry);

// The same to the folder `output`.
absl::StatusOr<std::vector<std::string>> CarryFiles(const std::string& root, const std::string& output,
                                                    const std::vector<std::string>& files, bool link_images);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_MATERIALS_WRITE_MATERIALS_H_
