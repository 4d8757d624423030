// The files that the tiles of a scene name, and which tile takes which of them to the output.
#ifndef TILEMEND_COORDINATOR_JOBS_SCENE_FILES_H_
#define TILEMEND_COORDINATOR_JOBS_SCENE_FILES_H_

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/string_view.h"
#include "common/grid/scene.h"
#include "common/records/tile_files.h"

namespace tilemend {

inline constexpr size_t kMostFileWarningBytes = 2048;  // of a warning on a file

// The path of the folder `out` from the scene's folder, if it lies inside; else empty.
std::string FolderInScene(const std::string& out, const std::string& root);

// Every file is carried once, by the first of the tiles that name it. A material file that only one tile names is that
// tile's own: it is where the materials of its filled faces are added. A tile without one gets a file for them.
//
// Paths are relative to the scene's folder and to the output's. Memory: the names of the files, each twice, and digests
// of warnings.
class SceneFiles {
 public:
  // `output`: the output's folder relative to the scene's, where it lies inside it; else empty. A file that would be
  // carried over another file of the scene is left out with a warning.
  explicit SceneFiles(std::string output) : output_(std::move(output)) {}

  // All tiles, in any order; then the rest. One that is not written carries nothing.
  void Take(CellId cell, const TileFiles& files, bool is_written = true);
  void Warn(CellId cell, const std::vector<std::string>& warnings);

  // The last of the tile's own material files; empty if it has none.
  std::string LibraryOf(CellId cell) const;
  // Whether the tile names images.
  bool HasImages(CellId cell) const { return with_images_.contains(cell); }
  // A name for the materials (ending "mtl") or the image ("jpg") of the filled faces of the tile that is written to
  // `path`. It is beside that tile, and no file of the scene has it, even in other letter cases.
  std::string NewFileFor(const std::string& path, absl::string_view ending) const;
  // What the tile carries, without its LibraryOf.
  std::vector<std::string> CarriedBy(CellId cell) const;
  // All that are carried.
  std::set<std::string> Carried() const;
  // Each text once, by the first cell that has it, cut to kMostFileWarningBytes. Those beyond the first kMostWarnings
  // are counted in the last line.
  std::vector<std::string> Warnings() const;

  static constexpr size_t kMostWarnings = 20;

 private:
  struct File {
    std::optional<CellId> first;  // that is written
    int64_t tiles = 0;            // that name it
  };
  bool HidesAnother(const std::string& path) const;

  const std::string output_;
  std::map<std::string, File> files_;
  std::set<std::string> spelt_small_;                 // their names without capital letters
  std::map<CellId, std::set<std::string>> of_cells_;  // what each is the first to name
  std::set<CellId> with_images_;
  std::map<CellId, std::vector<std::string>> libraries_;
  std::map<CellId, std::vector<std::string>> warnings_;  // the first kMostWarnings of all cells
  size_t kept_warnings_ = 0;
  std::map<std::string, CellId> first_cells_;  // by the digest of each warning, also of those that are not kept
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_JOBS_SCENE_FILES_H_
