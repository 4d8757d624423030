// The order of the waves of work on a scene.
#ifndef TILEMEND_COORDINATOR_WAVES_WAVE_ORDER_H_
#define TILEMEND_COORDINATOR_WAVES_WAVE_ORDER_H_

#include <cstdint>
#include <set>
#include <string>
#include <string_view>

#include "common/records/surface.h"
#include "coordinator/plan/plan.h"

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

  bool is_wang() const { return surface == Surface::kWang; }
  bool smooths_seams() const { return is_wang() && wang.seam_smoothing > 0; }
  bool writes_early() const { return write_early && !is_wang(); }
  bool IsChosen(CellId cell) const { return chosen.empty() || chosen.contains(cell); }
  // Whether both cells have a corner in common with a chosen one: so the seam between them has.
  bool TouchesChosen(CellId a, CellId b) const;
  // Whether the cell is filled: it is chosen, or the smoothing of one of its seams moves a vertex of a chosen one.
  bool IsFilled(CellId cell) const { return IsChosen(cell) || (smooths_seams() && TouchesChosen(cell, cell)); }
};

enum class Wave { kMeasure, kSurvey, kGround, kPlan, kCluster, kLayer, kFill, kSmooth, kAssemble, kDone };

struct WaveStep {
  Wave wave = Wave::kMeasure;
  int32_t layer = 0;  // the present one in kLayer, from 1; later the last
};

// What follows when `step` is over. A wave that has no work is over at once. `layers` are those of the plan.
WaveStep After(const WaveStep& step, const WaveOptions& options, int32_t layers);

// What is done in `step`, for people: "survey", "sample layer 1 of 3".
std::string PhaseOf(const WaveStep& step, const WaveOptions& options, int32_t layers);

// What has ended when `step` is over, as SceneWaves::StepEnded; empty: nothing.
std::string_view EndOf(const WaveStep& step, const WaveOptions& options, int32_t layers);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_WAVES_WAVE_ORDER_H_
