#include "coordinator/jobs/scene_tasks.h"

#include <algorithm>
#include <variant>

#include "absl/strings/str_cat.h"
#include "common/codec/mesh_file.h"
#include "common/options/job_options.h"
#include "common/options/method_options.h"
#include "common/records/ground_raster.h"
#include "common/records/patch_heights.h"
#include "common/rpc/clear_payloads.h"
#include "common/rpc/ground_payloads.h"
#include "common/rpc/level_payloads.h"
#include "common/rpc/look_payloads.h"
#include "common/rpc/smoothed_payloads.h"
#include "common/rpc/stage_payloads.h"
#include "common/store/digest.h"
#include "common/store/fingerprint.h"
#include "common/util/status_macros.h"
#include "common/util/tile_files.h"
#include "coordinator/jobs/scene_options.h"
#include "coordinator/report/tile_checks.h"
#include "coordinator/waves/local_numbers.h"

namespace tilemend {
namespace {

template <typename Message>
absl::StatusOr<Message> TakeUp(const ScratchFile& scratch, const ScratchFile::Place& place) {
  TILEMEND_ASSIGN_OR_RETURN(const std::string bytes, scratch.Get(place));
  Message message;
  if (!message.ParseFromString(bytes)) return absl::InvalidArgumentError("not the expected message");
  return message;
}

absl::StatusOr<ScratchFile::Place> PutAside(ScratchFile& scratch, const google::protobuf::MessageLite& message) {
  return scratch.Put(message.SerializeAsString());
}

// What a result says, as TakeOutput takes it.
template <typename Output>
Output Decoded(Output& output, std::optional<SurveyRecord>&) {
  return std::move(output);
}
absl::StatusOr<SurveyedTile> Decoded(v1::SurveyOutput& output, std::optional<SurveyRecord>& record) {
  return SurveyedTileOf(std::move(output), std::move(record));
}

// Of the inputs of ground tasks, put aside once.
absl::StatusOr<InputPart> PartOf(v1::GroundRasterBlob raster, const std::shared_ptr<ScratchFile>& scratch) {
  v1::GroundInput part;
  *part.add_rasters() = std::move(raster);
  const std::string bytes = part.SerializeAsString();
  TILEMEND_ASSIGN_OR_RETURN(const ScratchFile::Place place, scratch->Put(bytes));
  return InputPart{Sha256Hex(bytes), [scratch, place] { return scratch->Get(place); }};
}

constexpr size_t kMostStampBytes = 128;

int64_t NewPointsOf(const v1::FillOutput& output) {
  int64_t count = 0;
  for (const v1::PatchExtent& extent : output.patches()) count += extent.new_points();
  return count;
}

bool HasMaterials(const SceneTile& tile) {
  if (tile.path.empty()) return false;  // a new tile is a PLY
  const auto format = MeshFormatOf(tile.path);
  return format.ok() && *format == MeshFormat::kObj;
}

bool GetsTexture(const v1::JobSpec& spec, const SceneTile& tile, const SceneFiles& files) {
  const bool has_images = IsTileTree(tile.path) || (HasMaterials(tile) && files.HasImages(tile.cell));
  return spec.texture() == "synthesize" && has_images;
}

// By the holes' numbers in the work, of which `holes` has the scene's. Groups name materials; where there are none they
// would tell a task from the same task of another plan.
FillColours LocalColours(const AssembleWork& work, const std::vector<int32_t>& holes) {
  FillColours local{{}, work.colours.on_vertices};
  for (const auto& [hole, colour] : work.colours.of_holes) {
    FillColour& own = local.of_holes[LocalNumber(holes, hole)];
    own = colour;
    if (!HasMaterials(*work.tile)) own.group = 0;
  }
  return local;
}

// Returns the files that are new: the image, unless it lies in the tile's own files.
std::set<std::string> SetTexture(const SceneFiles& files, const v1::JobSpec& spec, v1::AssembleInput& input) {
  input.set_texture(files.NewFileFor(input.output(), "jpg"));
  input.set_water_colour(spec.water_colour());
  if (IsTileTree(input.tile().path())) return {};
  return {input.texture()};
}

void SetWantedColours(const v1::JobSpec& spec, const SceneTile& tile, FillColours colours, v1::AssembleInput& input) {
  input.set_without_colours(spec.texture() == "none" && !IsTileTree(tile.path));
  if (input.without_colours()) colours.on_vertices = false;
  SetColours(colours, input);
}

void SetTile(const AssembleWork& work, v1::AssembleInput& input) {
  input.set_output(OutputPath(*work.tile));
  input.set_float32(work.float32);
  input.set_tile_vertices(work.tile_vertices);
}

void SetDelivery(const Grid& grid, const std::string& format, CellId cell, v1::AssembleInput& input) {
  input.set_output_format(format);
  input.set_x_middle(grid.corner.x() + (cell.col + 0.5) * grid.cell_size.x());
  input.set_y_middle(grid.corner.y() + (cell.row + 0.5) * grid.cell_size.y());
}

// The tiles that the texture of a cell's fill is made from: its own and those around it.
template <typename Ref>
absl::Status AddTilesAround(const Scene& scene, CellId cell, const Ref& ref, v1::AssembleInput& input) {
  // They are sorted by it.
  const auto place = [](const SceneTile& tile) { return std::pair(tile.cell.row, tile.cell.col); };
  for (int32_t row = cell.row - 1; row <= cell.row + 1; ++row) {
    auto other = std::ranges::lower_bound(scene.tiles, std::pair(row, cell.col - 1), std::less<>(), place);
    for (; other != scene.tiles.end() && place(*other) <= std::pair(row, cell.col + 1); ++other) {
      const int32_t col = other->cell.col;
      v1::TextureCell& around = *input.add_around();
      TILEMEND_ASSIGN_OR_RETURN(*around.mutable_tile(), ref(*other));
      around.set_x_min(scene.grid.corner.x() + col * scene.grid.cell_size.x());
      around.set_y_min(scene.grid.corner.y() + row * scene.grid.cell_size.y());
      around.set_x_max(scene.grid.corner.x() + (col + 1) * scene.grid.cell_size.x());
      around.set_y_max(scene.grid.corner.y() + (row + 1) * scene.grid.cell_size.y());
    }
  }
  return absl::OkStatus();
}

// The file with the materials of the tile's fill: the tile's own, `library`, or a new one if that is empty.
void SetLibrary(const std::string& path, const std::string& library, const SceneFiles& files,
                const std::map<std::string, std::string>& digests, v1::AssembleInput& input) {
  input.set_new_library(library.empty());
  if (const auto digest = digests.find(library); digest != digests.end()) input.set_library_digest(digest->second);
  input.set_library(library.empty() ? files.NewFileFor(path, "mtl") : library);
}

}  // namespace

v1::TileRef TileRefOf(const SceneTile& tile, const std::string& root) {
  v1::TileRef ref;
  ref.set_root(root);
  ref.set_path(tile.path);
  ref.set_col(tile.cell.col);
  ref.set_row(tile.cell.row);
  ref.mutable_frame()->Add(tile.frame.begin(), tile.frame.end());
  return ref;
}

SceneTasks::SceneTasks(const JobSpec& spec, SceneWaves& waves, OutputFolder* output,
                       std::shared_ptr<ScratchFile> scratch)
    : spec_(spec),
      shape_(OptionsForWorkers(spec)),
      waves_(waves),
      output_(output),
      scratch_(std::move(scratch)),
      files_(output != nullptr ? FolderInScene(output->path(), waves.scene().root) : "") {}

absl::StatusOr<NewTask> SceneTasks::TaskOf(SceneWork& work) {
  return std::visit([this](auto& w) { return Encode(w); }, work);
}

int32_t SceneTasks::NumberOf(const NewTask& task) const {
  if (task.stage == Stage::kSmoothSeam) return last_seam_;
  return task.stage == Stage::kSampleCluster ? clusters_of_.at(task.cell) - 1 : 0;
}

absl::Status SceneTasks::AddHelp(NewTask& task) const {
  const auto place = surveyed_.find(task.cell);
  if (task.stage != Stage::kAssemble || place == surveyed_.end()) return absl::OkStatus();
  TILEMEND_ASSIGN_OR_RETURN(const auto surveyed, TakeUp<v1::SurveyOutput>(*scratch_, place->second));
  if (surveyed.stamp().empty()) return absl::OkStatus();
  v1::AssembleInput help;
  help.set_stamp(surveyed.stamp());
  help.set_link_tile(spec_.link());
  task.SetInput(task.input + help.SerializeAsString());  // as one message: its other fields stay as they are
  return absl::OkStatus();
}

absl::StatusOr<NewTask> SceneTasks::Encode(const MeasureWork& work) const {
  v1::MeasureInput input;
  TILEMEND_ASSIGN_OR_RETURN(*input.mutable_tile(), Ref(*work.tile));
  input.mutable_tile()->clear_clear();
  for (const PlanePolygon& polygon : work.polygons) *input.add_areas() = ToProto(ClearArea{polygon});
  return NewTask{work.tile->cell, Stage::kMeasure, input.SerializeAsString()};
}

absl::StatusOr<NewTask> SceneTasks::Encode(const SurveyWork& work) const {
  v1::SurveyInput input;
  TILEMEND_ASSIGN_OR_RETURN(*input.mutable_tile(), Ref(*work.tile));
  input.set_look(!spec_.dry_run());
  const Box2 reach = ReachOfCell(waves_.scene(), work.tile->cell);
  for (const double x : {reach.lo.x(), reach.lo.y(), reach.hi.x(), reach.hi.y()}) input.add_reach(x);
  const Point2& cell = waves_.scene().grid.cell_size;
  input.set_raster_square(RasterSquareFor(cell.x(), cell.y()));
  return NewTask{work.tile->cell, Stage::kSurvey, input.SerializeAsString()};
}

absl::StatusOr<NewTask> SceneTasks::Encode(const GroundWork& work) const {
  v1::GroundInput input;
  const auto record = work.record.Outline();
  for (const BoundaryVertex& v : record->vertices) {
    for (int k = 0; k < 3; ++k) input.add_position(v.position[k]);
  }
  std::vector<InputPart> parts;
  for (const CellId cell : work.around) input.add_parts(parts.emplace_back(lowest_.at(cell)).digest);
  return NewTask{work.cell, Stage::kGround, input.SerializeAsString(), {}, std::move(parts)};
}

absl::StatusOr<NewTask> SceneTasks::Encode(ClusterWork& work) {
  v1::SampleClusterInput input;
  const int32_t number = clusters_of_[work.holes.cell]++;
  clusters_[{work.holes.cell, number}] = {work.cluster, Localise(work.holes).seam_vertices};
  input.set_cluster(number);
  *input.mutable_holes() = ToProto(work.holes);
  *input.mutable_options() = shape_;
  return NewTask{work.holes.cell, Stage::kSampleCluster, input.SerializeAsString()};
}

absl::StatusOr<NewTask> SceneTasks::Encode(LayerWork& work) {
  v1::SampleLayerInput input;
  layers_[work.holes.cell] = Localise(work.holes).seam_vertices;
  *input.mutable_holes() = ToProto(work.holes);
  return NewTask{work.holes.cell, Stage::kSampleLayer, input.SerializeAsString()};
}

absl::StatusOr<NewTask> SceneTasks::Encode(FillWork& work) {
  v1::FillInput input;
  CellHoles none;
  LocalNumbers numbers = Localise(work.holes, work.sampled ? *work.sampled : none);
  holes_[work.holes.cell] = std::move(numbers.holes);
  if (work.sampled) {
    sampled_[work.holes.cell] = std::move(numbers.seam_vertices);
    *input.mutable_sampled() = ToProto(*work.sampled);
  }
  *input.mutable_holes() = ToProto(work.holes);
  *input.mutable_options() = shape_;
  for (const SceneTile* tile : work.surface) {
    TILEMEND_ASSIGN_OR_RETURN(*input.add_surface(), Ref(*tile));
  }
  TILEMEND_ASSIGN_OR_RETURN(rims_[work.holes.cell], PutAside(*scratch_, ToProto(work.holes.vertices)));
  return NewTask{work.holes.cell, Stage::kFill, input.SerializeAsString()};
}

absl::StatusOr<NewTask> SceneTasks::Encode(SmoothWork& work) {
  const CellId cell = work.sides[0].cell;
  v1::SmoothSeamInput input;
  last_seam_ = work.number;
  input.set_number(work.number);
  seams_[{cell, work.number}] = {work.cells, work.vertices, {}};
  const LocalNumbers numbers = Localise(work.sides[0], work.sides[1]);
  TILEMEND_ASSIGN_OR_RETURN(*input.mutable_a(), SideOf(work.sides[0], work.holes[0]));
  TILEMEND_ASSIGN_OR_RETURN(*input.mutable_b(), SideOf(work.sides[1], work.holes[1]));
  for (size_t i = 0; i < work.vertices.size(); ++i) {
    input.add_seam_vertex(LocalNumber(numbers.seam_vertices, work.vertices[i]));
    input.add_height(work.heights[i]);
  }
  const WangOptions wang = WangOptionsOf(spec_);
  input.set_smoothing(wang.seam_smoothing);
  input.set_buffer(wang.seam_buffer);
  input.set_lattice_step(work.sides[0].lattice_step);
  return NewTask{cell, Stage::kSmoothSeam, input.SerializeAsString()};
}

absl::StatusOr<v1::SeamSide> SceneTasks::SideOf(const CellHoles& cell, const std::vector<int32_t>& holes) {
  v1::SeamSide side;
  *side.mutable_vertices() = ToProto(cell.vertices);
  TILEMEND_ASSIGN_OR_RETURN(*side.mutable_patches(), TakeUp<v1::FillOutput>(*scratch_, patches_.at(cell.cell)));
  for (const int32_t hole : holes) side.add_holes(LocalNumber(holes_.at(cell.cell), hole));
  return side;
}

absl::StatusOr<NewTask> SceneTasks::Encode(AssembleWork& work) {
  const CellId cell = work.tile->cell;
  v1::AssembleInput input;
  TILEMEND_ASSIGN_OR_RETURN(*input.mutable_tile(), Ref(*work.tile));
  SetTile(work, input);
  input.set_attempts(output_->attempts().path());
  if (patches_.contains(cell)) TILEMEND_RETURN_IF_ERROR(SetPatches(work, input));
  SetFiles(*work.tile, input);
  if (input.has_patches() && GetsTexture(spec_, *work.tile, files_)) {
    output_->Adopt(SetTexture(files_, spec_, input));
    TILEMEND_RETURN_IF_ERROR(AddTilesAround(
        waves_.scene(), cell, [&](const SceneTile& other) { return Ref(other); }, input));
  }
  rims_.erase(cell);
  holes_.erase(cell);
  return NewTask{cell, Stage::kAssemble, input.SerializeAsString()};
}

absl::Status SceneTasks::SetPatches(AssembleWork& work, v1::AssembleInput& input) {
  const CellId cell = work.tile->cell;
  TILEMEND_ASSIGN_OR_RETURN(*input.mutable_patches(),
                            TakeUp<v1::FillOutput>(*scratch_, patches_.extract(cell).mapped()));
  SetWantedColours(spec_, *work.tile, LocalColours(work, holes_.at(cell)), input);
  if (!work.holes) {
    TILEMEND_ASSIGN_OR_RETURN(*input.mutable_vertices(), TakeUp<v1::RimVertices>(*scratch_, rims_.at(cell)));
    return absl::OkStatus();
  }
  Localise(*work.holes);
  *input.mutable_vertices() = ToProto(work.holes->vertices);
  input.set_lattice_step(work.holes->lattice_step);
  std::vector<std::vector<SmoothedPoint>> moves;
  for (const auto& [seam, place] : smoothed_[cell]) {
    TILEMEND_ASSIGN_OR_RETURN(v1::SmoothedPoints points, TakeUp<v1::SmoothedPoints>(*scratch_, place));
    TILEMEND_ASSIGN_OR_RETURN(moves.emplace_back(), FromProto(points, NewPointsOf(input.patches())));
    *input.add_smoothed() = std::move(points);
  }
  smoothed_.erase(cell);
  return ComparePatches(cell, input.vertices(), input.patches(), moves);
}

void SceneTasks::SetFiles(const SceneTile& tile, v1::AssembleInput& input) {
  if (HasMaterials(tile)) {
    SetLibrary(OutputPath(tile), files_.LibraryOf(tile.cell), files_, file_digests_, input);
    output_->Adopt({input.library()});
  }
  input.set_output_root(spec_.out());
  if (!tile.delivered.empty()) return SetDelivery(waves_.scene().grid, spec_.output_format(), tile.cell, input);
  const std::vector<std::string> carried = files_.CarriedBy(tile.cell);
  output_->Adopt({carried.begin(), carried.end()});
  input.mutable_carried()->Add(carried.begin(), carried.end());
  for (const std::string& path : carried) input.add_carried_digests(file_digests_[path]);
  input.set_link_images(spec_.textures() == "link");
}

absl::StatusOr<v1::TileRef> SceneTasks::Ref(const SceneTile& tile) const {
  v1::TileRef ref = TileRefOf(tile, waves_.scene().root);
  for (const ClearArea& area : waves_.survey().clearing().Areas(tile.cell)) *ref.add_clear() = ToProto(area);
  if (const auto place = surveyed_.find(tile.cell); place != surveyed_.end()) {
    TILEMEND_ASSIGN_OR_RETURN(auto surveyed, TakeUp<v1::SurveyOutput>(*scratch_, place->second));
    ref.set_digest(std::move(*surveyed.mutable_digest()));
  }
  return ref;
}

absl::Status SceneTasks::Take(StageResult result) {
  const absl::Status status =
      std::visit([&](auto& output) { return TakeOutput(result.cell, Decoded(output, result.record)); }, result.output);
  if (status.ok() || result.stage == Stage::kSurvey || result.stage == Stage::kAssemble) return status;
  return UnreadableResult(result.cell, status);
}

absl::Status SceneTasks::TakeOutput(CellId cell, absl::StatusOr<SurveyedTile> tile) {
  if (!tile.ok()) return UnreadableResult(cell, tile.status());
  TILEMEND_RETURN_IF_ERROR(CheckInsideCell(tile->record, waves_.scene(), waves_.survey().tile(cell)));
  if (const auto measured = measured_.extract(cell); measured && measured.mapped() != tile->digest) {
    return ChangedInJob(absl::StrCat(waves_.scene().root, "/", waves_.survey().tile(cell).path));
  }
  if (spec_.textures() != "off") files_.Take(cell, tile->files, waves_.options().IsChosen(cell));
  if (waves_.options().IsChosen(cell)) AddLevels(tile->levels, levels_);
  v1::SurveyOutput surveyed;
  surveyed.set_digest(std::move(tile->digest));
  if (tile->stamp.size() <= kMostStampBytes) surveyed.set_stamp(std::move(tile->stamp));
  TILEMEND_ASSIGN_OR_RETURN(surveyed_[cell], PutAside(*scratch_, surveyed));
  TILEMEND_ASSIGN_OR_RETURN(lowest_[cell], PartOf(std::move(tile->lowest), scratch_));
  for (const FileWitness::Read& read : tile->reads) {
    if (read.digest.empty()) continue;
    const std::string& known = file_digests_.try_emplace(read.path, read.digest).first->second;
    if (known != read.digest) return ChangedInJob(absl::StrCat(waves_.scene().root, "/", read.path));
  }
  TILEMEND_ASSIGN_OR_RETURN(StoredRecord stored, scratch_->Keep(tile->record));
  const absl::Status taken = waves_.Take(TileSurvey{cell, std::move(stored), std::move(tile->cleared)});
  return taken.ok() ? taken : UnreadableResult(cell, taken);
}

absl::Status SceneTasks::TakeOutput(CellId cell, const v1::MeasureOutput& output) {
  TileLevels levels{cell, {}};
  for (const v1::HeightTally& tally : output.tallies()) {
    TILEMEND_ASSIGN_OR_RETURN(levels.tallies.emplace_back(), FromProto(tally));
  }
  measured_[cell] = output.digest();
  return waves_.Take(std::move(levels));
}

absl::Status SceneTasks::TakeOutput(CellId cell, const v1::GroundOutput& output) {
  TILEMEND_ASSIGN_OR_RETURN(RimGround rim, FromProto(output, output.ground_size()));
  return waves_.Take(CellGround{cell, std::move(rim)});
}

absl::Status SceneTasks::TakeOutput(CellId cell, const v1::SampleLayerOutput& output) {
  TILEMEND_ASSIGN_OR_RETURN(auto samples, SamplesOf(output, cell, layers_[cell]));
  return waves_.Take(LayerSamples{std::move(samples)});
}

absl::Status SceneTasks::TakeOutput(CellId cell, const v1::SampleClusterOutput& output) {
  const auto asked = clusters_.extract({cell, output.cluster()});
  if (asked.empty()) return absl::InvalidArgumentError("a cluster that was not asked for");
  TILEMEND_ASSIGN_OR_RETURN(ClusterSamples samples, SamplesOf(output, asked.mapped()));
  return waves_.Take(std::move(samples));
}

absl::Status SceneTasks::TakeOutput(CellId cell, v1::FillOutput output) {
  TILEMEND_ASSIGN_OR_RETURN(CellPatches patches, PatchesOf(output, holes_[cell]));
  if (output.has_samples()) {
    TILEMEND_ASSIGN_OR_RETURN(patches.samples, SamplesOf(output.samples(), cell, sampled_[cell]));
    sampled_.erase(cell);
  }
  if (spec_.surface() != SurfaceName(Surface::kWang)) {
    TILEMEND_ASSIGN_OR_RETURN(const auto rims, TakeUp<v1::RimVertices>(*scratch_, rims_.at(cell)));
    TILEMEND_RETURN_IF_ERROR(ComparePatches(cell, rims, output, {}));
  }
  output.clear_quality();
  output.clear_samples();
  TILEMEND_ASSIGN_OR_RETURN(patches_[cell], PutAside(*scratch_, output));
  return waves_.Take(CellFill{cell, std::move(patches)});
}

absl::Status SceneTasks::TakeOutput(CellId cell, const v1::SmoothSeamOutput& output) {
  auto asked = seams_.extract({cell, output.number()});
  if (asked.empty()) return absl::InvalidArgumentError("a seam that was not asked for");
  SmoothedSeam& seam = asked.mapped();
  seam.heights.assign(output.height().begin(), output.height().end());
  for (const auto& [side, points] : {std::pair(seam.cells[0], &output.a()), std::pair(seam.cells[1], &output.b())}) {
    ScratchFile::Place& place = smoothed_[side][{seam.cells[0], seam.cells[1]}];
    TILEMEND_ASSIGN_OR_RETURN(place, PutAside(*scratch_, *points));
  }
  return waves_.Take(std::move(seam));
}

absl::Status SceneTasks::ComparePatches(CellId cell, const v1::RimVertices& rims, const v1::FillOutput& output,
                                        std::span<const std::vector<SmoothedPoint>> moves) {
  if (!waves_.fill_gaps().Wants(cell)) return absl::OkStatus();
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<RimVertex> vertices, FromProto(rims));
  TILEMEND_ASSIGN_OR_RETURN(std::vector<HolePatch> patches, FromProto(output, vertices.size()));
  MoveSmoothedPoints(moves, waves_.plan().lattice_step, patches);
  waves_.fill_gaps().Take(cell, vertices, patches);
  return absl::OkStatus();
}

absl::Status SceneTasks::TakeOutput(CellId cell, const v1::AssembleOutput& output) {
  for (const auto* of : {&output.warnings(), &output.fill_warnings()}) files_.Warn(cell, {of->begin(), of->end()});
  TILEMEND_ASSIGN_OR_RETURN(const auto levels, FromProto(output.levels()));
  AddLevels(levels, levels_);
  TILEMEND_RETURN_IF_ERROR(waves_.Take(TileWritten{}));
  std::vector<AttemptFile> files;
  for (const v1::WrittenFile& file : output.files()) {
    files.push_back({file.attempt(), file.path(), file.bytes(), file.digest()});
    if (!waves_.survey().tile(cell).delivered.empty()) output_->Adopt({file.path()});  // its name was checked
  }
  return output.unchanged() ? output_->Keep(files) : output_->Place(files);
}

}  // namespace tilemend
