// The holes of a report as the pages show them: few members of each, the ones to look at first.
#ifndef TILEMEND_COORDINATOR_REPORT_PAGE_HOLES_H_
#define TILEMEND_COORDINATOR_REPORT_PAGE_HOLES_H_

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace tilemend {

// More holes than this are not listed one by one: a table of more is slow in a browser. report.html, the page of a
// coordinator and the review queue list the same holes.
inline constexpr size_t kMostListedHoles = 20000;

// per_hole of the report; an empty list if it has none.
const nlohmann::ordered_json& HoleRowsOf(const nlohmann::ordered_json& report);

// Those of them in cells that were chosen.
std::vector<const nlohmann::ordered_json*> ChosenHoles(const nlohmann::ordered_json& report);

// Whether a row of ChosenHoles is of a hole that was left open.
bool IsLeftOpen(const nlohmann::ordered_json& hole);

// Why a hole is as it is: why it was left, or why it was taken for water.
std::string HoleReasonOf(const nlohmann::ordered_json& hole);

// The cluster of a row of per_hole: filled holes of one are decided on together. -1: of none.
int64_t ClusterOf(const nlohmann::ordered_json& hole);

// Of ChosenHoles those that were left first, then those of the most doubt, then the largest. If there are more than
// `most`, the rest is left out, but a filled hole comes with all filled holes of its cluster: the list may be longer by
// those of the last. Cost: O(n log n).
std::vector<const nlohmann::ordered_json*> ListedHoles(const nlohmann::ordered_json& report, size_t most);

// The same holes in the form that web/src/data.ts declares.
nlohmann::ordered_json PageHoles(const nlohmann::ordered_json& report, size_t most);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_REPORT_PAGE_HOLES_H_
