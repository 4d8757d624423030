#include "common/grid/scene_place.h"

#include <filesystem>

#include "common/util/folders.h"
#include "common/util/object_store.h"
#include "common/util/real_path.h"

namespace tilemend {

std::string ScenePlaceOf(const std::string& path) {
  const std::filesystem::path place(path);
  // The tiles lie beside the name that was given, not beside the file that a link of that name leads to.
  if (place.filename() == "scene.json") return RealPath(place.has_parent_path() ? place.parent_path() : ".").string();
  const bool is_file = !IsObjectPath(path) && KindOf(path) == PathKind::kFile;
  return (is_file ? RealPlace(place) : RealPath(place)).string();
}

}  // namespace tilemend
