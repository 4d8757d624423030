// Files that a tile names: material files and images.
#ifndef TILEMEND_WORKER_MATERIALS_SCENE_FILE_H_
#define TILEMEND_WORKER_MATERIALS_SCENE_FILE_H_

#include <string>
#include <string_view>

#include "absl/status/statusor.h"

namespace tilemend {

// Where a name leads to.
struct SceneFile {
  std::string path;     // relative to the scene's folder, without "." and ".."; empty: nowhere, see problem
  std::string problem;  // "is not there", "lies outside the scene's folder", ...
};

// Looks for the regular file `name` in `folder` of the scene `root` (all with "/", `folder` relative to `root`). Names
// may have been written elsewhere: backslashes part folders, and quotes around the name are none of it. If no file has
// the name as it is written, one that differs only in capital letters is taken (the first in byte order). A name that
// is absolute, or leads out of `root` by "..", leads nowhere; so does one that the output needs for itself
// (IsOutputName). A link is followed as long as it leads to something in the scene, or below `folder` where that is
// itself reached by a link. Errors of an object store that cannot say whether the file is there.
absl::StatusOr<SceneFile> FindSceneFile(const std::string& root, const std::string& folder, std::string_view name);

// The folder of a path relative to the scene: "" for a file directly in it.
std::string FolderOf(const std::string& path);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_MATERIALS_SCENE_FILE_H_
