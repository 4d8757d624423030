// What is said of a job that has ended, beside the job itself: its report, and the commands that look at its output.
#ifndef TILEMEND_CLIENT_JOB_END_H_
#define TILEMEND_CLIENT_JOB_END_H_

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

#include "absl/status/statusor.h"
#include "tilemend/v1/jobs.pb.h"

namespace tilemend {

// "check: tilemend check SCENE OUT" with a line's end: the command that compares the output with its scene.
std::string CheckLine(const std::string& scene, const std::string& out);

// Whether the job ended with an output that `tilemend check` can compare.
bool CanBeChecked(const v1::Job& job);

// The report at the job's path, on this machine. Errors of ReadFile; kInvalidArgument if that is no report.
// Precondition: the job has a report.
absl::StatusOr<nlohmann::ordered_json> ReportOf(const v1::Job& job);

// Of a job of a cluster: the summary of its report, and the commands that make the page and check the output. If this
// machine cannot read that report, says where it can be seen. "" of a job without a report. `columns` as of
// SummaryText.
std::string ClusterEndText(const v1::Job& job, size_t columns = 0);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_JOB_END_H_
