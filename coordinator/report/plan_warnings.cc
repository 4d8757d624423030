#include "coordinator/report/plan_warnings.h"

#include "absl/strings/str_format.h"

namespace tilemend {
namespace {

constexpr size_t kMostAnswers = 10;  // that are warnings: a file may have the waters of a country

}  // namespace

std::vector<std::string> PlanWarnings(const Plan& plan) {
  std::vector<std::string> warnings;
  size_t not_taken = 0;
  for (const WaterAnswer& answer : plan.water_answers) {
    if (!answer.doubt.empty()) warnings.push_back(absl::StrFormat("--water: %s: %s", answer.label, answer.doubt));
    if (answer.reason.empty() || ++not_taken > kMostAnswers) continue;
    warnings.push_back(absl::StrFormat("--water: %s is %s: %s", answer.label,
                                       answer.taken ? "taken for smaller holes only" : "not taken", answer.reason));
  }
  if (not_taken > kMostAnswers) {
    warnings.push_back(absl::StrFormat("--water: %d of %d polygons are not taken; the report lists all (water_areas)",
                                       not_taken, plan.water_answers.size()));
  }
  if (plan.has_polygon && plan.holes.empty() && plan.left.empty()) {
    warnings.emplace_back("no hole lies in the area, so nothing is filled");
  }
  return warnings;
}

}  // namespace tilemend
