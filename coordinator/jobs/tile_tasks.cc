#include "coordinator/jobs/tile_tasks.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "common/records/ground_raster.h"
#include "common/rpc/clear_payloads.h"
#include "common/rpc/ground_payloads.h"
#include "common/rpc/stage_payloads.h"
#include "common/store/digest.h"
#include "common/store/fingerprint.h"
#include "common/util/status_macros.h"
#include "coordinator/jobs/scratch_messages.h"
#include "coordinator/jobs/stage_output.h"
#include "coordinator/report/tile_checks.h"

namespace tilemend {
namespace {

// Of the inputs of ground tasks, put aside once.
absl::StatusOr<InputPart> PartOf(v1::GroundRasterBlob raster, const std::shared_ptr<ScratchFile>& scratch) {
  v1::GroundInput part;
  *part.add_rasters() = std::move(raster);
  const std::string bytes = part.SerializeAsString();
  TILEMEND_ASSIGN_OR_RETURN(const ScratchFile::Place place, scratch->Put(bytes));
  return InputPart{Sha256Hex(bytes), [scratch, place] { return scratch->Get(place); }};
}

constexpr size_t kMostStampBytes = 128;

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

TileTasks::TileTasks(const JobSpec& spec, SceneWaves& waves, std::shared_ptr<ScratchFile> scratch, SceneFiles& files,
                     std::vector<LevelCounts>& levels)
    : spec_(spec), waves_(waves), scratch_(std::move(scratch)), files_(files), levels_(levels) {}

absl::StatusOr<NewTask> TileTasks::TaskOf(const MeasureWork& work) const {
  v1::MeasureInput input;
  TILEMEND_ASSIGN_OR_RETURN(*input.mutable_tile(), Ref(*work.tile));
  input.mutable_tile()->clear_clear();
  for (const PlanePolygon& polygon : work.polygons) *input.add_areas() = ToProto(ClearArea{polygon});
  return NewTask{work.tile->cell, Stage::kMeasure, input.SerializeAsString()};
}

absl::StatusOr<NewTask> TileTasks::TaskOf(const SurveyWork& work) const {
  v1::SurveyInput input;
  TILEMEND_ASSIGN_OR_RETURN(*input.mutable_tile(), Ref(*work.tile));
  input.set_look(!spec_.dry_run());
  const Box2 reach = ReachOfCell(waves_.scene(), work.tile->cell);
  for (const double x : {reach.lo.x(), reach.lo.y(), reach.hi.x(), reach.hi.y()}) input.add_reach(x);
  const Point2& cell = waves_.scene().grid.cell_size;
  input.set_raster_square(RasterSquareFor(cell.x(), cell.y()));
  return NewTask{work.tile->cell, Stage::kSurvey, input.SerializeAsString()};
}

absl::StatusOr<NewTask> TileTasks::TaskOf(const GroundWork& work) const {
  v1::GroundInput input;
  const auto record = work.record.Outline();
  for (const BoundaryVertex& v : record->vertices) {
    for (int k = 0; k < 3; ++k) input.add_position(v.position[k]);
  }
  std::vector<InputPart> parts;
  for (const CellId cell : work.around) input.add_parts(parts.emplace_back(lowest_.at(cell)).digest);
  return NewTask{work.cell, Stage::kGround, input.SerializeAsString(), {}, std::move(parts)};
}

// Empty if there was no survey.
absl::StatusOr<v1::SurveyOutput> TileTasks::SurveyedOf(CellId cell) const {
  const auto place = surveyed_.find(cell);
  if (place == surveyed_.end()) return v1::SurveyOutput();
  return ReadMessage<v1::SurveyOutput>(*scratch_, place->second);
}

absl::StatusOr<v1::TileRef> TileTasks::Ref(const SceneTile& tile) const {
  v1::TileRef ref = TileRefOf(tile, waves_.scene().root);
  for (const ClearArea& area : waves_.survey().clearing().Areas(tile.cell)) *ref.add_clear() = ToProto(area);
  TILEMEND_ASSIGN_OR_RETURN(v1::SurveyOutput surveyed, SurveyedOf(tile.cell));
  ref.set_digest(std::move(*surveyed.mutable_digest()));
  return ref;
}

absl::StatusOr<std::string> TileTasks::StampOf(CellId cell) const {
  TILEMEND_ASSIGN_OR_RETURN(const v1::SurveyOutput surveyed, SurveyedOf(cell));
  return surveyed.stamp();
}

std::string TileTasks::FileDigestOf(const std::string& path) const {
  const auto digest = file_digests_.find(path);
  return digest == file_digests_.end() ? "" : digest->second;
}

absl::Status TileTasks::Take(CellId cell, const v1::MeasureOutput& output) {
  TileLevels levels{cell, {}};
  for (const v1::HeightTally& tally : output.tallies()) {
    TILEMEND_ASSIGN_OR_RETURN(levels.tallies.emplace_back(), FromProto(tally));
  }
  measured_[cell] = output.digest();
  return waves_.Take(std::move(levels));
}

absl::Status TileTasks::Take(CellId cell, absl::StatusOr<SurveyedTile> tile) {
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
  TILEMEND_ASSIGN_OR_RETURN(surveyed_[cell], WriteMessage(*scratch_, surveyed));
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

absl::Status TileTasks::Take(CellId cell, const v1::GroundOutput& output) {
  TILEMEND_ASSIGN_OR_RETURN(RimGround rim, FromProto(output, output.ground_size()));
  return waves_.Take(CellGround{cell, std::move(rim)});
}

}  // namespace tilemend
