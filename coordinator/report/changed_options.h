// The options of a report that are not the defaults of jobs, to repeat the job with.
#ifndef TILEMEND_COORDINATOR_REPORT_CHANGED_OPTIONS_H_
#define TILEMEND_COORDINATOR_REPORT_CHANGED_OPTIONS_H_

#include <nlohmann/json.hpp>

namespace tilemend {

// An object of values by the names of the options; empty if the report has no options.
nlohmann::ordered_json ChangedOptions(const nlohmann::ordered_json& report);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_REPORT_CHANGED_OPTIONS_H_
