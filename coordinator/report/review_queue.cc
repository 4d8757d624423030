#include "coordinator/report/review_queue.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "coordinator/report/hole_evidence.h"
#include "coordinator/report/rounded.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

// The hold-out error of what a hole is filled with; 0 where nothing was held out.
double HoldOutError(const SceneReportInput& input, int32_t h) {
  const int32_t cluster = input.plan->holes[h].cluster;
  const auto& choices = cluster >= 0 ? input.outcome.of_clusters : input.outcome.of_holes;
  const auto choice = choices.find(cluster >= 0 ? cluster : h);
  return choice == choices.end() || choice->second.blocks == 0 ? 0 : choice->second.error;
}

double ErrorIfRight(const SceneReportInput& input, const HoleEvidence& evidence, const ReviewedGroup& group) {
  if (evidence.verdict == HoleEvidence::Verdict::kNoWater) return HoldOutError(input, group.largest);
  const double circle = 2 * std::sqrt(std::numbers::pi * group.area);
  const bool tells_all = evidence.is_of_whole_scene || group.rim <= 0 || group.rim >= circle;
  return evidence.sigma.value_or(0) * (tells_all ? 1 : circle / group.rim);
}

// Of a hole that an area of the user decides on: how far its level is from that of the shore, if it may be a mistake.
double DoubtOfGiven(const Plan& plan, const ReviewedGroup& group) {
  const int32_t water = plan.holes[group.largest].water;
  if (water < 0 || !plan.water[water].level_is_given) return 0;
  const double off = std::abs(plan.water[water].level - plan.water[water].shore_level);
  return off > kLevelOff ? off : 0;
}

bool IsDecided(const Plan& plan, const HoleEvidence& evidence, const ReviewedGroup& group) {
  return evidence.area >= 0 || plan.decisions.contains(group.largest);
}

Json RowOf(const Plan& plan, const HoleEvidence& evidence, const ReviewedGroup& group) {
  const PlannedHole& hole = plan.holes[group.largest];
  Json row = {{"hole", group.largest},
              {"holes", group.holes},
              {"cell", {hole.cell.col, hole.cell.row}},
              {"centre", {Rounded(hole.centre.x(), 1), Rounded(hole.centre.y(), 1)}},
              {"area_m2", Rounded(group.area, 1)}};
  row.update(HoleEvidenceJson(evidence));
  row["doubt_m"] = Rounded(group.doubt, 4);
  row["doubt_m3"] = Rounded(group.doubt * group.area, 3);
  if (group.crossings > 0) row["crossings"] = group.crossings;
  return row;
}

}  // namespace

std::vector<ReviewedGroup> ReviewedGroups(const SceneReportInput& input) {
  const Plan& plan = *input.plan;
  std::vector<ReviewedGroup> groups(plan.evidence.size());
  for (size_t h = 0; h < plan.holes.size(); ++h) {
    const PlannedHole& hole = plan.holes[h];
    const bool is_chosen = input.outcome.chosen.empty() || input.outcome.chosen.contains(hole.cell);
    if (hole.evidence < 0 || !is_chosen) continue;
    ReviewedGroup& group = groups[hole.evidence];
    const auto id = static_cast<int32_t>(h);
    group.holes.push_back(id);
    if (group.largest < 0 || hole.area > plan.holes[group.largest].area) group.largest = id;
    group.area += hole.area;
    group.rim += hole.perimeter;
    if (const auto size = input.outcome.sizes.find(id); size != input.outcome.sizes.end())
      group.crossings += size->second.crossings;
  }
  for (size_t e = 0; e < groups.size(); ++e) {
    const HoleEvidence& evidence = plan.evidence[e];
    if (groups[e].largest < 0) continue;
    if (IsDecided(plan, evidence, groups[e])) {
      groups[e].doubt = DoubtOfGiven(plan, groups[e]);
      continue;
    }
    groups[e].doubt = (1 - evidence.chance_wrong) * ErrorIfRight(input, evidence, groups[e]) +
                      evidence.chance_wrong * evidence.dry_difference;
  }
  return groups;
}

const char* DecisionName(ReviewDecision decision) {
  switch (decision) {
    case ReviewDecision::kNone:
      break;
    case ReviewDecision::kAccept:
      return "accept";
    case ReviewDecision::kWater:
      return "water";
    case ReviewDecision::kGround:
      return "ground";
    case ReviewDecision::kOpen:
      return "open";
  }
  return "";
}

const char* DecisionOn(const Plan& plan, int32_t hole) {
  const auto found = plan.decisions.find(hole);
  return found == plan.decisions.end() ? nullptr : DecisionName(plan.water_answers[found->second].decision);
}

Json ReviewJson(const SceneReportInput& input) {
  const std::vector<ReviewedGroup> groups = ReviewedGroups(input);
  std::vector<size_t> order;
  for (size_t e = 0; e < groups.size(); ++e) {
    if (groups[e].doubt > 0) order.push_back(e);
  }
  std::ranges::stable_sort(order, std::greater<>(), [&](size_t e) { return groups[e].doubt * groups[e].area; });
  Json rows = Json::array();
  for (const size_t e : order) rows.push_back(RowOf(*input.plan, input.plan->evidence[e], groups[e]));
  return rows;
}

}  // namespace tilemend
