#include "coordinator/waves/scene_waves.h"

#include <algorithm>
#include <iterator>
#include <variant>

#include "absl/strings/str_cat.h"
#include "coordinator/waves/ground_reach.h"
#include "coordinator/waves/sample_checks.h"

namespace tilemend {
namespace {

SceneWork WorkOf(const WorkItem& item, int32_t layer, bool is_wang, const SceneData& data) {
  const SceneSurvey& survey = data.survey;
  switch (item.wave) {
    case Wave::kMeasure:
      return MeasureWork{&survey.tile(item.cell), survey.clearing().Polygons(item.cell)};
    case Wave::kGround:
      return GroundWork{item.cell, survey.records().at(item.cell),
                        CellsInGroundReach(survey.records(), survey.scene().grid, item.cell)};
    case Wave::kCluster:
      return data.clusters.WorkOf(item.number, data.planned);
    case Wave::kLayer:
      return LayerWorkOf(data.planned, item.cell, layer);
    case Wave::kFill:
      return FillWorkOf(data.planned, item.cell, layer, is_wang);
    case Wave::kSmooth:
      return data.smoothing.WorkOf(item.number, data.planned);
    case Wave::kAssemble:
      return AssembleWorkOf(data.planned, item.cell, is_wang);
    default:
      return SurveyWork{&survey.tile(item.cell), survey.clearing().Areas(item.cell)};
  }
}

void PushAll(Wave wave, const std::vector<CellId>& cells, WorkQueue& queue) {
  for (const CellId cell : cells) queue.Push({wave, cell});
}

void BeginPlan(const WaveOptions& options, SceneData& data) {
  data.outcome.cleared = data.survey.clearing().Cleared();
  data.outcome.chosen = options.chosen;
  const PlanOptions plan = data.survey.Complete(options);
  MakeThePlan(options, plan, data.planned);
  data.gaps = FillGaps(data.survey.input().grid, BordersToCompare(data.planned, options));
}

void BeginFill(CellId cell, const WaveOptions& options, SceneData& data, WorkQueue& queue) {
  if (data.begun.insert(cell).second && options.IsFilled(cell)) queue.Push({Wave::kFill, cell});
}

void BeginAssemble(CellId cell, const WaveOptions& options, const SceneData& data, WorkQueue& queue) {
  const bool has_file = !data.survey.tile(cell).path.empty();
  if (options.IsChosen(cell) && (has_file || data.outcome.filled.contains(cell))) {
    queue.writes().Queue(cell);
  } else {
    queue.writes().Dismiss(cell);
  }
}

// Cells that need no surface of a cluster are filled meanwhile.
void BeginClusters(const WaveOptions& options, SceneData& data, WorkQueue& queue) {
  const PlannedScene& scene = data.planned;
  data.clusters = ClusterSampling(scene);
  for (const int32_t cluster : data.clusters.LargestFirst(scene.plan)) {
    queue.Push({Wave::kCluster, data.clusters.FirstCellOf(cluster, scene.plan), cluster});
  }
  for (const auto& [cell, holes] : scene.holes_of) {
    if (!data.clusters.IsAwaitedBy(cell) && CanBeFilled(scene, cell)) BeginFill(cell, options, data, queue);
  }
  if (!options.writes_early()) return;
  for (const SceneTile& tile : data.survey.scene().tiles) {
    if (!scene.holes_of.contains(tile.cell)) BeginAssemble(tile.cell, options, data, queue);
  }
}

void BeginLayer(int32_t layer, const WaveOptions& options, SceneData& data, WorkQueue& queue) {
  for (const auto& [cell, holes] : data.planned.holes_of) {
    if (options.is_wang() && LastLayerOf(data.planned.plan, holes) == layer && options.IsFilled(cell)) {
      BeginFill(cell, options, data, queue);
    } else if (!HolesOfLayer(data.planned, cell, layer).empty()) {
      queue.Push({Wave::kLayer, cell});
    }
  }
}

void BeginSmooth(const WaveOptions& options, SceneData& data, WorkQueue& queue) {
  if (!options.smooths_seams()) return;
  int32_t seam = 0;
  for (const CellId cell : data.smoothing.Begin(data.planned, data.outcome.failures, options)) {
    queue.Push({Wave::kSmooth, cell, seam++});
  }
}

// What is made of the results of a wave when all are there.
void SettleWave(Wave wave, const WaveOptions& options, SceneData& data) {
  if (wave == Wave::kMeasure) data.survey.SettleLevels();
  if (wave == Wave::kLayer) {
    // Wang smooths when all layers are filled; what thin-plate samples so is smoothed at once.
    const double gamma = options.is_wang() ? 0 : options.wang.seam_smoothing;
    SettleLayer(data.planned.plan, data.samples, gamma, data.planned.heights);
    data.samples.clear();
  }
  if (wave == Wave::kSmooth) data.smoothing.Settle(data.planned);
  if (wave == Wave::kAssemble) data.outcome.SetGaps(data.gaps.gaps());
}

// False if the cell has no holes to fill, or they have failed already.
bool FailHoles(CellId cell, const std::string& reason, SceneData& data) {
  const auto holes = data.planned.holes_of.extract(cell);
  if (holes.empty()) return false;
  for (const int32_t h : holes.mapped()) data.outcome.Fail(h, reason);
  return true;
}

// Enters a result, and queues what can be done because of it.
struct ResultTaker {
  const WaveOptions& options;
  SceneData& data;
  WorkQueue& queue;

