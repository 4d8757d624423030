#include "coordinator/waves/scene_waves.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

#include "absl/strings/str_cat.h"
#include "coordinator/plan/colour/hole_colours.h"
#include "coordinator/plan/make_cell_holes.h"
#include "coordinator/plan/water/water.h"
#include "coordinator/waves/ground_reach.h"
#include "coordinator/waves/holes_of_cells.h"
#include "coordinator/waves/sample_checks.h"
#include "coordinator/waves/tiles_in_reach.h"

namespace tilemend {
namespace {

// A cell that a mesh lies in the middle of.
Grid GridAround(const SurveySummary& record) {
  const Point2 extent = (record.hi - record.lo).head<2>().cwiseMax(Point2(1, 1));
  return {record.lo.head<2>() - extent, 3 * extent};
}

}  // namespace

SceneWaves::SceneWaves(Scene scene, WaveOptions options, StepEnded step_ended)
    : scene_(std::move(scene)),
      options_(std::move(options)),
      clearing_(options_.plan.water.areas, scene_.grid),
      step_ended_(std::move(step_ended)) {
  for (const SceneTile& tile : scene_.tiles) {
    tiles_[tile.cell] = &tile;
    if (!tile.path.empty() && !clearing_.Polygons(tile.cell).empty()) ready_.push_back({Wave::kMeasure, tile.cell});
  }
  phase_ = "measure levels";
  if (ready_.empty()) QueueSurveys();
}

void SceneWaves::QueueSurveys() {
  wave_ = Wave::kSurvey;
  phase_ = "survey";
  for (const SceneTile& tile : scene_.tiles) {
    if (!tile.path.empty()) ready_.push_back({Wave::kSurvey, tile.cell});
  }
}

std::optional<SceneWork> SceneWaves::Next() {
  while (IsOver() && !done()) Advance();
  const std::optional<Item> item = NextItem();
  return item ? std::optional(WorkOf(*item)) : std::nullopt;
}

std::optional<SceneWaves::Item> SceneWaves::NextItem() {
  if (const auto cell = writes_.Next(awaited_, !ready_.empty())) return Item{Wave::kAssemble, *cell};
  if (ready_.empty()) return std::nullopt;
  const Item item = ready_.front();
  ready_.pop_front();
  ++awaited_;
  return item;
}

SceneWork SceneWaves::WorkOf(const Item& item) const {
  switch (item.wave) {
    case Wave::kMeasure:
      return MeasureWork{tiles_.at(item.cell), clearing_.Polygons(item.cell)};
    case Wave::kGround:
      return GroundWork{item.cell, records().at(item.cell), CellsInGroundReach(records(), scene_.grid, item.cell)};
    case Wave::kCluster:
      return ClusterWork{item.cluster,
                         MakeCellHoles(plan_, input_, heights_, holes_of_clusters_.at(item.cluster), true)};
    case Wave::kLayer:
      return LayerWork{MakeCellHoles(plan_, input_, heights_, HolesOfLayer(holes_of_.at(item.cell)), false)};
    case Wave::kFill:
      return FillWorkOf(item.cell);
    case Wave::kSmooth:
      return SmoothWorkOf(item.cluster);
    case Wave::kAssemble:
      return AssembleWorkOf(item.cell);
    default:
      return SurveyWork{tiles_.at(item.cell), clearing_.Areas(item.cell)};
  }
}

FillWork SceneWaves::FillWorkOf(CellId cell) const {
  FillWork work{MakeFillHoles(plan_, input_, heights_, holes_of_.at(cell)), {}};
  for (const CellId tile : TilesInReach(work.holes, plan_, input_)) work.surface.push_back(tiles_.at(tile));
  if (!is_wang()) return work;
  const std::vector<int32_t> of_layer = HolesOfLayer(holes_of_.at(cell));
  if (!of_layer.empty()) work.sampled = MakeCellHoles(plan_, input_, heights_, of_layer, false);
  return work;
}

SmoothWork SceneWaves::SmoothWorkOf(int32_t seam) const {
  const auto& [cells, pair] = seams_[seam];
  SmoothWork work{{cells.first, cells.second}, pair.number};
  for (int side = 0; side < 2; ++side) {
    work.sides[side] = MakeFillHoles(plan_, input_, heights_, holes_of_.at(work.cells[side]), false);
    const std::set<int32_t>& holes = side == 0 ? pair.holes_of_first : pair.holes_of_second;
    work.holes[side].assign(holes.begin(), holes.end());
  }
  for (const int32_t v : pair.vertices) {
    work.vertices.push_back(v);
    work.heights.push_back(heights_.height.at(v));
  }
  return work;
}

AssembleWork SceneWaves::AssembleWorkOf(CellId cell) const {
  AssembleWork work{tiles_.at(cell), float32_};
  if (const auto record = records().find(cell); record != records().end() && record->second != nullptr) {
    work.tile_vertices = record->second->vertex_count;
  }
  if (const auto holes = holes_of_.find(cell); holes != holes_of_.end()) {
    for (const int32_t h : holes->second) work.colours.of_holes[h] = plan_.colours[h];
    if (is_wang()) work.holes = MakeFillHoles(plan_, input_, heights_, holes->second, false);
  }
  work.colours.on_vertices =
      std::any_of(plan_.colours.begin(), plan_.colours.end(), [](const FillColour& c) { return c.known; });
  return work;
}

void SceneWaves::TakeSurvey(CellId cell, StoredRecord record) {
  input_.cells[cell] = std::move(record);
  --awaited_;
}

void SceneWaves::TakeSurvey(CellId cell, SurveyRecord record) {
  TakeSurvey(cell, StoredRecord(std::make_shared<const SurveyRecord>(std::move(record))));
}

absl::Status SceneWaves::TakeGround(CellId cell, RimGround rim) {
  const auto record = records().find(cell);
  if (record == records().end() || record->second == nullptr) {
    return absl::InvalidArgumentError(absl::StrCat("cell ", ToString(cell), " has no tile"));
  }
  const size_t vertices = record->second.Outline()->vertices.size();
  if (rim.on_object.size() != vertices || rim.ground.size() != vertices) {
    return absl::InvalidArgumentError("not a value for each boundary vertex");
  }
  input_.rim_ground[cell] = std::move(rim);
  --awaited_;
  return absl::OkStatus();
}

void SceneWaves::LeaveGround(CellId cell, const std::string& reason) {
  outcome_.unsmoothed.push_back({cell, absl::StrCat("all at its rims is taken for ground: ", reason)});
  --awaited_;
}

absl::Status SceneWaves::TakeCluster(const ClusterSamples& result) {
  const auto holes = holes_of_clusters_.find(result.cluster);
  if (holes == holes_of_clusters_.end()) {
    return absl::InvalidArgumentError(absl::StrCat("cluster ", result.cluster, " is not in the plan"));
  }
  if (absl::Status status = CheckSamples(plan_, result.samples); !status.ok()) return status;
  if (result.hold_out) {
    outcome_.of_clusters[result.cluster] = *result.hold_out;
    heights_.tension[result.cluster] = result.hold_out->tension;
  }
  SettleCluster(plan_, result.cluster, result.samples, heights_);
  for (const CellId cell : awaiting_.at(result.cluster)) {
    if (--clusters_left_[cell] == 0 && CanBeFilled(cell)) QueueFill(cell);
  }
  --awaited_;
  return absl::OkStatus();
}

absl::Status SceneWaves::TakeLayer(const std::vector<SeamSample>& samples) {
  if (absl::Status status = CheckSamples(plan_, samples); !status.ok()) return status;
  samples_.insert(samples_.end(), samples.begin(), samples.end());
  --awaited_;
  return absl::OkStatus();
}

absl::Status SceneWaves::TakeFill(CellId cell, const CellPatches& result) {
  if (absl::Status status = CheckSamples(plan_, result.samples); !status.ok()) return status;
  samples_.insert(samples_.end(), result.samples.begin(), result.samples.end());
  --awaited_;
  if (!IsChosen(cell)) return absl::OkStatus();
  for (const PatchExtent& patch : result.patches) {
    if (patch.hole < 0 || patch.hole >= std::ssize(plan_.holes)) {
      return absl::InvalidArgumentError(absl::StrCat("hole ", patch.hole, " is not in the plan"));
    }
    if (patch.hold_out) outcome_.of_holes[patch.hole] = *patch.hold_out;
    if (patch.failure.empty()) {
      filled_.insert(cell);
      if (outcome_.failures.contains(patch.hole)) continue;
      PatchSize& size = outcome_.sizes[patch.hole];
      size.new_vertices += patch.new_vertices;
      size.triangles += patch.triangles;
      outcome_.triangles += patch.triangles;
      size.way = patch.way;
      size.loop_cuts += patch.loop_cuts;
      size.creases += patch.creases;
      size.rim_is_crossed |= patch.rim_is_crossed;
    } else {
      outcome_.failures[patch.hole] = patch.failure;
      if (const auto size = outcome_.sizes.extract(patch.hole)) outcome_.triangles -= size.mapped().triangles;
    }
  }
  outcome_.quality.Merge(result.quality);
  if (WritesEarly()) QueueAssemble(cell);
  return absl::OkStatus();
}

absl::Status SceneWaves::TakeSmooth(const SmoothedSeam& result) {
  if (result.heights.size() != result.vertices.size()) return absl::InvalidArgumentError("columns of unequal length");
  for (size_t i = 0; i < result.vertices.size(); ++i) {
    absl::Status status = CheckSample(plan_, result.vertices[i], result.heights[i]);
    if (!status.ok()) return status;
    smoothed_[result.vertices[i]][{result.cells[0], result.cells[1]}] = result.heights[i];
  }
  --awaited_;
  return absl::OkStatus();
}

void SceneWaves::TakePatches(CellId cell, std::span<const RimVertex> vertices, std::span<const HolePatch> patches) {
  fill_gaps_.Take(cell, vertices, patches);
  outcome_.fill_gaps = fill_gaps_.gaps();
}

void SceneWaves::LeaveHoles(CellId cell, const std::string& reason) {
  if (FailHoles(cell, reason)) {
    std::erase_if(ready_, [&](const Item& item) { return item.cell == cell && item.wave != Wave::kCluster; });
  }
  --awaited_;
}

bool SceneWaves::FailHoles(CellId cell, const std::string& reason) {
  const auto holes = holes_of_.find(cell);
  if (holes == holes_of_.end()) return false;
  for (const int32_t h : holes->second) {
    outcome_.failures[h] = reason;
    if (const auto size = outcome_.sizes.extract(h)) outcome_.triangles -= size.mapped().triangles;
  }
  holes_of_.erase(holes);
  return true;
}

void SceneWaves::LeaveSeam(CellId cell, const std::string& reason) {
  outcome_.unsmoothed.push_back({cell, absl::StrCat("a seam is not smoothed: ", reason)});
  --awaited_;
}

void SceneWaves::LeaveTile(CellId cell, const std::string& reason) {
  FailHoles(cell, reason);
  outcome_.unwritten.push_back({cell, absl::StrCat("the tile is not written: ", reason)});
  writes_.Settle();
}

void SceneWaves::Advance() {
  switch (wave_) {
    case Wave::kMeasure:
      EndStep("measure");
      clearing_.Settle(options_.plan.water.areas);
      return QueueSurveys();
    case Wave::kSurvey:
      EndStep("survey");
      return QueueGround();
    case Wave::kGround:
      EndStep("ground");
      return MakeThePlan();
    case Wave::kCluster:
      wave_ = Wave::kLayer;
      return QueueLayer(1);
    case Wave::kLayer:
      // Wang smooths when all layers are filled; what thin-plate samples so is smoothed at once.
      SettleLayer(plan_, samples_, is_wang() ? 0 : options_.wang.seam_smoothing, heights_);
      samples_.clear();
      if (layer_ < plan_.layers) return QueueLayer(layer_ + 1);
      EndStep(is_wang() ? "layers" : "sample");
      wave_ = Wave::kFill;
      return QueueFills();
    case Wave::kFill:
      EndStep("fill");
      wave_ = Wave::kSmooth;
      return QueueSeams();
    case Wave::kSmooth:
      SettleSmoothed(plan_, smoothed_, heights_);
      if (is_wang()) EndStep("smooth");
      wave_ = Wave::kAssemble;
      return QueueAssembles();
    case Wave::kAssemble:
      EndStep("assemble");
      wave_ = Wave::kDone;
      return;
    case Wave::kDone:
      return;
  }
}

void SceneWaves::QueueGround() {
  wave_ = Wave::kGround;
  if (!options_.find_objects || options_.single_mesh || !IsGroundTold(scene_.grid)) return;
  phase_ = "ground";
  for (const auto& [cell, record] : records()) {
    if (record != nullptr && record->triangle_count > 0) ready_.push_back({Wave::kGround, cell});
  }
}

void SceneWaves::MakeThePlan() {
  phase_ = "plan";
  outcome_.cleared = clearing_.Cleared();
  clearing_.TellCells(options_.plan.water.areas);
  input_.has_grid = !options_.single_mesh;
  input_.area_known = scene_.area_known;
  input_.area = scene_.area;
  input_.grid = options_.single_mesh ? GridAround(*records().begin()->second) : scene_.grid;
  for (const auto& [cell, tile] : tiles_) {
    input_.cells.try_emplace(cell);
    if (tile->added) input_.added.insert(cell);
  }
  plan_ = MakePlan(input_, options_.plan);
  SettleWater(plan_, heights_);
  plan_.colours = ColourHoles(plan_, input_, options_.plan.water_colour);
  float32_ = std::any_of(records().begin(), records().end(),
                         [](const auto& r) { return r.second != nullptr && r.second->float32; });
  outcome_.chosen = options_.chosen;
  holes_of_ = HolesToFill(plan_, options_.chosen);
  std::vector<BorderAudit> borders;
  std::copy_if(plan_.borders.begin(), plan_.borders.end(), std::back_inserter(borders), [&](const BorderAudit& border) {
    return holes_of_.contains(border.a) && holes_of_.contains(border.b) && IsChosen(border.a) && IsChosen(border.b);
  });
  fill_gaps_ = FillGaps(input_.grid, borders);
  EndStep("plan");
  wave_ = options_.plan_only ? Wave::kDone : Wave::kCluster;
  if (!options_.plan_only && options_.surface == Surface::kThinPlate) QueueClusters();
}

// Cells that need no surface of a cluster are filled meanwhile.
void SceneWaves::QueueClusters() {
  phase_ = "sample clusters and fill";
  for (const auto& [cell, holes] : holes_of_) {
    for (const int32_t h : holes) {
      const PlannedHole& hole = plan_.holes[h];
      if (hole.cluster >= 0 && hole.water < 0) holes_of_clusters_[hole.cluster].push_back(h);
    }
  }
  std::vector<std::pair<size_t, Item>> clusters;
  for (const auto& [cluster, holes] : holes_of_clusters_) {
    clusters.push_back({SegmentsOf(plan_, holes), {Wave::kCluster, plan_.holes[holes.front()].cell, cluster}});
  }
  awaiting_ = CellsThatAwait(plan_, holes_of_, holes_of_clusters_);
  for (const auto& [cluster, cells] : awaiting_) {
    for (const CellId cell : cells) ++clusters_left_[cell];
  }
  std::stable_sort(clusters.begin(), clusters.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  for (const auto& [size, item] : clusters) ready_.push_back(item);
  for (const auto& [cell, holes] : holes_of_) {
    if (!clusters_left_.contains(cell) && CanBeFilled(cell)) QueueFill(cell);
  }
  if (!WritesEarly()) return;
  for (const SceneTile& tile : scene_.tiles) {
    if (!holes_of_.contains(tile.cell)) QueueAssemble(tile.cell);
  }
}

void SceneWaves::QueueLayer(int32_t layer) {
  layer_ = layer;
  phase_ = absl::StrCat(is_wang() ? "fill layer " : "sample layer ", layer, " of ", plan_.layers);
  for (const auto& [cell, holes] : holes_of_) QueueCellOfLayer(cell, holes);
}

void SceneWaves::QueueCellOfLayer(CellId cell, const std::vector<int32_t>& holes) {
  if (is_wang() && LastLayerOf(plan_, holes) == layer_ && IsFilled(cell)) return QueueFill(cell);
  if (!HolesOfLayer(holes).empty()) ready_.push_back({Wave::kLayer, cell});
}

bool SceneWaves::IsFilled(CellId cell) const {
  return IsChosen(cell) || (is_wang() && options_.wang.seam_smoothing > 0 && TouchesChosen(cell, cell));
}

bool SceneWaves::TouchesChosen(CellId a, CellId b) const {
  const CellId low{std::max(a.col, b.col) - 1, std::max(a.row, b.row) - 1};
  const CellId high{std::min(a.col, b.col) + 1, std::min(a.row, b.row) + 1};
  for (int32_t col = low.col; col <= high.col; ++col) {
    for (int32_t row = low.row; row <= high.row; ++row) {
      if (IsChosen({col, row})) return true;
    }
  }
  return false;
}

void SceneWaves::QueueSeams() {
  if (!is_wang() || options_.wang.seam_smoothing == 0) return;
  phase_ = "smooth seams";
  std::vector<int32_t> filled;
  for (const auto& [cell, holes] : holes_of_) {
    std::copy_if(holes.begin(), holes.end(), std::back_inserter(filled),
                 [&](int32_t h) { return !outcome_.failures.contains(h); });
  }
  for (auto& [cells, seam] : FindPairSeams(plan_, filled, heights_)) {
    if (!TouchesChosen(cells.first, cells.second)) continue;
    ready_.push_back({Wave::kSmooth, cells.first, static_cast<int32_t>(seams_.size())});
    seams_.emplace_back(cells, std::move(seam));
  }
}

void SceneWaves::QueueFills() {
  phase_ = "fill";
  for (const auto& [cell, holes] : holes_of_) {
    if (!filling_.contains(cell)) QueueFill(cell);
  }
}

void SceneWaves::QueueFill(CellId cell) {
  filling_.insert(cell);
  if (!IsFilled(cell)) return;
  ready_.push_back({Wave::kFill, cell});
}

void SceneWaves::QueueAssembles() {
  phase_ = "assemble";
  for (const SceneTile& tile : scene_.tiles) QueueAssemble(tile.cell);
}

void SceneWaves::QueueAssemble(CellId cell) {
  if (IsChosen(cell) && (!tile(cell).path.empty() || filled_.contains(cell))) {
    writes_.Queue(cell);
  } else if (writes_.Dismiss(cell)) {
    ++cells_done_;  // nothing to write
  }
}

// Of this layer: the holes with seam vertices that are not settled.
std::vector<int32_t> SceneWaves::HolesOfLayer(const std::vector<int32_t>& holes) const {
  std::vector<int32_t> of_layer;
  std::copy_if(holes.begin(), holes.end(), std::back_inserter(of_layer),
               [&](int32_t h) { return plan_.holes[h].layer == layer_ && NeedsHeights(h); });
  return of_layer;
}

bool SceneWaves::NeedsHeights(int32_t hole) const {
  const auto& segments = plan_.holes[hole].segments;
  return std::any_of(segments.begin(), segments.end(), [&](const RimSegment& s) {
    return plan_.vertices[s.from].index < 0 && !heights_.height.contains(s.from);
  });
}

// Whether all seam vertices of the cell are settled.
bool SceneWaves::CanBeFilled(CellId cell) const {
  const auto holes = holes_of_.find(cell);
  return holes != holes_of_.end() &&
         std::none_of(holes->second.begin(), holes->second.end(), [&](int32_t h) { return NeedsHeights(h); });
}

}  // namespace tilemend
