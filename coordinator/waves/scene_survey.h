// What is known of the tiles of a scene: the first three waves find it, and the plan is made of it.
#ifndef TILEMEND_COORDINATOR_WAVES_SCENE_SURVEY_H_
#define TILEMEND_COORDINATOR_WAVES_SCENE_SURVEY_H_

#include <map>
#include <vector>

#include "absl/status/status.h"
#include "coordinator/plan/plan.h"
#include "coordinator/waves/clearing.h"
#include "coordinator/waves/scene_work.h"
#include "coordinator/waves/wave_order.h"

namespace tilemend {

// Results are kInvalidArgument if they do not fit the tile. Pure; one thread at a time.
class SceneSurvey {
 public:
  SceneSurvey(Scene scene, const std::vector<WaterArea>& areas);
  SceneSurvey(const SceneSurvey&) = delete;
  SceneSurvey& operator=(const SceneSurvey&) = delete;

  const Scene& scene() const { return scene_; }
  const SceneTile& tile(CellId cell) const { return *tiles_.at(cell); }
  // What is taken out of the tiles. Levels are known once surveys are given out.
  const Clearing& clearing() const { return clearing_; }
  // By cell, those that have been taken; once the plan is made also null, for cells without surface.
  const std::map<CellId, StoredRecord>& records() const { return input_.cells; }
  const PlanInput& input() const { return input_; }

  // The cells that these waves begin with.
  std::vector<CellId> ToMeasure() const;
  std::vector<CellId> ToSurvey() const;
  std::vector<CellId> ToTellGround(const WaveOptions& options) const;

  absl::Status Take(const TileLevels& result) { return clearing_.TakeTallies(result.cell, result.tallies); }
  // All levels have been taken.
  void SettleLevels() { clearing_.Settle(areas_); }
  absl::Status Take(TileSurvey result);
  absl::Status Take(CellGround result);

  // All has been taken. What the plan is to be made with, for which input() is complete then.
  PlanOptions Complete(const WaveOptions& options);

 private:
  const Scene scene_;
  std::vector<WaterArea> areas_;  // with the levels that are measured
  Clearing clearing_;
  std::map<CellId, const SceneTile*> tiles_;
  PlanInput input_;
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_WAVES_SCENE_SURVEY_H_