  absl::Status operator()(TileLevels result) { return Settle(data.survey.Take(result)); }
  absl::Status operator()(TileSurvey result) { return Settle(data.survey.Take(std::move(result))); }
  absl::Status operator()(CellGround result) { return Settle(data.survey.Take(std::move(result))); }
  absl::Status operator()(const ClusterSamples& result) {
    if (absl::Status status = data.clusters.Take(result, data.planned, data.outcome); !status.ok()) return status;
    for (const CellId cell : data.clusters.Release(result.cluster)) {
      if (CanBeFilled(data.planned, cell)) BeginFill(cell, options, data, queue);
    }
    return Settle(absl::OkStatus());
  }
  absl::Status operator()(const LayerSamples& result) { return Settle(AddSamples(result.samples)); }
  absl::Status operator()(const CellFill& result) {
    if (absl::Status status = AddSamples(result.patches.samples); !status.ok()) return status;
    queue.Settle();
    if (!options.IsChosen(result.cell)) return absl::OkStatus();
    if (absl::Status status = data.outcome.Add(result, data.planned.plan); !status.ok()) return status;
    if (options.writes_early()) BeginAssemble(result.cell, options, data, queue);
    return absl::OkStatus();
  }
  absl::Status operator()(const SmoothedSeam& result) { return Settle(data.smoothing.Take(result, data.planned.plan)); }
  absl::Status operator()(TileWritten) {
    queue.writes().Settle(true);
    return absl::OkStatus();
  }
  absl::Status operator()(const LeftWork& left) {
    const auto note = [&](const char* what) { return absl::StrCat(what, ": ", left.reason); };
    if (left.kind == LeftWork::Kind::kTile) {
      FailHoles(left.cell, left.reason, data);
      data.outcome.DropTile({left.cell, note("the tile is not written")});
      queue.writes().Settle(false);
      return absl::OkStatus();
    }
    if (left.kind == LeftWork::Kind::kHoles && FailHoles(left.cell, left.reason, data)) queue.Drop(left.cell);
    if (left.kind == LeftWork::Kind::kGround) {
      data.outcome.impaired.emplace(left.cell, note("all at its rims is taken for ground"));
    }
    if (left.kind == LeftWork::Kind::kSeam) data.outcome.impaired.emplace(left.cell, note("a seam is not smoothed"));
    return Settle(absl::OkStatus());
  }

  absl::Status Settle(absl::Status status) {
    if (status.ok()) queue.Settle();
    return status;
  }
  absl::Status AddSamples(const std::vector<SeamSample>& samples) {
    if (absl::Status status = CheckSamples(data.planned.plan, samples); !status.ok()) return status;
    data.samples.insert(data.samples.end(), samples.begin(), samples.end());
    return absl::OkStatus();
  }
};

// Tells of a step that has a name, unless it was told last.
SceneWaves::StepEnded EachOnce(SceneWaves::StepEnded step_ended) {
  return [told = std::string(), step_ended = std::move(step_ended)](std::string_view step) mutable {
    if (step.empty() || step == told) return;
    told = step;
    if (step_ended) step_ended(step);
  };
}

}  // namespace

SceneWaves::SceneWaves(Scene scene, WaveOptions options, StepEnded step_ended)
    : options_(std::move(options)),
      step_ended_(EachOnce(std::move(step_ended))),
      data_(std::move(scene), options_.plan.water.areas) {
  if (data_.survey.ToMeasure().empty()) step_.wave = Wave::kSurvey;
  Begin();
}

std::optional<SceneWork> SceneWaves::Next() {
  const auto is_over = [&] { return queue_.is_over() && (step_.wave != Wave::kAssemble || queue_.writes().is_over()); };
  while (is_over() && !done()) Advance();
  if (step_.wave == Wave::kCluster && !options_.is_wang() && data_.clusters.IsOver()) step_ended_("sample");
  const std::optional<WorkItem> item = queue_.Next();
  if (!item) return std::nullopt;
  return WorkOf(*item, step_.layer, options_.is_wang(), data_);
}

absl::Status SceneWaves::Take(SceneResult result) {
  return std::visit(ResultTaker{options_, data_, queue_}, std::move(result));
}

CellCounts SceneWaves::cells() const {
  const int64_t tiles = std::ssize(scene().tiles);
  const int64_t all = options_.chosen.empty() ? tiles : std::ssize(options_.chosen);
  return {all, std::max<int64_t>(0, queue_.writes().cells_done() - (tiles - all))};
}

void SceneWaves::Advance() {
  SettleWave(step_.wave, options_, data_);
  step_ended_(EndOf(step_, options_, plan().layers));
  step_ = After(step_, options_, plan().layers);
  Begin();
}

void SceneWaves::Begin() {
  switch (step_.wave) {
    case Wave::kMeasure:
      return PushAll(step_.wave, data_.survey.ToMeasure(), queue_);
    case Wave::kSurvey:
      return PushAll(step_.wave, data_.survey.ToSurvey(), queue_);
    case Wave::kGround:
      return PushAll(step_.wave, data_.survey.ToTellGround(options_), queue_);
    case Wave::kPlan:
      return BeginPlan(options_, data_);
    case Wave::kCluster:
      if (!options_.is_wang()) BeginClusters(options_, data_, queue_);
      return;
    case Wave::kLayer:
      return BeginLayer(step_.layer, options_, data_, queue_);
    case Wave::kFill:
      for (const auto& [cell, holes] : data_.planned.holes_of) BeginFill(cell, options_, data_, queue_);
      return;
    case Wave::kSmooth:
      return BeginSmooth(options_, data_, queue_);
    case Wave::kAssemble:
      for (const SceneTile& tile : scene().tiles) BeginAssemble(tile.cell, options_, data_, queue_);
      return;
    case Wave::kDone:
      return;
  }
}

}  // namespace tilemend
