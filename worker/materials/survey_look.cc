#include "worker/materials/survey_look.h"

#include <iterator>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/codec/obj.h"
#include "common/codec/ply_colours.h"
#include "common/codec/tree/tile_tree.h"
#include "common/codec/tree_mesh.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"
#include "worker/ground/lowest_surface.h"
#include "worker/materials/rim_colours.h"
#include "worker/materials/tile_look.h"
#include "worker/materials/tree_look.h"
#include "worker/survey/rim_spots.h"

namespace tilemend {
namespace {

SurveyRecord SurveyOf(const MeshFile& file, const SurveyChoice& choice) {
  SurveyRecord record = SurveyTile(file.mesh, file.number_type == NumberType::kFloat32, choice.areas);
  if (choice.raster_square > 0) record.lowest = LowestSurface(file.mesh, choice.raster_square);
  return record;
}

absl::StatusOr<LookSurvey> SurveyObj(const std::string& root, const std::string& path, std::string_view bytes,
                                     const std::string& name, const SurveyChoice& choice) {
  TILEMEND_ASSIGN_OR_RETURN(ObjFile obj, ParseTexturedObj(bytes, name, choice.no_faces));
  LookSurvey survey{SurveyOf(obj.file, choice), {}, {}};
  TILEMEND_ASSIGN_OR_RETURN(TileLook look, ReadObjLook(root, path, obj.textures));
  std::vector<RimSpot> spots;
  if (!look.materials.empty() || !obj.textures.vertex_colours.empty()) spots = RimSpots(obj.file.mesh, survey.record);
  obj.file = {};  // images need room
  TILEMEND_ASSIGN_OR_RETURN(RimColours sampled, SampleRim(root, look, obj.textures, spots, survey.record.vertices));
  survey.record.colours = std::move(sampled.colours);
  survey.files = std::move(look.files);
  survey.witness = std::move(look.witness);
  for (FileWitness::Read& read : sampled.reads) survey.witness.reads.push_back(std::move(read));
  for (std::string& warning : sampled.warnings) survey.files.warnings.push_back(std::move(warning));
  return survey;
}

absl::StatusOr<LookSurvey> SurveyPly(const std::string& root, const std::string& path, std::string_view bytes,
                                     const std::string& name, const SurveyChoice& choice) {
  TILEMEND_ASSIGN_OR_RETURN(const MeshFile file, ParseMesh(MeshFormat::kPly, bytes, name));
  TILEMEND_ASSIGN_OR_RETURN(TileLook look, ReadPlyLook(root, path, bytes));
  LookSurvey survey{SurveyOf(file, choice), std::move(look.files), std::move(look.witness)};
  std::vector<int32_t> vertices;
  for (const BoundaryVertex& v : survey.record.vertices) vertices.push_back(v.index);
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<Rgb> colours, PlyVertexColours(bytes, vertices, name));
  survey.record.colours.assign(colours.begin(), colours.end());
  if (!colours.empty()) return survey;
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<Rgb> of_triangles, PlyFaceColours(bytes, name));
  if (of_triangles.empty()) return survey;
  survey.record.colours.resize(survey.record.vertices.size());
  for (const RimSpot& spot : RimSpots(file.mesh, survey.record)) {
    survey.record.colours[static_cast<size_t>(spot.vertex)] = of_triangles[static_cast<size_t>(spot.triangle)];
  }
  return survey;
}

std::string MissingText(const std::string& name, const std::vector<std::string>& missing) {
  const std::string first = absl::StrCat("\"", Printable(Shortened(missing.front(), 80)), "\"");
  const std::string what =
      missing.size() == 1
          ? absl::StrCat(": a file that this tile names is missing, ", first)
          : absl::StrCat(": ", missing.size(), " files that this tile names are missing, such as ", first);
  return absl::StrCat(name, what, ": the next coarser level is filled in its place, or a hole if there is none");
}

absl::StatusOr<LookSurvey> SurveyTree(const std::string& path, std::string_view pack, const std::string& name,
                                      const SurveyChoice& choice) {
  TILEMEND_ASSIGN_OR_RETURN(const TileTree tile, ReadTileTree(pack, name));
  TILEMEND_ASSIGN_OR_RETURN(const MeshFile file, FinestMesh(tile, std::ssize(pack), name, choice.no_faces));
  const TreeLevel finest = LevelOf(tile, tile.levels - 1);
  TileLook look = ReadTreeLook(path, tile);
  LookSurvey survey{SurveyOf(file, choice), std::move(look.files), std::move(look.witness), file.level_nodes};
  const std::vector<RimSpot> spots = RimSpots(file.mesh, survey.record);
  RimColours sampled = SampleTreeRim(tile, finest, spots, survey.record.vertices.size(), name);
  survey.record.colours = std::move(sampled.colours);
  for (std::string& warning : sampled.warnings) survey.files.warnings.push_back(std::move(warning));
  if (!tile.missing.empty()) survey.files.warnings.push_back(MissingText(name, tile.missing));
  return survey;
}

}  // namespace

absl::StatusOr<LookSurvey> SurveyWithLook(const std::string& root, const std::string& path, std::string_view bytes,
                                          MeshFormat format, const SurveyChoice& choice) {
  const std::string name = absl::StrCat(root, "/", path);
  if (format == MeshFormat::kPly) return SurveyPly(root, path, bytes, name, choice);
  if (format == MeshFormat::kTileTree) return SurveyTree(path, bytes, name, choice);
  if (format == MeshFormat::kObj) return SurveyObj(root, path, bytes, name, choice);
  TILEMEND_ASSIGN_OR_RETURN(const MeshFile file, ParseMesh(format, bytes, name, choice.no_faces));
  return LookSurvey{SurveyOf(file, choice), {}, {}};
}

absl::StatusOr<MeshWithWarnings> ParseWithWarnings(const std::string& root, const std::string& path,
                                                   std::string_view bytes, MeshFormat format, NoFaces no_faces) {
  const std::string name = absl::StrCat(root, "/", path);
  MeshWithWarnings result;
  if (format == MeshFormat::kTileTree) {
    TILEMEND_ASSIGN_OR_RETURN(const TileTree tile, ReadTileTree(bytes, name));
    TILEMEND_ASSIGN_OR_RETURN(result.file, FinestMesh(tile, std::ssize(bytes), name, no_faces));
    if (!tile.missing.empty()) result.warnings.push_back(MissingText(name, tile.missing));
  } else if (format == MeshFormat::kObj) {
    TILEMEND_ASSIGN_OR_RETURN(ObjFile obj, ParseTexturedObj(bytes, name, no_faces));
    result.file = std::move(obj.file);
    TILEMEND_ASSIGN_OR_RETURN(TileLook look, ReadObjLook(root, path, obj.textures));
    result.warnings = std::move(look.files.warnings);
  } else {
    TILEMEND_ASSIGN_OR_RETURN(result.file, ParseMesh(format, bytes, name, no_faces));
    if (format != MeshFormat::kPly) return result;
    TILEMEND_ASSIGN_OR_RETURN(TileLook look, ReadPlyLook(root, path, bytes));
    result.warnings = std::move(look.files.warnings);
  }
  return result;
}

}  // namespace tilemend
