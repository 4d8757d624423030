#include "coordinator/jobs/result_checks.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <variant>

#include "absl/strings/str_cat.h"
#include "common/codec/mesh_file.h"
#include "common/mesh/height_tallies.h"
#include "common/records/patch_heights.h"
#include "common/rpc/clear_payloads.h"
#include "common/rpc/ground_payloads.h"
#include "common/rpc/look_payloads.h"
#include "common/rpc/stage_payloads.h"
#include "common/rpc/surface_payloads.h"
#include "common/store/digest.h"
#include "common/store/tile_stamp.h"
#include "common/util/status_macros.h"
#include "common/util/tile_files.h"
#include "coordinator/check/ground_check.h"
#include "coordinator/check/mesh_outline.h"
#include "coordinator/check/patch_check.h"
#include "coordinator/check/sample_check.h"
#include "coordinator/check/survey_check.h"
#include "coordinator/check/tile_check.h"
#include "coordinator/jobs/assemble_check.h"
#include "coordinator/jobs/checked_files.h"
#include "coordinator/jobs/smooth_check.h"
#include "coordinator/jobs/wrong_result.h"
#include "coordinator/report/tile_checks.h"
#include "tilemend/v1/stages.pb.h"
#include "tilemend/v1/verify.pb.h"

namespace tilemend {
namespace {

// As the worker was told, without the band, which no check needs.
template <typename Input>
absl::StatusOr<CellHoles> HolesOf(Input& input) {
  input.mutable_holes()->clear_band();
  return FromProto(input.holes());
}

template <typename T>
std::span<const T> Column(const google::protobuf::RepeatedField<T>& values) {
  return {values.data(), static_cast<size_t>(values.size())};
}

bool HasOutline(const TriMesh& mesh, uint64_t key) {
  return OutlineSumOf(mesh, key).sum != 0 && !OutlineOf(mesh).empty();
}

// The mesh of a tile with these bytes, without what is taken out of it; `cleared`, if given, gets how much each area
// took.
absl::StatusOr<MeshFile> MeshOf(const v1::TileRef& tile, const std::string& bytes, std::vector<int64_t>* cleared) {
  if (tile.clear().empty()) {
    TILEMEND_ASSIGN_OR_RETURN(const MeshFormat format, MeshFormatOf(tile.path()));
    return ParseMesh(format, bytes, TilePath(tile));
  }
  TILEMEND_ASSIGN_OR_RETURN(ClearedTile without, ClearTile(tile, bytes));
  if (cleared != nullptr) *cleared = std::move(without.triangles);
  return std::move(without.file);
}

// Without reading each tile: what only few tiles are said to be, and a look at the tile settles.
absl::Status CheckUnusual(const v1::SurveyInput& input, const SurveyRecord& record, TileReading& reading) {
  const bool closed = record.triangle_count > 0 && record.edges.empty();
  const auto& reach = input.reach();
  const bool outside =
      record.vertex_count > 0 && reach.size() == 4 &&
      (record.lo.x() < reach[0] || record.lo.y() < reach[1] || record.hi.x() > reach[2] || record.hi.y() > reach[3]);
  if (!closed && !outside) return absl::OkStatus();
  const std::string path = TilePath(input.tile());
  TILEMEND_ASSIGN_OR_RETURN(const int64_t size, TileSize(input.tile()));
  const MemoryBudget::Share share(reading.memory, kMemoryOfFile * size);
  const auto bytes = BytesOf(input.tile());
  if (!bytes.ok()) return bytes.status();
  const auto file = MeshOf(input.tile(), *bytes, nullptr);
  if (!file.ok()) return absl::UnavailableError(file.status().message());
  if (closed && HasOutline(file->mesh, reading.key)) return Wrong("no boundary, where the tile has one");
  if (!outside) return absl::OkStatus();
  Eigen::AlignedBox3d bounds;
  for (const Point3& p : file->mesh.points) bounds.extend(p);
  return bounds.min() == record.lo && bounds.max() == record.hi ? absl::OkStatus()
                                                                : Wrong("bounds that are not the tile's");
}

// That a survey need not be made again.
absl::Status CheckSameSurvey(const v1::SurveyInput& input, const v1::SurveyOutput& output, TileCheck how) {
  absl::Status changed = Changed(TilePath(input.tile()));
  if (!input.has_known() || output.digest() != input.known().digest()) return Wrong("another tile than is known");
  TILEMEND_ASSIGN_OR_RETURN(const int64_t bytes, TileSize(input.tile()));
  if (bytes != input.known().bytes()) return changed;
  if (how != TileCheck::kContent) return absl::OkStatus();
  return CheckTileFile(input.tile(), output.digest(), changed);
}

absl::Status OtherTile(const std::string& path, const v1::SurveyOutput& output) {
  if (TileHasStamp(path, output.stamp())) return Wrong("a digest that is not the tile's");
  return Changed(path);
}

// That the digest and the record are the tile's, unless that has changed since it was read.
absl::Status CheckSurveyedTile(const v1::SurveyInput& input, const v1::SurveyOutput& output, const SurveyRecord& record,
                               TileReading& reading) {
  const std::string path = TilePath(input.tile());
  TILEMEND_ASSIGN_OR_RETURN(const int64_t size, TileSize(input.tile()));
  const MemoryBudget::Share share(reading.memory, kMemoryOfFile * size);
  const auto bytes = BytesOf(input.tile());
  if (!bytes.ok()) return bytes.status();
  if (!HasFileDigest(*bytes, output.digest())) return OtherTile(path, output);
  std::vector<int64_t> cleared;
  const auto file = MeshOf(input.tile(), *bytes, &cleared);
  if (!file.ok()) return Wrong("a survey of a tile that cannot be read");
  if (!std::ranges::equal(cleared, output.cleared())) return Wrong("other triangles taken out than are asked for");
  return AsWrong(CheckAgainstTile(record, file->mesh, file->number_type == NumberType::kFloat32, reading.key));
}

absl::Status CheckOutput(const std::string& input_bytes, const v1::MeasureOutput& output, TileReading& reading) {
  TILEMEND_ASSIGN_OR_RETURN(const auto input, ParseResult<v1::MeasureInput>(input_bytes));
  if (!IsFileDigest(output.digest())) return Wrong("a digest that is none");
  if (output.tallies_size() != input.areas_size()) return Wrong("heights of other polygons");
  for (const v1::HeightTally& tally : output.tallies()) TILEMEND_RETURN_IF_ERROR(AsWrong(FromProto(tally).status()));
  if (reading.how != TileCheck::kContent) return absl::OkStatus();
  const std::string path = TilePath(input.tile());
  TILEMEND_ASSIGN_OR_RETURN(const int64_t size, TileSize(input.tile()));
  const MemoryBudget::Share share(reading.memory, kMemoryOfFile * size);
  const auto bytes = BytesOf(input.tile());
  if (!bytes.ok()) return bytes.status();
  if (!HasFileDigest(*bytes, output.digest())) return Changed(path);
  const auto file = MeshOf(input.tile(), *bytes, nullptr);
  if (!file.ok()) return Wrong("heights of a tile that cannot be read");
  std::vector<PlanePolygon> polygons;
  for (const v1::ClearArea& proto : input.areas()) {
    TILEMEND_ASSIGN_OR_RETURN(ClearArea area, FromProto(proto));
    polygons.push_back(std::move(area.polygon));
  }
  const std::vector<HeightTally> tallies = TallyHeightsIn(file->mesh, polygons);
  for (int i = 0; i < output.tallies_size(); ++i) {
    TILEMEND_ASSIGN_OR_RETURN(const HeightTally told, FromProto(output.tallies(i)));
    if (tallies[i].area_of_bin != told.area_of_bin) return Wrong("heights of another tile");
  }
  return absl::OkStatus();
}

// Of a tree: the files that it says to have are those of its folder. No other tile may name such files: they would be
// written over that tile.
absl::Status CheckFilesOfTree(const v1::SurveyInput& input, const v1::TileFiles& files) {
  const std::string& tile = input.tile().path();
  for (const auto* list : {&files.libraries(), &files.images()}) {
    for (const std::string& path : *list) {
      if (!IsTreeFile(path)) continue;
      const bool is_own = IsTileTree(tile) && IsFileOfTree(tile, path);
      if (!is_own || path == tile) return Wrong("a file of another tile");
    }
  }
  return absl::OkStatus();
}

// The record of a survey that was made anew.
absl::StatusOr<SurveyRecord> CheckedRecord(const v1::SurveyInput& input, const v1::SurveyOutput& output,
                                           TileReading& reading) {
  if (output.cleared_size() != input.tile().clear_size()) return Wrong("counts of other areas");
  if (output.witness().digest() != output.digest()) return Wrong("a witness of another tile");
  TILEMEND_RETURN_IF_ERROR(AsWrong(FromProto(output.files()).status()));
  TILEMEND_RETURN_IF_ERROR(CheckFilesOfTree(input, output.files()));
  auto record = FromProto(output);
  if (!record.ok()) return AsWrong(record.status());
  TILEMEND_ASSIGN_OR_RETURN(const int64_t bytes, TileSize(input.tile()));
  TILEMEND_RETURN_IF_ERROR(AsWrong(CheckSurvey(*record, MostOf(input.tile().path(), bytes))));
  TILEMEND_RETURN_IF_ERROR(reading.how == TileCheck::kContent ? CheckSurveyedTile(input, output, *record, reading)
                                                              : CheckUnusual(input, *record, reading));
  return record;
}

// The record of a survey; none: it says that the tile is as it was.
absl::StatusOr<std::optional<SurveyRecord>> CheckSurveyResult(const std::string& input_bytes,
                                                              const v1::SurveyOutput& output, TileReading& reading) {
  TILEMEND_ASSIGN_OR_RETURN(const auto input, ParseResult<v1::SurveyInput>(input_bytes));
  if (!IsFileDigest(output.digest())) return Wrong("a digest that is none");
  if (!output.unchanged()) return CheckedRecord(input, output, reading);
  TILEMEND_RETURN_IF_ERROR(CheckSameSurvey(input, output, reading.how));
  return std::nullopt;
}

absl::Status CheckOutput(const std::string& input_bytes, const v1::SurveyOutput& output, TileReading& reading) {
  return CheckSurveyResult(input_bytes, output, reading).status();
}

absl::Status CheckOutput(const std::string& input_bytes, const v1::GroundOutput& output, TileReading&) {
  TILEMEND_ASSIGN_OR_RETURN(const auto input, ParseResult<v1::GroundInput>(input_bytes));
  std::vector<Point3> vertices;
  for (int i = 0; i + 2 < input.position_size(); i += 3) {
    vertices.emplace_back(input.position(i), input.position(i + 1), input.position(i + 2));
  }
  const absl::StatusOr<RimGround> rim = FromProto(output, input.position_size() / 3);
  return AsWrong(rim.ok() ? CheckRimGround(*rim, vertices) : rim.status());
}

absl::Status CheckOutput(const std::string& input_bytes, const v1::SampleClusterOutput& output, TileReading&) {
  TILEMEND_ASSIGN_OR_RETURN(auto input, ParseResult<v1::SampleClusterInput>(input_bytes));
  TILEMEND_ASSIGN_OR_RETURN(const CellHoles asked, HolesOf(input));
  if (output.cluster() != input.cluster()) return Wrong("another cluster");
  if (output.has_hold_out()) TILEMEND_RETURN_IF_ERROR(AsWrong(FromProto(output.hold_out()).status()));
  return AsWrong(CheckClusterSamples(asked, output.hold_out().has_walls(),
                                     {Column(output.seam_vertex()), Column(output.height()), Column(output.laplacian()),
                                      Column(output.slope_x()), Column(output.slope_y())}));
}

absl::Status CheckOutput(const std::string& input_bytes, const v1::SampleLayerOutput& output, TileReading&) {
  TILEMEND_ASSIGN_OR_RETURN(auto input, ParseResult<v1::SampleLayerInput>(input_bytes));
  TILEMEND_ASSIGN_OR_RETURN(const CellHoles asked, HolesOf(input));
  return AsWrong(CheckLayerSamples(asked, Column(output.seam_vertex()), Column(output.height())));
}

absl::Status CheckOutput(const std::string& input_bytes, const v1::FillOutput& output, TileReading&) {
  TILEMEND_ASSIGN_OR_RETURN(auto input, ParseResult<v1::FillInput>(input_bytes));
  TILEMEND_ASSIGN_OR_RETURN(CellHoles asked, HolesOf(input));
  if (output.has_samples() != input.has_sampled()) return Wrong("samples without their holes, or none");
  if (input.has_sampled()) {
    TILEMEND_ASSIGN_OR_RETURN(const CellHoles sampled, FromProto(input.sampled()));
    const auto seam_vertex = Column(output.samples().seam_vertex());
    const auto height = Column(output.samples().height());
    TILEMEND_RETURN_IF_ERROR(AsWrong(CheckLayerSamples(sampled, seam_vertex, height)));
    TakeSampledHeights(seam_vertex, height, asked);
  }
  const auto patches = FromProto(output, asked.vertices.size());
  if (!patches.ok()) return AsWrong(patches.status());
  const auto quality = FromProto(output.quality());
  if (!quality.ok()) return AsWrong(quality.status());
  return AsWrong(CheckPatches(asked, *patches, *quality));
}

absl::Status CheckOutput(const std::string& input_bytes, const v1::SmoothSeamOutput& output, TileReading&) {
  return CheckSmoothResult(input_bytes, output);
}

absl::Status CheckOutput(const std::string& input_bytes, const v1::AssembleOutput& output, TileReading& reading) {
  return CheckAssembleResult(input_bytes, output, reading);
}

absl::Status CheckVerification(const std::string& input_bytes, const std::string& output_bytes) {
  TILEMEND_ASSIGN_OR_RETURN(const auto input, ParseResult<v1::VerifyInput>(input_bytes));
  v1::VerifyOutput output;
  if (!output.ParseFromString(output_bytes)) return Wrong("not the message of its stage");
  if (output.files_size() != input.paths_size() + input.tiles_size() + input.tasks_size()) {
    return Wrong("not a digest for each file and task");
  }
  for (const v1::VerifiedFile& file : output.files()) {
    if (!IsFileDigest(file.digest())) return Wrong("a digest that is none");
  }
  return absl::OkStatus();
}

absl::Status CheckStage(const std::string& input, const StageOutput& output, TileReading& reading) {
  return std::visit([&](const auto& message) { return CheckOutput(input, message, reading); }, output);
}

}  // namespace

absl::Status CheckKnownOutput(const std::string& input, const StageOutput& output) {
  TileReading reading(TileCheck::kSize);
  return CheckStage(input, output, reading);
}

std::vector<std::string> AttemptsOfScene(Stage stage, const std::string& output) {
  std::vector<std::string> names;
  v1::AssembleOutput assembled;
  if (stage != Stage::kAssemble || !assembled.ParseFromString(output) || assembled.unchanged()) return names;
  for (const v1::WrittenFile& file : assembled.files()) names.push_back(file.attempt());
  return names;
}

ResultCheck SceneResultCheck(TileCheck tiles, std::shared_ptr<DecodedSurveys> surveys) {
  return [reading = std::make_shared<TileReading>(tiles), surveys = std::move(surveys)](
             Stage stage, const std::string& input, const std::string& bytes) -> absl::Status {
    if (stage == Stage::kVerify) return CheckVerification(input, bytes);
    const auto output = ParseStageOutput(stage, bytes);
    if (absl::IsInvalidArgument(output.status())) return AsWrong(output.status());
    if (!output.ok()) return output.status();
    const auto* surveyed = std::get_if<v1::SurveyOutput>(&*output);
    if (surveyed == nullptr || surveys == nullptr) return CheckStage(input, *output, *reading);
    TILEMEND_ASSIGN_OR_RETURN(auto record, CheckSurveyResult(input, *surveyed, *reading));
    if (record) surveys->Put(bytes, *std::move(record));
    return absl::OkStatus();
  };
}

}  // namespace tilemend
