#include "coordinator/jobs/scene_folders.h"

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "common/store/fingerprint.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

// Files by which one tells whether this is the scene: what describes it, and its first, middle and last tile.
std::set<std::string> WitnessesOf(const Scene& scene) {
  std::vector<std::string> tiles;
  for (const SceneTile& tile : scene.tiles) {
    if (!tile.path.empty()) tiles.push_back(tile.path);
  }
  std::set<std::string> files;
  const std::string folder = scene.root + "/";
  if (!scene.found_by_name) files.insert(folder + "scene.json");
  if (tiles.empty()) return files;
  for (const size_t i : {size_t{0}, tiles.size() / 2, tiles.size() - 1}) files.insert(folder + tiles[i]);
  return files;
}

}  // namespace

absl::StatusOr<JobFolders> FoldersOf(const Scene& scene, const AttemptFolder* attempts) {
  JobFolders folders;
  if (attempts != nullptr) {
    folders.attempts = attempts->path();
    TILEMEND_ASSIGN_OR_RETURN(std::string fingerprint, FingerprintOf(attempts->key_file()));
    folders.files.push_back({attempts->key_file(), std::move(fingerprint)});
  }
  for (const std::string& path : WitnessesOf(scene)) {
    if (auto fingerprint = FingerprintOf(path); fingerprint.ok()) {
      folders.files.push_back({path, *std::move(fingerprint)});
    }
  }
  return folders;
}

}  // namespace tilemend
