// Whether a report agrees with itself.
#ifndef TILEMEND_CLIENT_REPORT_AGREEMENT_H_
#define TILEMEND_CLIENT_REPORT_AGREEMENT_H_

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace tilemend {

// What contradicts itself in a report.json, each as a line. The holes that `per_hole` has as filled water must be those
// in the rows of `water`, at the same level. The numbers of holes must be those of the rows. Members that are missing
// or of another type count as empty. O(n log n).
std::vector<std::string> ReportContradictions(const nlohmann::ordered_json& report);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_REPORT_AGREEMENT_H_
