// The holes of a report as the pages show them: few members of each, the ones to look at first.
#ifndef TILEMEND_COORDINATOR_REPORT_PAGE_HOLES_H_
#define TILEMEND_COORDINATOR_REPORT_PAGE_HOLES_H_

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

namespace tilemend {

// per_hole of the report; an empty list if it has none.
const nlohmann::ordered_json& HoleRowsOf(const nlohmann::ordered_json& report);

// Whether a row of per_hole is of a hole that was left open.
bool IsLeftOpen(const nlohmann::ordered_json& hole);

// Why a hole is as it is: why it was left, or why it was taken for water.
std::string HoleReasonOf(const nlohmann::ordered_json& hole);

// At most `most` holes: those that were left first, then those of the most doubt, then the largest. web/src/data.ts
// declares the form. Cost: O(n log n).
nlohmann::ordered_json PageHoles(const nlohmann::ordered_json& report, size_t most);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_REPORT_PAGE_HOLES_H_
