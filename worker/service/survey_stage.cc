#include "worker/service/survey_stage.h"

#include <cstdint>
#include <utility>
#include <vector>

#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "absl/time/clock.h"
#include "common/codec/mesh_file.h"
#include "common/codec/text.h"
#include "common/mesh/height_tallies.h"
#include "common/mesh/mesh_limits.h"
#include "common/rpc/clear_payloads.h"
#include "common/rpc/look_payloads.h"
#include "common/rpc/stage_payloads.h"
#include "common/store/digest.h"
#include "common/store/tile_stamp.h"
#include "common/util/status_macros.h"
#include "worker/ground/lowest_surface.h"
#include "worker/materials/file_witness.h"
#include "worker/materials/survey_look.h"
#include "worker/service/tile_reading.h"
#include "worker/survey/survey.h"

namespace tilemend {
namespace {

// What a scene can do about a tile that holds nothing.
absl::Status WithHint(const absl::Status& status) {
  if (!absl::EndsWith(status.message(), kNoVertices)) return status;
  return absl::Status(status.code(),
                      absl::StrCat(status.message(), "; a cell without surface has \"path\": null in scene.json"));
}

// The coordinator takes no larger mesh (common/mesh/mesh_limits.h).
absl::Status CheckBandSize(const TriMesh& band, const std::string& path) {
  const auto points = std::ssize(band.points), triangles = std::ssize(band.triangles);
  if (points <= kMaxResultPoints && triangles <= kMaxResultTriangles) return absl::OkStatus();
  return absl::InvalidArgumentError(absl::StrCat(path, ": the surface along its boundaries has ", points,
                                                 " vertices and ", triangles, " triangles, where a tile may have ",
                                                 kMaxResultPoints, " and ", kMaxResultTriangles,
                                                 "; cut it into smaller tiles"));
}

// The record of a tile with these bytes, and what it looks like if that is asked for.
absl::StatusOr<v1::SurveyOutput> SurveyOf(const v1::SurveyInput& input, const std::string& bytes, NoFaces no_faces) {
  const std::string path = PathOf(input.tile());
  TILEMEND_ASSIGN_OR_RETURN(const MeshFormat format, MeshFormatOf(path));
  if (!input.look()) {
    TILEMEND_ASSIGN_OR_RETURN(const MeshFile file, ParseMesh(format, bytes, path, no_faces));
    SurveyRecord record = SurveyTile(file.mesh, file.number_type == NumberType::kFloat32, PieceAreas::kNo);
    TILEMEND_RETURN_IF_ERROR(CheckBandSize(record.band, path));
    if (input.raster_square() > 0) record.lowest = LowestSurface(file.mesh, input.raster_square());
    v1::SurveyOutput output = ToProto(record);
    output.mutable_level_nodes()->Add(file.level_nodes.begin(), file.level_nodes.end());
    return output;
  }
  const SurveyChoice choice{PieceAreas::kNo, input.raster_square(), no_faces};
  TILEMEND_ASSIGN_OR_RETURN(const LookSurvey survey,
                            SurveyWithLook(input.tile().root(), input.tile().path(), bytes, format, choice));
  TILEMEND_RETURN_IF_ERROR(CheckBandSize(survey.record.band, path));
  v1::SurveyOutput output = ToProto(survey.record);
  *output.mutable_files() = ToProto(survey.files);
  SetWitness(survey.witness, *output.mutable_witness());
  output.mutable_level_nodes()->Add(survey.level_nodes.begin(), survey.level_nodes.end());
  return output;
}

absl::StatusOr<std::string> Survey(const v1::SurveyInput& input) {
  const std::string path = PathOf(input.tile());
  const std::string stamp = StampOfTile(path, absl::Now());
  TILEMEND_ASSIGN_OR_RETURN(const std::string bytes, ReadTile(input.tile()));
  const std::string digest = FileDigest(bytes);
  v1::SurveyOutput output;
  if (input.known().digest() == digest && Holds(input.tile().root(), WitnessOf(input.known()))) {
    output.set_digest(digest);
    output.set_unchanged(true);
    return output.SerializeAsString();
  }
  if (input.tile().clear().empty()) {
    TILEMEND_ASSIGN_OR_RETURN(output, SurveyOf(input, bytes, NoFaces::kRefuse));
  } else {
    TILEMEND_ASSIGN_OR_RETURN(ClearedTile cleared, ClearTile(input.tile(), bytes));
    cleared.file = {};  // its memory is needed
    TILEMEND_ASSIGN_OR_RETURN(output, SurveyOf(input, cleared.bytes, NoFaces::kAccept));
    output.mutable_cleared()->Add(cleared.triangles.begin(), cleared.triangles.end());
  }
  output.set_digest(digest);
  output.set_stamp(stamp);
  output.mutable_witness()->set_digest(digest);
  output.mutable_witness()->set_bytes(static_cast<int64_t>(bytes.size()));
  return output.SerializeAsString();
}

}  // namespace

absl::StatusOr<std::string> RunMeasure(const v1::MeasureInput& input, TaskMemory& memory) {
  const std::string path = PathOf(input.tile());
  const HeldMemory held(memory.tasks, SurveyMemory(path));
  TILEMEND_ASSIGN_OR_RETURN(const std::string bytes, ReadTile(input.tile()));
  TILEMEND_ASSIGN_OR_RETURN(const MeshFormat format, MeshFormatOf(path));
  absl::StatusOr<MeshFile> file = ParseMesh(format, bytes, path);
  if (!file.ok()) return WithHint(file.status());
  v1::MeasureOutput output;
  output.set_digest(FileDigest(bytes));
  std::vector<PlanePolygon> polygons;
  for (const v1::ClearArea& proto : input.areas()) {
    TILEMEND_ASSIGN_OR_RETURN(ClearArea area, FromProto(proto));
    polygons.push_back(std::move(area.polygon));
  }
  for (const HeightTally& tally : TallyHeightsIn(file->mesh, polygons)) *output.add_tallies() = ToProto(tally);
  return output.SerializeAsString();
}

absl::StatusOr<std::string> RunSurvey(const v1::SurveyInput& input, TaskMemory& memory) {
  const HeldMemory held(memory.tasks, SurveyMemory(PathOf(input.tile())));
  absl::StatusOr<std::string> output = Survey(input);
  return output.ok() ? output : WithHint(output.status());
}

}  // namespace tilemend
