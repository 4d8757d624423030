// The order of the work on a scene: measure, survey, ground, plan, sample clusters, sample layers, fill, smooth seams,
// assemble. wave_order.h has what follows what; here each wave begins, and results go to the part that they belong to.
#ifndef TILEMEND_COORDINATOR_WAVES_SCENE_WAVES_H_
#define TILEMEND_COORDINATOR_WAVES_SCENE_WAVES_H_

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "coordinator/waves/cluster_sampling.h"
#include "coordinator/waves/fill_gaps.h"
#include "coordinator/waves/pair_seams.h"
#include "coordinator/waves/planned_scene.h"
#include "coordinator/waves/scene_outcome.h"
#include "coordinator/waves/scene_survey.h"
#include "coordinator/waves/scene_work.h"
#include "coordinator/waves/wave_order.h"
#include "coordinator/waves/work_queue.h"

namespace tilemend {

// What is known of a scene. Each part is made of those above it.
struct SceneData {
  SceneData(Scene scene, const std::vector<WaterArea>& areas) : survey(std::move(scene), areas), planned{survey} {}

  SceneSurvey survey;
  PlannedScene planned;
  ClusterSampling clusters;
  std::vector<SeamSample> samples;  // of the present layer
  std::set<CellId> begun;           // cells whose fill was given out, or is to be
  FillGaps gaps;
  PairSmoothing smoothing;
  SceneOutcome outcome;
};

// Of the cells that were chosen.
struct CellCounts {
  int64_t all = 0;
  int64_t done = 0;  // written, or nothing to write; fewer, until what was not chosen is known to have nothing
};

// Gives out the pieces of work of one scene as soon as they can be done, and takes what came of them. It computes the
// plan and the heights of seams itself; all else is done by whoever drives it, in this process or elsewhere:
//
//   while (std::optional<SceneWork> work = waves.Next()) ...;  // do it, or have it done
//   waves.Take(...)                                            // once for each, in any order; then Next again
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
// (StoredRecord). Pure; one thread at a time.
class SceneWaves {
 public:
  // Hears of the end of each step: "measure" (where surface is taken out), "survey", "ground", "plan", "sample"
  // (thin-plate) or "layers" (wang), "fill", "smooth" (wang), "assemble". With thin-plate "sample" ends when the
  // heights of all seams are known; some cells are filled before.
  using StepEnded = std::function<void(std::string_view step)>;

  SceneWaves(Scene scene, WaveOptions options, StepEnded step_ended = {});
  SceneWaves(const SceneWaves&) = delete;
  SceneWaves& operator=(const SceneWaves&) = delete;

  // A piece of work that can be done now; each is given once. None: there is no more until results come, or ever.
  std::optional<SceneWork> Next();
  // kInvalidArgument if it names a hole, a vertex or a cluster that is not there, or if a height or Laplacian is no
  // number. The scene cannot go on then.
  absl::Status Take(SceneResult result);
  // Takes the patches as they are written of the cells that it wants; complete in the outcome when all is done.
  FillGaps& fill_gaps() { return data_.gaps; }

  // Whether all work is given out and its results are there, as of the last Next.
  bool done() const { return step_.wave == Wave::kDone; }
  // What is done now, for people: "survey", "sample layer 1 of 3".
  std::string phase() const { return PhaseOf(step_, options_, plan().layers); }
  CellCounts cells() const;

  const WaveOptions& options() const { return options_; }
  const SceneSurvey& survey() const { return data_.survey; }
  const Scene& scene() const { return survey().scene(); }
  // Empty until all surveys are taken and Next is called.
  const Plan& plan() const { return data_.planned.plan; }
  const SeamHeights& heights() const { return data_.planned.heights; }
  const SceneOutcome& outcome() const { return data_.outcome; }

 private:
  // Starts the wave after the one that is over.
  void Advance();
  void Begin();

  const WaveOptions options_;
  const StepEnded step_ended_;  // each step once
  WaveStep step_;
  WorkQueue queue_;
  SceneData data_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_WAVES_SCENE_WAVES_H_
