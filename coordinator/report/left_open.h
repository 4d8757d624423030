// What a report says is left open.
#ifndef TILEMEND_COORDINATOR_REPORT_LEFT_OPEN_H_
#define TILEMEND_COORDINATOR_REPORT_LEFT_OPEN_H_

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "coordinator/plan/types/left_reasons.h"
#include "coordinator/report/scene_report.h"

namespace tilemend {

// FailureOf a hole in a cell that was not chosen.
inline constexpr char kNotChosen[] = "in a cell that was not chosen";

// Whether a row of per_hole in report.json is of a cell that was chosen.
bool IsInChosenCell(const nlohmann::ordered_json& hole);

// What became of a hole, by its FailureOf: "filled", "left", or "not chosen" if it is in a cell that was not chosen.
const char* OutcomeOf(const std::string& failure);

// Of the plan, then of its outcome, in the cells that were chosen.
std::vector<LeftOpen> LeftOf(const SceneReportInput& input);

// Whether holes, or boundary edges that form no loop, are left open, so that the result is partial. Outlines of
// detached pieces and of a mesh itself are none.
bool SomeHolesLeft(const SceneReportInput& input);

// A hole of less does not make an output partial; the report lists it.
inline constexpr double kTinyHole = 0.05;  // m2

// The same of a scene, whose lengths are metres: holes of less than kTinyHole, and those that a reviewer wants open, do
// not count. An area that is not known counts, and so does a cell that was filled without some result.
bool IsPartial(const SceneReportInput& input);

// What holes left open IsPartial does not count, after "30 of 32 holes filled". If some count: "; 2 left open, 1 of
// them smaller than 0.05 m2, which does not count". If none counts: "; 2 left open are smaller than 0.05 m2 and do not
// count; 1 left open by decision does not count". "" if all count, or none is left.
std::string UncountedText(const SceneReportInput& input);

// The same from report.json.
std::string UncountedText(const nlohmann::ordered_json& report);

// Whether a row of per_hole in report.json is left open and IsPartial counts it.
bool CountsAsLeft(const nlohmann::ordered_json& hole);

// Why a hole is not filled; "" if it is.
std::string FailureOf(const SceneReportInput& input, int32_t hole);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_REPORT_LEFT_OPEN_H_
