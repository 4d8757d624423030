#include "coordinator/report/left_open.h"

#include <algorithm>
#include <cmath>

#include "absl/strings/str_cat.h"
#include "coordinator/plan/types/left_reasons.h"
#include "coordinator/report/json_access.h"

namespace tilemend {
namespace {

bool IsChosen(const SceneReportInput& input, CellId cell) {
  return input.outcome.chosen.empty() || input.outcome.chosen.contains(cell);
}

// Open holes that were given up early have no area yet.
bool IsTiny(const PlannedHole& hole) {
  const bool is_known = hole.kind == HoleKind::kClosed || (hole.area > 0 && hole.failure.empty());
  return is_known && hole.area < kTinyHole;
}

std::string TextOfUncounted(int64_t tiny, int64_t decided) {
  std::string text;
  if (tiny > 0) {
    absl::StrAppend(&text, "; ", tiny, " left open ", tiny == 1 ? "is" : "are", " smaller than ", kTinyHole, " m2 and ",
                    tiny == 1 ? "does" : "do", " not count");
  }
  if (decided > 0) {
    absl::StrAppend(&text, "; ", decided, " left open by decision ", decided == 1 ? "does" : "do", " not count");
  }
  return text;
}

}  // namespace

std::string UncountedText(const SceneReportInput& input) {
  int64_t tiny = 0, decided = 0;
  for (const LeftOpen& left : LeftOf(input)) {
    if (!left.is_hole || left.hole < 0) continue;
    const bool is_decided = left.reason == kLeftByDecision;
    decided += is_decided;
    tiny += !is_decided && IsTiny(input.plan->holes[static_cast<size_t>(left.hole)]);
  }
  return TextOfUncounted(tiny, decided);
}

std::string UncountedText(const nlohmann::ordered_json& report) {
  int64_t tiny = 0, decided = 0;
  for (const nlohmann::ordered_json& hole : Member(report, "per_hole")) {
    const std::string reason = Text(Member(hole, "reason"));
    const nlohmann::ordered_json& area = Member(hole, "area_m2");
    if (Text(Member(hole, "outcome")) != "left" || reason == kNotChosen) continue;
    decided += reason == kLeftByDecision;
    tiny += reason != kLeftByDecision && area.is_number() && std::abs(Number(area)) < kTinyHole;
  }
  return TextOfUncounted(tiny, decided);
}

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
  return !input.outcome.impaired.empty() || std::ranges::any_of(left, [&](const LeftOpen& l) {
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
