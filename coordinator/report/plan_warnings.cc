#include "coordinator/report/plan_warnings.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <set>
#include <utility>

#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "absl/strings/str_join.h"
#include "common/util/text.h"
#include "coordinator/plan/types/left_reasons.h"
#include "coordinator/plan/types/meet_tolerance.h"

namespace tilemend {
namespace {

constexpr size_t kMostAnswers = 10;     // that are warnings: a file may have the waters of a country
constexpr size_t kMostDecisions = 100;  // the same of decisions, each of which a reviewer made

// For each body of water that goes on in a hole that is left at the rim of an unknown area, its first hole. They share
// a stretch of seam, which the one has forwards and the other backwards.
std::vector<int32_t> WaterAtUnknownRim(const Plan& plan) {
  std::set<std::pair<int32_t, int32_t>> left;
  for (const PlannedHole& hole : plan.holes) {
    if (hole.failure != kReachesUnknownRim) continue;
    for (const RimSegment& s : hole.segments) left.insert({s.to, s.from});
  }
  const auto reaches_rim = [&](int32_t hole) {
    return std::ranges::any_of(plan.holes[hole].segments, [&](const RimSegment& s) {
      return left.contains({s.from, s.to});
    });
  };
  std::vector<int32_t> first_holes;
  for (const WaterBody& body : plan.water) {
    if (body.kind != BodyKind::kWater) continue;
    if (!left.empty() && std::ranges::any_of(body.holes, reaches_rim)) first_holes.push_back(body.holes.front());
  }
  return first_holes;
}

void WarnOfWaterAtUnknownRim(const Plan& plan, std::vector<std::string>& warnings) {
  std::vector<int32_t> holes = WaterAtUnknownRim(plan);
  if (holes.empty()) return;
  const size_t bodies = holes.size();
  holes.resize(std::min(bodies, kMostAnswers));
  warnings.push_back(absl::StrFormat(
      "water reaches the rim of the area, which is not known, so levels of %d of %d rivers and lakes are doubtful "
      "(at %s %s%s): their shores in the cells at the rim do not count; --area FILE says what the area is",
      bodies, plan.water.size(), bodies == 1 ? "hole" : "holes", absl::StrJoin(holes, ", "),
      bodies > holes.size() ? " and others" : ""));
}

// "polygon feature 3", "decision on hole 4".
std::string NameOf(const WaterAnswer& answer) {
  return answer.decision == ReviewDecision::kNone ? "polygon " + answer.label : answer.label;
}

// Of what the numbers and the cut of the tiles make impossible, and of an area without holes.
void WarnOfTiles(const Plan& plan, std::vector<std::string>& warnings) {
  if (!plan.single_mesh && plan.lattice_step > kMeetTolerance) {
    warnings.push_back(absl::StrFormat(
        "the tiles have single-precision numbers far from 0, which are %g m apart: heights are not finer than that; "
        "export with a local origin or in double precision",
        plan.lattice_step));
  }
  if (plan.remarks.tiny_cell > 0) {
    warnings.push_back(absl::StrFormat(
        "the cells are %g wide, and numbers are taken for metres: convert degrees or kilometres to metres first",
        plan.remarks.tiny_cell));
  }
  if (const ImpossibleHeights& heights = plan.remarks.impossible_heights; heights.tiles > 0) {
    warnings.push_back(absl::StrFormat(
        "heights of %d %s lie further apart than any on Earth, in cell %s from %.5g to %.5g m: a value for no data may "
        "have become vertices; they count as surface, so take them out of the tiles first",
        heights.tiles, heights.tiles == 1 ? "tile" : "tiles", ToString(heights.first), heights.lowest,
        heights.highest));
  }
  if (plan.remarks.turn != 0) {
    warnings.push_back(absl::StrFormat(
        "the tiles are turned by %.2f degrees against the scene's axes, so holes over their borders may be missed, and "
        "others found that are none; export them in the frame that they were cut in",
        plan.remarks.turn * 180 / std::numbers::pi));
  }
  if (plan.remarks.has_polygon && plan.holes.empty() && plan.left.empty()) {
    warnings.emplace_back("no hole lies in the area, so nothing is filled");
  }
}

absl::Status CheckDecisions(const Plan& plan) {
  size_t decisions = 0;
  const WaterAnswer* over_hole = nullptr;
  for (const WaterAnswer& answer : plan.water_answers) {
    if (answer.decision == ReviewDecision::kNone) continue;
    if (answer.taken) return absl::OkStatus();
    if (answer.is_over_hole && over_hole == nullptr) over_hole = &answer;
    ++decisions;
  }
  if (decisions == 0) return absl::OkStatus();
  if (over_hole != nullptr) {
    return absl::InvalidArgumentError(absl::StrFormat("none of the %d decisions has an effect; %s: %s", decisions,
                                                      over_hole->label, over_hole->reason));
  }
  return absl::InvalidArgumentError(
      absl::StrFormat("none of the %d decisions applies: no hole lies under %s; is the file of another scene?",
                      decisions, decisions == 1 ? "it" : "them"));
}

}  // namespace

std::vector<std::string> PlanWarnings(const Plan& plan) {
  std::vector<std::string> warnings;
  std::vector<std::string> doubts, doubts_of_decisions;
  size_t polygons = 0, not_taken = 0, decisions_not_taken = 0;
  for (const WaterAnswer& answer : plan.water_answers) {
    const bool is_decision = answer.decision != ReviewDecision::kNone;
    polygons += is_decision ? 0 : 1;
    if (!answer.doubt.empty()) {
      std::vector<std::string>& list = is_decision ? doubts_of_decisions : doubts;
      list.push_back(absl::StrFormat("%s: %s", NameOf(answer), answer.doubt));
    }
    if (answer.reason.empty()) continue;
    if (is_decision ? ++decisions_not_taken > kMostDecisions : ++not_taken > kMostAnswers) continue;
    warnings.push_back(absl::StrFormat("%s is %s: %s", NameOf(answer),
                                       answer.taken ? "taken for smaller holes only" : "not taken", answer.reason));
  }
  if (not_taken > kMostAnswers) {
    warnings.push_back(
        absl::StrFormat("%d of %d polygons are not taken; the report lists all (water_areas)", not_taken, polygons));
  }
  if (decisions_not_taken > kMostDecisions) {
    warnings.push_back(
        absl::StrFormat("%d decisions are not taken; the report lists all (water_areas)", decisions_not_taken));
  }
  KeepFirst(kMostAnswers, "doubts of polygons (water_areas in the report)", doubts);
  std::ranges::move(doubts, std::back_inserter(warnings));
  KeepFirst(kMostDecisions, "doubts of decisions (water_areas in the report)", doubts_of_decisions);
  std::ranges::move(doubts_of_decisions, std::back_inserter(warnings));
  WarnOfWaterAtUnknownRim(plan, warnings);
  WarnOfTiles(plan, warnings);
  return warnings;
}

absl::Status CheckAreas(const Plan& plan) {
  for (const WaterAnswer& answer : plan.water_answers) {
    if (!answer.has_cleared || answer.taken || !absl::StrContains(answer.reason, kReachesUnknownRim)) continue;
    return absl::InvalidArgumentError(
        absl::StrCat(answer.label,
                     ": what it takes out reaches the rim of the area, which is not known, and would stay open; give "
                     "--area FILE (`tilemend inspect SCENE --propose-area FILE` draws one)"));
  }
  return CheckDecisions(plan);
}

}  // namespace tilemend
