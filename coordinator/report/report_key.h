// What a report says of the job that made it.
#ifndef TILEMEND_COORDINATOR_REPORT_REPORT_KEY_H_
#define TILEMEND_COORDINATOR_REPORT_REPORT_KEY_H_

#include <string>

namespace tilemend {

// The member `key` of a report.json; "" if it has none, or is no report. Keeps no list of it in memory. Linear.
std::string KeyInReport(const std::string& report);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_REPORT_REPORT_KEY_H_
