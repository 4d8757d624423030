// The message v1::JobSpec by the table of options: defaults, flags, checks, report, and what workers get of it.
//
//   v1::JobSpec spec = WithDefaults(request.spec());
//   TILEMEND_RETURN_IF_ERROR(CheckJob(spec));
//   spec.gradation()  // in its range
#ifndef TILEMEND_COMMON_OPTIONS_JOB_OPTIONS_H_
#define TILEMEND_COMMON_OPTIONS_JOB_OPTIONS_H_

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/options/option.h"
#include "common/util/flags.h"
#include "tilemend/v1/job_spec.pb.h"

namespace tilemend {

// Empty and zero fields without `optional` take their default, as jobs have it. Fields of other releases are dropped.
v1::JobSpec WithDefaults(v1::JobSpec spec);
// Precondition: both are WithDefaults.
bool AreEqual(const v1::JobSpec& a, const v1::JobSpec& b);

// Whether the caller gave an option, even with its default as the value.
using IsGiven = std::function<bool(const Option&)>;

// All below: kInvalidArgument (INVALID_SPEC, metadata `field`) names the first field with a fault, its value and what
// is allowed. Precondition: the spec is WithDefaults.

// Every option of `commands` is in its range and has the options beside it that it needs. Without `is_given` an option
// counts as given if it is present or differs from its default.
absl::Status CheckOptions(const v1::JobSpec& spec, unsigned commands, const IsGiven& is_given = nullptr);

// CheckOptions of jobs, `scene` and `out` are there, and no option of another command is set. All paths are absolute or
// URIs, in UTF-8, and short enough.
absl::Status CheckJob(const v1::JobSpec& spec, const IsGiven& is_given = nullptr);

// The options of `commands` that `texts` gives by field, each as on the command line ("true" for a switch), and
// defaults. Not checked but for numbers and switches. kInvalidArgument for a field that `commands` do not have, with
// the nearest.
absl::StatusOr<v1::JobSpec> SpecFromTexts(const std::map<std::string, std::string>& texts, unsigned commands);

// The options of `commands` that `flags` gives, and defaults of the flags. Not checked but for numbers. Errors name the
// flag.
absl::StatusOr<v1::JobSpec> SpecFromFlags(const Flags& flags, unsigned commands);

// An error of the checks above with the name of the flag in place of the field's.
absl::Status NamedAsFlag(const absl::Status& status);

// What tasks of workers depend on, and nothing else: equal for jobs whose tasks may share results.
v1::JobSpec OptionsForWorkers(const v1::JobSpec& spec);
// kInvalidArgument for options that a coordinator would not send. Cost of all: O(options).
absl::Status CheckOptionsForWorkers(const v1::JobSpec& spec);

// The options of `commands` that the output depends on. Those without effect beside the others are left out, but for
// numbers of growth and water.
std::vector<ReportedOption> ReportedOptions(const v1::JobSpec& spec, unsigned commands);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_OPTIONS_JOB_OPTIONS_H_
