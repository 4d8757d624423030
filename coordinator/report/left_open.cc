#include "coordinator/report/left_open.h"

#include <algorithm>

#include "coordinator/plan/types/left_reasons.h"

namespace tilemend {
namespace {

constexpr char kNotChosen[] = "in a cell that was not chosen";

bool IsChosen(const SceneReportInput& input, CellId cell) {
  return input.outcome.chosen.empty() || input.outcome.chosen.contains(cell);
}

// Open holes that were given up early have no area yet.
bool IsTiny(const PlannedHole& hole) {
  const bool is_known = hole.kind == HoleKind::kClosed || (hole.area > 0 && hole.failure.empty());
  return is_known && hole.area < kTinyHole;
}

}  // namespace

std::vector<LeftOpen> LeftOf(const SceneReportInput& input) {
  std::vector<LeftOpen> left = input.plan->left;
  // They come in the order in which they were lost.
  std::vector<LeftOpen> unwritten = input.outcome.unwritten;
  std::ranges::sort(unwritten, {}, &LeftOpen::cell);
  left.insert(left.end(), unwritten.begin(), unwritten.end());
  for (const auto& [hole, reason] : input.outcome.failures) {
    const PlannedHole& planned = input.plan->holes[hole];
    left.push_back({planned.cell, reason, hole, planned.boundary_vertices});
  }
  std::erase_if(left, [&](const LeftOpen& l) { return !IsChosen(input, l.cell); });
  return left;
}

bool SomeHolesLeft(const SceneReportInput& input) {
  const std::vector<LeftOpen> left = LeftOf(input);
  return std::ranges::any_of(left, &LeftOpen::is_hole) ||
         std::ranges::any_of(input.plan->holes, [](const PlannedHole& h) { return !h.failure.empty(); });
}

bool IsPartial(const SceneReportInput& input) {
  const std::vector<LeftOpen> left = LeftOf(input);
  return std::ranges::any_of(left, [&](const LeftOpen& l) {
    return l.is_hole && l.reason != kLeftByDecision &&
           (l.hole < 0 || !IsTiny(input.plan->holes[static_cast<size_t>(l.hole)]));
  });
}

std::string FailureOf(const SceneReportInput& input, int32_t hole) {
  if (!IsChosen(input, input.plan->holes[hole].cell)) return kNotChosen;
  const auto it = input.outcome.failures.find(hole);
  return it != input.outcome.failures.end() ? it->second : input.plan->holes[hole].failure;
}

}  // namespace tilemend
