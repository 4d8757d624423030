#include "coordinator/waves/wave_order.h"

#include <algorithm>
#include <array>

#include "absl/strings/str_cat.h"

namespace tilemend {

bool WaveOptions::TouchesChosen(CellId a, CellId b) const {
  const CellId low{std::max(a.col, b.col) - 1, std::max(a.row, b.row) - 1};
  const CellId high{std::min(a.col, b.col) + 1, std::min(a.row, b.row) + 1};
  for (int32_t col = low.col; col <= high.col; ++col) {
    for (int32_t row = low.row; row <= high.row; ++row) {
      if (IsChosen({col, row})) return true;
    }
  }
  return false;
}

WaveStep After(const WaveStep& step, const WaveOptions& options, int32_t layers) {
  if (step.wave == Wave::kDone || (step.wave == Wave::kPlan && options.plan_only)) return {Wave::kDone};
  if (step.wave == Wave::kLayer && step.layer < layers) return {Wave::kLayer, step.layer + 1};
  return {static_cast<Wave>(static_cast<int>(step.wave) + 1), step.wave == Wave::kCluster ? 1 : step.layer};
}

std::string PhaseOf(const WaveStep& step, const WaveOptions& options, int32_t layers) {
  constexpr std::array kPhases = {"measure levels", "survey", "ground",       "plan",     "sample clusters and fill",
                                  "layer",          "fill",   "smooth seams", "assemble", "assemble"};
  if (step.wave == Wave::kDone && options.plan_only) return "plan";
  if (step.wave != Wave::kLayer) return kPhases[static_cast<size_t>(step.wave)];
  return absl::StrCat(options.is_wang() ? "fill layer " : "sample layer ", step.layer, " of ", layers);
}

std::string_view EndOf(const WaveStep& step, const WaveOptions& options, int32_t layers) {
  constexpr std::array kSteps = {"measure", "survey", "ground", "plan", "", "sample", "fill", "", "assemble", ""};
  constexpr std::array kWangSteps = {"measure", "survey", "ground", "plan",     "",
                                     "layers",  "fill",   "smooth", "assemble", ""};
  if (step.wave == Wave::kLayer && step.layer < layers) return "";
  return (options.is_wang() ? kWangSteps : kSteps)[static_cast<size_t>(step.wave)];
}

}  // namespace tilemend
