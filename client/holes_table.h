// The holes of a report, for people.
#ifndef TILEMEND_CLIENT_HOLES_TABLE_H_
#define TILEMEND_CLIENT_HOLES_TABLE_H_

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

namespace tilemend {

// Each begins with an empty line, and is "" if there is nothing to tell. `columns`: those of a terminal, which tables
// with texts keep to (client/fitted_table.h); 0: none.

// How many holes there are of each kind, how many of them are filled, and their area, with a legend.
std::string KindsText(const nlohmann::ordered_json& report);

// How the filled holes were filled: number and area of each method.
std::string MethodsText(const nlohmann::ordered_json& report);

// The filled holes of clusters of more than 100 m2: what they were filled as, and why. At most kMostListedRows.
std::string LargeHolesText(const nlohmann::ordered_json& report, size_t columns = 0);

// The fills that wait for a decision (coordinator/report/review_queue.h), the most doubtful first. Their count is that
// of the page. At most kMostListedRows.
std::string ReviewText(const nlohmann::ordered_json& report, size_t columns = 0);

// The other fills that a person should look at (coordinator/report/look_at.h).
std::string LookAtText(const nlohmann::ordered_json& report, size_t columns = 0);

// The holes of a plan that are to be filled, the largest first, at most kMostListedRows.
std::string PlannedHolesText(const nlohmann::ordered_json& plan, size_t columns = 0);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_HOLES_TABLE_H_
