#include "coordinator/report/look_at.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_format.h"
#include "absl/strings/str_join.h"
#include "common/grid/water_profile.h"
#include "coordinator/report/hole_evidence.h"
#include "coordinator/report/left_open.h"
#include "coordinator/report/rounded.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;
using Verdict = HoleEvidence::Verdict;

constexpr double kSureLevel = 0.25;  // metres of sigma: what a surveyor expects of a level

// The filled holes that one evidence is about.
struct Judged {
  std::vector<int32_t> holes;  // into Plan::holes
  int32_t largest = -1;        // of them
  double area = 0;             // m2
  double rim = 0;              // metres
};

std::vector<Judged> JudgedOf(const SceneReportInput& input) {
  const Plan& plan = *input.plan;
  std::vector<Judged> judged(plan.evidence.size());
  for (size_t h = 0; h < plan.holes.size(); ++h) {
    const PlannedHole& hole = plan.holes[h];
    const auto id = static_cast<int32_t>(h);
    if (hole.evidence < 0 || !FailureOf(input, id).empty()) continue;
    Judged& j = judged[hole.evidence];
    j.holes.push_back(id);
    if (j.largest < 0 || hole.area > plan.holes[j.largest].area) j.largest = id;
    j.area += hole.area;
    j.rim += hole.perimeter;
  }
  return judged;
}

// The answer to the decision by which a reviewer accepted the fill; null if there is none.
const WaterAnswer* AcceptanceOf(const Plan& plan, const Judged& judged) {
  const auto found = plan.decisions.find(judged.largest);
  if (found == plan.decisions.end()) return nullptr;
  const WaterAnswer& answer = plan.water_answers[found->second];
  return answer.decision == ReviewDecision::kAccept ? &answer : nullptr;
}

std::string WhyLookAt(const Plan& plan, const HoleEvidence& evidence, const Judged& judged) {
  if (const WaterAnswer* accepted = AcceptanceOf(plan, judged)) return accepted->doubt;
  std::vector<std::string> why;
  const bool is_flat = evidence.verdict != Verdict::kNoWater, is_decided = evidence.area >= 0;
  const bool is_large = judged.area >= kWaterProfiles[0].least_lake;
  const double circle = 2 * std::sqrt(std::numbers::pi * judged.area);
  if (is_flat && evidence.sigma.value_or(0) > kSureLevel) {
    why.push_back(absl::StrFormat(
        "the standard deviation of its level is %.2f m; a polygon with level_m can set the level", *evidence.sigma));
  }
  if (is_decided) {
    const std::string& doubt = plan.water_answers[evidence.area].doubt;
    if (!doubt.empty()) why.push_back(doubt);
    return absl::StrJoin(why, "; ");
  }
  if (is_flat && !evidence.is_of_whole_scene && judged.rim < circle) {
    why.push_back(absl::StrFormat("only %.0f m of rim tell the level of %.0f m2; the rest ends at the edge of the area",
                                  judged.rim, judged.area));
  }
  if (is_large && evidence.verdict == Verdict::kLevelGround) {
    why.emplace_back("it is large and level, but not called water; a polygon can say that it is");
  }
  if (is_large && !is_flat) why.emplace_back("it is large and filled as ground; if it is water, a polygon can say so");
  return absl::StrJoin(why, "; ");
}

}  // namespace

Json LookAtJson(const SceneReportInput& input) {
  const Plan& plan = *input.plan;
  std::vector<std::pair<Judged, Json>> found;
  const std::vector<Judged> judged = JudgedOf(input);
  for (size_t e = 0; e < judged.size(); ++e) {
    const HoleEvidence& evidence = plan.evidence[e];
    if (judged[e].largest < 0) continue;
    const std::string why = WhyLookAt(plan, evidence, judged[e]);
    if (why.empty()) continue;
    const PlannedHole& hole = plan.holes[judged[e].largest];
    Json row = {{"hole", judged[e].largest},
                {"holes", judged[e].holes},
                {"cell", {hole.cell.col, hole.cell.row}},
                {"centre", {Rounded(hole.centre.x(), 1), Rounded(hole.centre.y(), 1)}},
                {"area_m2", Rounded(judged[e].area, 1)}};
    row.update(HoleEvidenceJson(evidence));
    row.erase("reason");
    row["why"] = why;
    found.emplace_back(judged[e], std::move(row));
  }
  std::ranges::stable_sort(found, std::greater<>(), [](const auto& f) { return f.first.area; });
  Json rows = Json::array();
  for (auto& [of, row] : found) rows.push_back(std::move(row));
  return rows;
}

}  // namespace tilemend
