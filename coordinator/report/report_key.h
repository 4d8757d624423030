// What a report says of the job that made it.
#ifndef TILEMEND_COORDINATOR_REPORT_REPORT_KEY_H_
#define TILEMEND_COORDINATOR_REPORT_REPORT_KEY_H_

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "common/options/option.h"

namespace tilemend {

// The member `key` of a report.json; "" if it has none, or is no report. Keeps no list of it in memory. Linear.
std::string KeyInReport(const std::string& report);

// The numbers of the holes of a report.json that have a reviewer's decision; none also if it is no report. As
// KeyInReport.
std::set<int32_t> DecidedHolesIn(const std::string& report);

// The job that a report.json is of: the members `scene`, `options` and `files`.
struct ReportedJob {
  std::string scene;
  std::vector<ReportedOption> options;
  std::map<std::string, std::string> files;  // digests, by the options that name the files
};

// None if it has no options, or is no report. As KeyInReport.
std::optional<ReportedJob> JobInReport(const std::string& report);

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_REPORT_REPORT_KEY_H_
