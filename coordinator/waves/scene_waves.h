// The order of the work on a scene: measure, survey, ground, plan, sample clusters, sample layers, fill, smooth seams,
// assemble.
#ifndef TILEMEND_COORDINATOR_WAVES_SCENE_WAVES_H_
#define TILEMEND_COORDINATOR_WAVES_SCENE_WAVES_H_

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "common/records/rim_ground.h"
#include "common/records/stored_record.h"
#include "common/records/surface.h"
#include "coordinator/plan/plan.h"
#include "coordinator/plan/seam/seam_heights.h"
#include "coordinator/waves/clearing.h"
#include "coordinator/waves/fill_gaps.h"
#include "coordinator/waves/pair_seams.h"
#include "coordinator/waves/scene_outcome.h"
#include "coordinator/waves/scene_work.h"
#include "coordinator/waves/tile_writes.h"

namespace tilemend {

struct WaveOptions {
  PlanOptions plan;
  Surface surface = kDefaultSurface;
  WangOptions wang;
  bool single_mesh = false;  // the scene is one tile without a grid: its cell is made around it
  bool plan_only = false;    // ends with the plan
  bool write_early = false;  // with thin-plate a tile is assembled once its cell is filled, beside other fills
  std::set<CellId> chosen;   // cells that are filled and written; empty: all
  bool find_objects = true;  // tell ground from objects at the rims; else all is ground. Never in a single mesh
};

// Gives out the pieces of work of one scene as soon as they can be done, and takes what came of them. It computes the
// plan and the heights of seams itself; all else is done by whoever drives it, in this process or elsewhere:
//
//   while (std::optional<SceneWork> work = waves.Next()) ...;  // do it, or have it done
//   waves.Take...(...)                                         // once for each, in any order; then Next again
//
// With the surface wang, cells are filled layer by layer (Wang 2021, 3.3). Each FillWork also samples the seams of its
// cell, and the layer after it begins with these heights. A cell is filled once, in the last layer of its holes. Holes
// of layers before are only sampled in theirs (LayerWork). Closed holes are filled with layer 1. When all cells are
// filled, the seams between cells of one layer are smoothed (3.4). With thin-plate, seams are sampled cluster by
// cluster, the largest first, and what that leaves unknown layer by layer. A cell is filled as soon as its own clusters
// are known. The results do not depend on the order in which they come. Tiles are assembled when all cells are filled,
// or early. Early means that one is given out for each other piece of work, so that disks are busy while surfaces are
// computed.
//
// It holds the plan, the heights of seams and the outcome, but no patch, and of the survey records what is handed over
// (StoredRecord). Pure; one thread at a
// time.
class SceneWaves {
 public:
  // Hears of the end of each step: "measure" (where surface is taken out), "survey", "ground", "plan", "sample"
  // (thin-plate) or "layers" (wang), "fill", "smooth" (wang), "assemble".
  using StepEnded = std::function<void(std::string_view step)>;

  SceneWaves(Scene scene, WaveOptions options, StepEnded step_ended = {});
  SceneWaves(const SceneWaves&) = delete;
  SceneWaves& operator=(const SceneWaves&) = delete;

  // A piece of work that can be done now; each is given once. None: there is no more until results come, or ever.
  std::optional<SceneWork> Next();
  // Whether all work is given out and its results are there, as of the last Next.
  bool done() const { return wave_ == Wave::kDone; }

  // The results. Returns kInvalidArgument if one names a hole, a vertex or a cluster that is not there. The same if a
  // height or Laplacian is no number. The scene cannot go on then.
  absl::Status TakeTallies(CellId cell, std::span<const HeightTally> tallies) {
    --awaited_;
    return clearing_.TakeTallies(cell, tallies);
  }
  // Before TakeSurvey of the cell: as Clearing::TakeCounts.
  absl::Status TakeCleared(CellId cell, std::span<const int64_t> counts) { return clearing_.TakeCounts(cell, counts); }
  void TakeSurvey(CellId cell, StoredRecord record);
  void TakeSurvey(CellId cell, SurveyRecord record);  // keeps it in memory
  absl::Status TakeGround(CellId cell, RimGround rim);
  absl::Status TakeCluster(const ClusterSamples& result);
  absl::Status TakeLayer(const std::vector<SeamSample>& samples);
  absl::Status TakeFill(CellId cell, const CellPatches& result);
  // Of cells that CompareFills, once: the patches as they are written, with the vertices of their work. They are
  // compared with those of neighbours that overlap.
  bool CompareFills(CellId cell) const { return fill_gaps_.Wants(cell); }
  void TakePatches(CellId cell, std::span<const RimVertex> vertices, std::span<const HolePatch> patches);
  absl::Status TakeSmooth(const SmoothedSeam& result);
  void TakeAssemble() { ++cells_done_, writes_.Settle(); }

