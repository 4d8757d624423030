// report.json for people.
#ifndef TILEMEND_CLIENT_REPORT_TEXT_H_
#define TILEMEND_CLIENT_REPORT_TEXT_H_

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

namespace tilemend {

// `columns`: those of a terminal, which the tables of holes and water keep to; 0: none.

// What one looks at first: warnings, what was filled, water, tiles that do not fit, what is left. Tables with legends,
// short however large the scene is. Begins with an empty line.
std::string SummaryText(const nlohmann::ordered_json& report, size_t columns = 0);

// Which scene, when and how; the summary; then figures of the work: triangles, tensions, time, memory.
std::string ReportText(const nlohmann::ordered_json& report, size_t columns = 0);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_REPORT_TEXT_H_
