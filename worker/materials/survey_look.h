// Survey of a tile together with what it looks like.
#ifndef TILEMEND_WORKER_MATERIALS_SURVEY_LOOK_H_
#define TILEMEND_WORKER_MATERIALS_SURVEY_LOOK_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/codec/mesh_file.h"
#include "common/records/survey_record.h"
#include "common/records/tile_files.h"
#include "worker/survey/survey.h"

namespace tilemend {

struct LookSurvey {
  SurveyRecord record;  // with colours, where the tile has any
  TileFiles files;
  FileWitness witness;                    // of the files and the colours
  std::vector<int32_t> level_nodes = {};  // as MeshFile::level_nodes
};

// A mesh, and what is wrong with the files that its tile names.
struct MeshWithWarnings {
  MeshFile file;
  std::vector<std::string> warnings;
};

// What of a survey is wanted, and of which tiles.
struct SurveyChoice {
  PieceAreas areas = PieceAreas::kYes;
  double raster_square = 0;  // metres, of the ground raster; 0: none
  NoFaces no_faces = NoFaces::kRefuse;
};

// Surveys `bytes`, the tile `path` of the scene `root`: SurveyTile, the files that it names, and its colours along the
// boundary: texels or diffuse colours of an OBJ, and the colours of its vertices where no material is in force; colours
// of vertices of a PLY, else of its faces. A tile that names no files and has no colours costs what ParseMesh and
// SurveyTile do, and of an OBJ 12 bytes a triangle. With a `raster_square` above 0 the record has the lowest surface
// (worker/ground/lowest_surface.h). Errors of ParseMesh; files and images that cannot be had are warnings.
absl::StatusOr<LookSurvey> SurveyWithLook(const std::string& root, const std::string& path, std::string_view bytes,
                                          MeshFormat format, const SurveyChoice& choice = {});

// ParseMesh with the warnings on files of SurveyWithLook, but for those that need an image decoded.
absl::StatusOr<MeshWithWarnings> ParseWithWarnings(const std::string& root, const std::string& path,
                                                   std::string_view bytes, MeshFormat format,
                                                   NoFaces no_faces = NoFaces::kRefuse);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_MATERIALS_SURVEY_LOOK_H_