  // In place of a result of ClusterWork, LayerWork or FillWork: the holes of `cell` stay open, for this reason.
  void LeaveHoles(CellId cell, const std::string& reason);
  // In place of a result of GroundWork: nothing at the boundary of `cell` is taken for an object.
  void LeaveGround(CellId cell, const std::string& reason);
  // In place of a result of SmoothWork: the seams of `cell` that are given out with it keep what its cells gave.
  void LeaveSeam(CellId cell, const std::string& reason);
  // In place of a result of AssembleWork: the tile is not written, and so its holes are not filled.
  void LeaveTile(CellId cell, const std::string& reason);

  const Scene& scene() const { return scene_; }
  const SceneTile& tile(CellId cell) const { return *tiles_.at(cell); }  // of the scene
  const WaveOptions& options() const { return options_; }
  // What is taken out of the tiles. Levels are known once surveys are given out.
  const Clearing& clearing() const { return clearing_; }
  bool IsChosen(CellId cell) const { return options_.chosen.empty() || options_.chosen.contains(cell); }
  // By cell, those that have been taken; once the plan is made also null, for cells without surface.
  const std::map<CellId, StoredRecord>& records() const { return input_.cells; }
  // Empty until all surveys are taken and Next is called.
  const Plan& plan() const { return plan_; }
  const SeamHeights& heights() const { return heights_; }
  const SceneOutcome& outcome() const { return outcome_; }
  // What is done now, for people: "survey", "sample layer 1 of 3".
  const std::string& phase() const { return phase_; }
  // Cells that are written, or have nothing to write.
  int64_t cells_done() const { return cells_done_; }

 private:
  enum class Wave { kMeasure, kSurvey, kGround, kCluster, kLayer, kFill, kSmooth, kAssemble, kDone };
  struct Item {
    Wave wave = Wave::kSurvey;
    CellId cell = {};
    int32_t cluster = -1;  // or, of kSmooth, the seam
  };

  std::optional<Item> NextItem();
  SceneWork WorkOf(const Item& item) const;
  FillWork FillWorkOf(CellId cell) const;
  SmoothWork SmoothWorkOf(int32_t seam) const;
  AssembleWork AssembleWorkOf(CellId cell) const;
  // Starts the wave after the one that has ended.
  void Advance();
  void EndStep(std::string_view step) const {
    if (step_ended_) step_ended_(step);
  }
  void QueueSurveys();
  void QueueGround();
  void MakeThePlan();
  void QueueClusters();
  void QueueLayer(int32_t layer);
  void QueueCellOfLayer(CellId cell, const std::vector<int32_t>& holes);
  void QueueSeams();
  bool is_wang() const { return options_.surface == Surface::kWang; }
  // Whether the cell is filled: it is chosen, or the smoothing of one of its seams moves a vertex of a chosen one.
  bool IsFilled(CellId cell) const;
  // Whether both have a corner in common with a chosen cell: so the seam between them has.
  bool TouchesChosen(CellId a, CellId b) const;
  void QueueFills();
  void QueueFill(CellId cell);
  void QueueAssembles();
  void QueueAssemble(CellId cell);
  bool WritesEarly() const { return options_.write_early && !is_wang(); }
  // Whether the wave has no more to give out or to wait for.
  bool IsOver() const { return ready_.empty() && awaited_ == 0 && (wave_ != Wave::kAssemble || writes_.is_over()); }
  // False if the cell has none, or they have failed already.
  bool FailHoles(CellId cell, const std::string& reason);
  std::vector<int32_t> HolesOfLayer(const std::vector<int32_t>& holes) const;
  bool NeedsHeights(int32_t hole) const;
  bool CanBeFilled(CellId cell) const;

  const Scene scene_;
  WaveOptions options_;  // changed only by the levels that are measured
  Clearing clearing_;
  const StepEnded step_ended_;
  std::map<CellId, const SceneTile*> tiles_;
  Wave wave_ = Wave::kMeasure;
  int32_t layer_ = 0;
  std::deque<Item> ready_;
  int64_t awaited_ = 0;  // results, but of tiles that are written
  TileWrites writes_;
  std::string phase_ = "survey";
  int64_t cells_done_ = 0;

  PlanInput input_;
  Plan plan_;
  SeamHeights heights_;
  std::map<CellId, std::vector<int32_t>> holes_of_;            // those that the plan finds no fault with
  std::map<int32_t, std::vector<int32_t>> holes_of_clusters_;  // of the clusters that are sampled as a whole
  std::map<int32_t, std::set<CellId>> awaiting_;               // by cluster, the cells that await its surface
  std::map<CellId, int32_t> clusters_left_;                    // of which a cell awaits the surface
  std::set<CellId> filling_;                                   // cells with a FillWork
  std::set<CellId> filled_;                                    // cells with a patch
  bool float32_ = false;                                       // some tile is
  std::vector<SeamSample> samples_;                            // of this layer
  std::vector<std::pair<CellPair, PairSeam>> seams_;           // that are smoothed
  SmoothedHeights smoothed_;
  FillGaps fill_gaps_;
  SceneOutcome outcome_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_WAVES_SCENE_WAVES_H_
